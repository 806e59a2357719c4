/* The form of a table of impacts: which of its columns give the coefficients; see scatter.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/tolerances.h"
#include "base/units.h"
#include "cli/scatter.h"

#define FORMS                                                                                      \
  "impacts are columns alpha1,v1,alpha2_plane,v2_plane or alpha1,cor_v_plane and "                 \
  "cor_alpha_plane or alpha2_plane (one camera), both alike of _space, or v1_n,v1_t,v2_n,v2_t or " \
  "v1_n,v2_n (a drop: --columns v1_n=1,v2_n=2) or cor_n,cor_t or alpha1,alpha2_plane alone; "      \
  "means are cor_n_mean,cor_n_sd,cor_t_mean,cor_t_sd or alpha2_plane_mean,alpha2_plane_sd"

static aspi_projection projection_of(const cli_scatter *t, int speed, int angle) {
  int projection = ASPI_IN_PLANE;
  while (projection < ASPI_PROJECTIONS &&
         !(cli_scatter_has(t, speed + projection) &&
           (cli_scatter_has(t, angle + projection) || cli_scatter_has(t, ALPHA2 + projection))))
    projection++;
  return (aspi_projection)projection;
}

cli_scatter_form cli_scatter_find_form(cli_scatter *t) {
  cli_scatter_form f = {.means = cli_scatter_has(t, MEAN) || cli_scatter_has(t, MEAN + COR_T) ||
                                 cli_scatter_has(t, MEAN + REBOUND_ANGLE),
                        .points = cli_scatter_has(t, POINT) || cli_scatter_has(t, POINT + COR_T),
                        .components = cli_scatter_has(t, V1_N) && cli_scatter_has(t, V2_N) &&
                                      cli_scatter_has(t, V1_T) == cli_scatter_has(t, V2_T),
                        .normal = !cli_scatter_has(t, V1_T),
                        .ratios = projection_of(t, COR_V, COR_ALPHA),
                        .velocities = cli_scatter_has(t, V1) ? projection_of(t, V2, ALPHA2)
                                                             : ASPI_PROJECTIONS};
  bool impacts =
      f.points || f.components || f.ratios < ASPI_PROJECTIONS || f.velocities < ASPI_PROJECTIONS;
  bool other = false; /* of the velocity */
  for (int c = V2; c < V1_N; c++)
    other = other || cli_scatter_has(t, c);
  int projection = impacts || f.means || other ? ASPI_PROJECTIONS : ASPI_IN_PLANE;
  while (projection < ASPI_PROJECTIONS && !cli_scatter_has(t, ALPHA2 + projection))
    projection++;
  f.angles = (aspi_projection)projection;
  impacts = impacts || projection < ASPI_PROJECTIONS;
  f.psi = cli_scatter_has(t, PSI) && cli_scatter_has(t, PSI + 1);
  if (!f.components && !cli_scatter_has(t, ALPHA1) && !f.psi && cli_scatter_has(t, V1) &&
      (cli_scatter_has(t, POINT) || cli_scatter_has(t, MEAN)))
    f.drops = true;
  if (f.drops)
    cli_warn("%s: speeds and coefficients without angles are taken as impacts along the normal",
             t->table->text.path);
  if (!f.components && !f.psi && !f.drops)
    cli_scatter_need(t, ALPHA1,
                     "; it is the impact angle from the wall (--from normal turns those from its "
                     "normal), also called impact_angle, alpha_in or theta_i; --columns alpha1=1 "
                     "takes one of another name; " FORMS);
  if (impacts == f.means)
    cli_bad_usage("%s: %s; " FORMS "; --columns cor_n=2 takes one of another name",
                  t->table->text.path,
                  impacts ? "both impacts and means" : "neither impacts nor means");
  return f;
}

/* The coefficients of the components of both velocities. */
static void take_velocities(double n1, double t1, double n2, double t2, aspi_scatter_row *row) {
  row->cor[COR_N] = aspi_quotient(n2, n1, ASPI_ROUNDING_PART, hypot(n1, t1));
  row->cor[COR_T] = aspi_quotient(t2, t1, ASPI_NORMAL_PART, hypot(n1, t1));
}

aspi_scatter_row cli_scatter_row_of(const cli_scatter_form *f, const double v[]) {
  double a1 = aspi_radians(v[ALPHA1]);
  aspi_scatter_row row = {.degrees = fmin(90, v[ALPHA1]),
                          .v1 = v[V1],
                          .d_p = isnan(v[D_P]) ? 2 * v[RADIUS] : v[D_P],
                          .n = v[COUNT]};
  for (int k = 0; k < ASPI_COMPARED; k++) {
    row.cor[k] = f->means ? v[MEAN + k] : k < COR_BOTH ? v[POINT + k] : NAN;
    row.sd[k] = v[SD + k];
    row.se[k] = v[SE + k];
  }
  if (f->psi) { /* a homogeneous sphere: 1/(1 + 5/2) of the change at the contact is the center's */
    row.degrees = aspi_degrees(atan2(1, v[PSI]));
    row.cor[COR_T] = 5. / 7 + 2. / 7 * v[PSI + 1] / v[PSI];
  } else if (f->drops) {
    row.degrees = 90;
  }
  if (f->angles < ASPI_PROJECTIONS)
    row.cor[REBOUND_ANGLE] = fabs(v[ALPHA2 + f->angles]);
  if (f->means || f->points || f->angles < ASPI_PROJECTIONS)
    return row;
  if (f->components) {
    double t1 = f->normal ? 0 : v[V1_T], t2 = f->normal ? 0 : v[V2_T];
    row.degrees = aspi_degrees(atan2(fabs(v[V1_N]), fabs(t1)));
    row.v1 = hypot(v[V1_N], t1);
    take_velocities(fabs(v[V1_N]), t1, fabs(v[V2_N]), t2, &row);
    return row;
  }
  bool ratios = f->ratios < ASPI_PROJECTIONS;
  double a2 = aspi_radians(v[ALPHA2 + (ratios ? f->ratios : f->velocities)]);
  a2 = ratios && isnan(a2) ? v[COR_ALPHA + f->ratios] * a1 : a2;
  double share = ratios ? v[COR_V + f->ratios] : v[V2 + f->velocities] / v[V1];
  take_velocities(sin(a1), cos(a1), share * sin(a2), share * cos(a2), &row);
  return row;
}
