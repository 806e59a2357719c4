/* Coefficients of restitution of an impact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/frame.h"
#include "wall/impact.h"

asp_coefficients asp_impact_coefficients(const double v1[3], const double n[3],
                                         const asp_impact *impact) {
  vec before = load(v1), after = load(impact->v2);
  frame f = frame_of(before, load(n));
  double n2 = dot(after, f.n), along = dot(after, f.along) * f.per_length;
  asp_coefficients c = {.v1 = sqrt(dot(before, before)),
                        .alpha1 = atan2(fmax(f.v_n, 0), f.v_t),
                        .v2 = sqrt(dot(after, after))};
  if (impact->outcome == ASP_DEPOSIT) {
    c.cor_v = c.cor_alpha = c.cor_n = c.cor_t = c.cor_v_space = c.cor_alpha_space = NAN;
    return c;
  }
  double along_space = sqrt(fmax(0, c.v2 * c.v2 - n2 * n2));
  if (!has_direction(&f))
    along = along_space;
  c.alpha2 = atan2(n2, along);
  c.cor_v = aspi_quotient(hypot(n2, along), c.v1, ASPI_ROUNDING_PART, c.v1);
  c.cor_alpha = aspi_quotient(c.alpha2, c.alpha1, ASPI_ROUNDING_PART, 1);
  c.cor_v_space = aspi_quotient(c.v2, c.v1, ASPI_ROUNDING_PART, c.v1);
  c.cor_alpha_space = aspi_quotient(atan2(n2, along_space), c.alpha1, ASPI_ROUNDING_PART, 1);
  c.cor_n = aspi_quotient(n2, f.v_n, ASPI_ROUNDING_PART, c.v1);
  c.cor_t = aspi_quotient(along, f.v_t, ASPI_NORMAL_PART, c.v1);
  return c;
}

void asp_impacts_coefficients(size_t n, const double *v1, const double *normals,
                              const asp_impact *impacts, asp_coefficients *coefficients) {
  for (size_t i = 0; i < n; i++)
    coefficients[i] = asp_impact_coefficients(v1 + 3 * i, normals + 3 * i, &impacts[i]);
}
