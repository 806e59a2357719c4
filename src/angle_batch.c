/* The angles of many contacts at once, in vector loops; see angle.h. */
#include "angle.h"
#include "simd.h"

ASP_EACH_MACHINE
void asp_angle_n(size_t n, const double *rise, const double *run, double *angle) {
#pragma omp simd
  for (size_t i = 0; i < n; i++)
    angle[i] = asp_angle(rise[i], run[i]);
}

ASP_EACH_MACHINE
void asp_turn_n(size_t n, const double *x, double *sine, double *cosine) {
#pragma omp simd
  for (size_t i = 0; i < n; i++) {
    asp_turn turn = asp_turn_by(x[i]);
    sine[i] = turn.sine;
    cosine[i] = turn.cosine;
  }
}
