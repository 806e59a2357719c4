/* The law of bons.c for many hits at once, in a vector loop. */
#include "rebound/bons.h"
#include "simd.h"

/* The particle and pair of hit i. */
static inline asp_bons_grain grain_at(const asp_bons_constants *p, const asp_hits *hits, size_t i,
                                      bool rate) {
  asp_pair pair = {hits->modulus[i], hits->yield_stress[i], hits->surface_energy[i],
                   hits->friction[i]};
  return asp_bons_grain_of(p, hits->d_p[i], hits->density[i], pair, rate);
}

static inline void run(const asp_bons_constants *p, const asp_hits *hits, size_t n, bool rate,
                       bool alike, double *v_n2, double *v_t2, double *near) {
  const asp_bons_constants c = *p;
  const asp_hits h = *hits;
  const asp_bons_grain first = grain_at(&c, &h, 0, rate);
#pragma omp simd
  for (size_t i = 0; i < n; i++) {
    asp_bons_grain grain = alike ? first : grain_at(&c, &h, i, rate);
    asp_bons_answer answer = asp_bons_plain(&c, h.v_n1[i], h.v_t1[i], grain, rate, true, 0.5);
    v_n2[i] = answer.v_n2;
    v_t2[i] = answer.v_t2;
    near[i] = answer.near ? 1 : 0;
  }
}

ASP_EACH_MACHINE
void asp_bons_n(const asp_bons_constants *p, const asp_hits *hits, size_t n, double *v_n2,
                double *v_t2, double *near) {
  if (n == 0)
    return;
  if (p->yield_rate > 0)
    run(p, hits, n, true, false, v_n2, v_t2, near);
  else if (hits->alike)
    run(p, hits, n, false, true, v_n2, v_t2, near);
  else
    run(p, hits, n, false, false, v_n2, v_t2, near);
}
