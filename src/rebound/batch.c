/* The law of bons.c for many hits at once, in a vector loop. */
#include "rebound/bons.h"
#include "simd.h"

static inline void run(const asp_bons_constants *p, const asp_hits *hits, size_t n, bool rate,
                       double *v_n2, double *v_t2, double *near) {
  const asp_bons_constants c = *p;
  const double *n1 = hits->v_n1, *t1 = hits->v_t1, *d_p = hits->d_p, *density = hits->density;
  const double *modulus = hits->modulus, *yield = hits->yield_stress;
  const double *energy = hits->surface_energy, *friction = hits->friction;
#pragma omp simd
  for (size_t i = 0; i < n; i++) {
    asp_pair pair = {modulus[i], yield[i], energy[i], friction[i]};
    asp_bons_answer answer =
        asp_bons_plain(&c, n1[i], t1[i], d_p[i], density[i], pair, rate, true, 0.5);
    v_n2[i] = answer.v_n2;
    v_t2[i] = answer.v_t2;
    near[i] = answer.near ? 1 : 0;
  }
}

ASP_EACH_MACHINE
void asp_bons_n(const asp_bons_constants *p, const asp_hits *hits, size_t n, double *v_n2,
                double *v_t2, double *near) {
  if (p->yield_rate > 0)
    run(p, hits, n, true, v_n2, v_t2, near);
  else
    run(p, hits, n, false, v_n2, v_t2, near);
}
