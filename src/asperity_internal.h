/* What the command, the Python module and the tests need besides asperity_engine.h. Not installed:
 * it may change with every version.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_INTERNAL_H
#define ASPERITY_INTERNAL_H

#include "asperity_engine.h"

#ifdef __cplusplus
extern "C" {
#endif
#if defined(__GNUC__)
#pragma GCC visibility push(default)
#endif

enum { ASP_BINS_MAX = 256 }; /* diameters that a measured wall can be prepared for */

/* ---- spread models --------------------------------------------------------------------------- */
/* The distribution of the tilt delta_alpha of the face that is hit, cut to |delta_alpha| < 90
 * degrees (a height function has no overhangs, and a particle hits only faces turned toward it)
 * and normalized. */

/* All models, in a fixed order: 0 <= index < asp_spread_count(); the first is `none`, that of
 * smooth walls, which is no word of a description. find: by name; NULL and a message that lists the
 * names if there is none. */
int asp_spread_count(void);
const asp_spread_model *asp_spread_at(int index);
const asp_spread_model *asp_spread_find(const char *name, asp_error *error);

/* ---- rebound laws ---------------------------------------------------------------------------- */
int asp_rebound_count(void);
const asp_rebound_law *asp_rebound_at(int index);
const asp_rebound_law *asp_rebound_find(const char *name, asp_error *error);
const char *asp_rebound_name(const asp_rebound_law *law);

/* ---- materials ------------------------------------------------------------------------------- */
/* The presets. */
int asp_material_count(void); /* of the presets */
const asp_material *asp_material_at(int index);

/* ---- description ----------------------------------------------------------------------------- */
/* ASP_EARG and a message if the law needs a pair and the description lacks its two materials or the
 * yield stress. */
asp_code asp_description_check_pair(const asp_description *description, asp_error *error);

/* Yield stress at the description's temperature over the cold one. */
double asp_description_softening(const asp_description *description);

/* The speed below which a normal impact of the particle sticks to the mean wall: 0 if the law
 * needs no pair, if nothing sticks, or below 0.001 m/s; INFINITY if every impact up to 10 km/s
 * sticks. `particle` has the density, the pair, and the diameter. 0 if the units are unknown. */
double asp_description_capture_speed(const asp_description *description,
                                     const asp_particle *particle);

/* ---- weights --------------------------------------------------------------------------------- */
/* n contacts like asp_wall_impacts, and the likelihood ratios of their draws on other walls:
 * weights[n][n_others], the probability density of a contact's faces and flights on the other wall
 * over its density on this one, with mean 1. Weighted means over contacts are means on the other
 * wall. ASP_EARG if a wall is smooth, its model has no density (traced), or it has `collisions
 * single`; ASP_ERANGE if another wall is more than 1.4 times as steep. */
asp_code asp_wall_weights(const asp_wall *wall, size_t n, const asp_particle *particles,
                          const double *v1, const double *normals, const asp_key *keys,
                          size_t n_others, const asp_wall *const *others, asp_impact *impacts,
                          double *weights, asp_error *error);

/* The largest ratio of rms slopes that a particle meets on the other wall and on this one, across
 * the lay and along it; both are rough. */
double asp_wall_steeper(const asp_wall *wall, const asp_wall *other, const asp_particle *particle,
                        const double n[3]);

/* ---- surface --------------------------------------------------------------------------------- */
/* Without the size filter, sqrt(2) phi_r for a Gaussian wall. */
double asp_surface_slope_rms(const asp_surface *surface);

/* The bins of a wall made from a profile; none for other walls. 0 <= bin < asp_surface_bins(). */
int asp_surface_bins(const asp_surface *surface);
double asp_surface_bin_d_p(const asp_surface *surface, int bin);

/* The standard error of the mean tilt at an impact angle of 2 degrees that comes from the length of
 * all profiles, as a part of sigma: about 1.1 over the root of it in correlation lengths. 0
 * for walls without a profile. */
double asp_surface_uncertainty(const asp_surface *surface);

/* The rms slope of a rough wall as a sphere of diameter d_p meets it. */

/* kappa = sqrt(3) d_p r_q / lambda_c^2: the particle's radius times the rms curvature of the
 * profile, across the lay. Under about 0.4 the particle follows the profile and its size does not
 * matter. */
double asp_surface_kappa(const asp_surface *surface, double d_p);

/* The rms slope s_eff of the profile, across the lay, closed by a disc of diameter d_p (>= 0, the
 * surface's unit): for a Gaussian wall of phi_r <= 0.25 s (1 + 0.92 kappa^3)^(-1/6), within 5 % of
 * generated profiles for kappa up to 16. Walls with tilt `plane` take it. Those with `isotropic`
 * take that of a sphere on a surface, along the axis i across the lay or along it and with the
 * other one as j: s_i (1 + kappa_i^2 (0.92 kappa_i + 0.37 kappa_j))^(-1/6), within 2 % for kappa up
 * to 4 and small slopes, 4 % high at 8; at phi_r 0.25 5 % low for kappa 1 to 1.5. */
double asp_surface_slope(const asp_surface *surface, double d_p);

/* A Gaussian wall by its two numbers, both in one unit of length and both greater than zero: r_q,
 * the rms height, and lambda_c, the lag at which the autocorrelation exp(-x^2/lambda_c^2) has
 * fallen to 1/e; filtered by a disc. phi_r = r_q/lambda_c up to 1. */
asp_surface *asp_surface_create(double r_q, double lambda_c, asp_error *error);

/* A Gaussian wall with a lay, as ground and milled ones: the autocorrelation falls to 1/e at
 * lambda_c across the lay and at lambda_along along it, with ellipses as contours; phi_r up to 0.25
 * both ways. Equal lengths are a wall without a lay. */
asp_surface *asp_surface_create_lay(double r_q, double lambda_c, double lambda_along,
                                    asp_error *error);

/* A wall by its measured profile, which need not outlive it: the rms slopes of the profile closed
 * by discs of `bins` diameters from d_min to d_max at equal ratios (one bin: the geometric mean),
 * monotone between them, the end values beyond. r_q and lambda_c are the profile's, by the 1/e lag.
 * spacing <= d_min <= d_max <= length; bins 1 to ASP_BINS_MAX. */
asp_surface *asp_surface_create_profile(const asp_heights *profile, double d_min, double d_max,
                                        int bins, asp_error *error);

void asp_surface_free(asp_surface *surface);

/* How far a face of the surface reaches, across its lay: the mean way along the mean plane from
 * one face that looks at a particle to the next, pi r_q/s = (pi/sqrt(2)) lambda_c (Smith's
 * density of crossings at the mean height). A surface that is given by its slope alone looks the
 * same to particles of all sizes: its faces are as long as the particle, d_p. */
double asp_surface_face_length(const asp_surface *surface, double d_p);

/* Bytes of a struct, by its name without asp_, for a caller that lays it out by itself: body,
 * coefficients, error, impact, key, particle, check_input. 0 for another name. */
size_t asp_struct_size(const char *name);

#if defined(__GNUC__)
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif

#endif
