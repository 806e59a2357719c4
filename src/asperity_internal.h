/* What the fixes, the command and the Python module need besides asperity.h. Not installed: it may
 * change with every version.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_FRONT_H
#define ASPERITY_FRONT_H

#include "asperity.h"

#ifdef __cplusplus
extern "C" {
#endif
#if defined(__GNUC__)
#pragma GCC visibility push(default)
#endif

enum { ASP_BINS_MAX = 256 }; /* diameters that a measured wall can be prepared for */

typedef struct asp_surface asp_surface;
typedef struct asp_spread_model asp_spread_model;
typedef struct asp_rebound_law asp_rebound_law;

/* ---- wall ------------------------------------------------------------------------------------ */
/* The parts of a wall. The surface is NULL where it is smooth. */
const asp_surface *asp_wall_surface(const asp_wall *wall);
const asp_spread_model *asp_wall_spread(const asp_wall *wall);

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
const char *asp_spread_name(const asp_spread_model *model);
const char *asp_spread_summary(const asp_spread_model *model);
const char *asp_spread_source(const asp_spread_model *model);

/* ---- rebound laws ---------------------------------------------------------------------------- */
int asp_rebound_count(void);
const asp_rebound_law *asp_rebound_at(int index);
const asp_rebound_law *asp_rebound_find(const char *name, asp_error *error);
const char *asp_rebound_name(const asp_rebound_law *law);
bool asp_rebound_needs_pair(const asp_rebound_law *law); /* asp_particle.pair must be given */

/* A parameter of a law, which asp_description_set sets. */
typedef struct asp_parameter {
  const char *name;
  const char *unit; /* the kind of its unit, as "stress"; "" for none */
  double fallback;  /* the value where the user gives none */
  double least, most;
  const char *text;    /* what it is, its source, and whether the original was seen */
  const char *keyword; /* script word that introduces this parameter; consecutive ones may share it.
                          NULL: it follows the law's name */
  const char *words;   /* those for the values 0, 1 ..., separated by blanks; NULL: a number */
} asp_parameter;

/* ---- materials ------------------------------------------------------------------------------- */
/* The presets. */
int asp_material_count(void); /* of the presets */
const asp_material *asp_material_at(int index);
const char *asp_material_name(const asp_material *material);

/* ---- files of measured walls ----------------------------------------------------------------- */
/* Reads a measured profile, one row of heights, or a map, in a unit of which a meter has `meter`. A
 * profile is text in columns (position, height; separated by commas, semicolons, tabs or spaces;
 * after any header), or SDF in ASCII (ISO 25178-71), whose first row it is. The names right above
 * the numbers state columns and units (`x_um,z_um`, `Lateral um,Raw Micrometer`, `x [mm]; z [nm]`,
 * or units in a line of their own below the names); two columns without names are positions and
 * heights. Positions may be rounded: the spacing comes from all of them. They may fall, and repeat
 * themselves (heights are averaged); unequal spacing is resampled by straight lines; text after the
 * data is ignored. Columns X and Y beside the heights give the distance along a straight line. A
 * column named depth or Tiefe counts downward and is turned over.
 *
 * A map is SDF, text or binary; a matrix of heights, a line a row, with the head of Gwyddion's; or
 * lines of x, y, z on a grid, in columns of these names, or where there are three columns. Closed
 * formats are refused with the name of a free program that converts them.
 *
 * The mean line or plane is taken out; bad points and gaps are refused. `text`, of `size`
 * characters (NULL: none): one sentence about points, form, positions and columns. *doubt:
 * ASP_EDATA and a message where the heights are doubtful: dust (points far off all neighbors),
 * heights in few levels, or cut off at an end of their range; else ASP_OK. The command `asperity
 * surface` has options for all other files. */
asp_heights *asp_heights_read(const char *path, bool is_map, double meter, char *text, size_t size,
                              asp_error *doubt, asp_error *error);

/* ---- description ----------------------------------------------------------------------------- */
/* Parses clause by clause, for a caller with other words in between: begin with
 * asp_description_parse(""). read takes the clause at the beginning of words[count]; *taken is its
 * number of words, 0 if the first one is in `others`, the caller's own words with blanks between
 * (NULL: none). After an error every call fails with it. check, after the last clause, looks at all
 * of them together. */
asp_code asp_description_read(asp_description *description, int count, const char *const *words,
                              const char *others, int *taken, asp_error *error);
asp_code asp_description_check(const asp_description *description, asp_error *error);

/* ASP_EARG and a message where the law with its parameters has no meaning for bodies. */
asp_code asp_description_check_bodies(const asp_description *description, asp_error *error);

/* ASP_EARG and a message where the law needs a pair, and the words have not the materials of one, a
 * particle and a wall, or no yield stress. */
asp_code asp_description_check_pair(const asp_description *description, asp_error *error);

/* ASP_EARG and a message where a word on heat has no effect on particles that have a temperature of
 * their own, or have none. */
asp_code asp_description_check_heat(const asp_description *description, bool have_own,
                                    asp_error *error);

/* The share of the yield stress that the temperature of the words leaves; 1: all of it. */
double asp_description_softening(const asp_description *description);

/* Makes `plane` the default tilt, for two dimensions; before a clause is read. */
void asp_description_default_plane(asp_description *description);

/* True if the words have this keyword. */
bool asp_description_is_given(const asp_description *description, const char *keyword);

const asp_rebound_law *asp_description_rebound(const asp_description *description);

/* The length of the first clause of a canonical text with the blank behind it; 0 at its end. */
size_t asp_description_clause(const char *text);

/* A wall and what flies at it. Unknown are: a wall that is not made yet, materials, and a pair that
 * are NULL, diameters and a density that are 0. */
typedef struct asp_question {
  const asp_description *words;
  const asp_wall *wall;
  double d_least;                  /* diameter of the smallest particle */
  const asp_particle *largest;     /* its diameter, density, and pair */
  const asp_material *material[2]; /* of the particle and of the wall */
} asp_question;

/* Asks the index-th question about what is allowed and still looks like a mistake, from 0: the
 * doubt to `text`, at most `size` characters, "" if there is none; false past the last question.
 * Asked are heights over 1000 diameters, a hardness under 50 MPa, R_Sm without its sampling length;
 * odd heights of a file that the library read, a file that tells little about the smallest
 * particles; a law or a model that does not suit the wall; a density more than 1 % off that of the
 * material, a yield stress above a tenth of the composite modulus, and adhesion that holds every
 * impact. */
bool asp_doubt(const asp_question *question, int index, char *text, size_t size);

/* The speed below which a normal impact of the particle sticks to the mean wall: 0 where the law
 * needs no pair, where nothing is held, or below 0.001 m/s; INFINITY where every impact up to 10
 * km/s sticks. `particle` has the density, the pair, and the diameter. 0 in units without a known
 * speed. */
double asp_description_capture_speed(const asp_description *description,
                                     const asp_particle *particle);

/* ---- surface --------------------------------------------------------------------------------- */
/* The rms slope of a rough wall as a sphere of diameter d_p meets it. */

/* ASP_ERANGE and a message when d_p is beyond the range in which the slope was checked: to be
 * called at setup, before the contacts begin. */
asp_code asp_surface_check(const asp_surface *surface, double d_p, asp_error *error);

/* The wall's own numbers, NaN for those that a wall by sigma does not have: phi_r (eq. 9), and the
 * unfiltered rms slope: sqrt(2) phi_r of a Gaussian wall. */
double asp_surface_r_q(const asp_surface *surface);
double asp_surface_lambda_c(const asp_surface *surface);
double asp_surface_lambda_along(const asp_surface *surface); /* lambda_c where there is no lay */
double asp_surface_phi_r(const asp_surface *surface);
double asp_surface_slope_rms(const asp_surface *surface);

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

/* The bins of a wall made from a profile; none for other walls. 0 <= bin < asp_surface_bins(). */
int asp_surface_bins(const asp_surface *surface);
double asp_surface_bin_d_p(const asp_surface *surface, int bin);

/* The standard error of the mean tilt at an impact angle of 2 degrees that comes from the length of
 * the profile, as a part of sigma: about 1.1 over the root of the length in correlation lengths. 0
 * for walls without a profile. */
double asp_surface_uncertainty(const asp_surface *surface);

/* How far a face of the surface reaches, across its lay: the mean way along the mean plane from
 * one face that looks at a particle to the next, pi r_q/s = (pi/sqrt(2)) lambda_c (Smith's
 * density of crossings at the mean height). A surface that is given by its slope alone looks the
 * same to particles of all sizes: its faces are as long as the particle, d_p. */
double asp_surface_face_length(const asp_surface *surface, double d_p);

/* n contacts as asp_wall_impacts makes them, and the likelihood ratios of their draws on other
 * walls: weights[n][n_others], the density of a contact's faces and flights there over that on its
 * own wall, with mean 1. Weighted means over contacts are those on the other wall. ASP_EARG if a
 * wall is smooth, its model has no density (traced), or it has `collisions single`; ASP_ERANGE if
 * another wall is more than 1.4 times as steep. */
asp_code asp_wall_weights(const asp_wall *wall, size_t n, const asp_particle *particles,
                          const double *v1, const double *normals, const asp_key *keys,
                          size_t n_others, const asp_wall *const *others, asp_impact *impacts,
                          double *weights, asp_error *error);

/* The largest ratio of rms slopes that a particle meets on the other wall and on this one, across
 * the lay and along it; both are rough. */
double asp_wall_steeper(const asp_wall *wall, const asp_wall *other, const asp_particle *particle,
                        const double n[3]);

/* ---- contacts that follow each other closely ------------------------------------------------- */
/* A wall is made of faces that have a length. A particle that has met one meets the next after its
 * contact has moved by that length along the wall; until then it meets the mean wall. A particle
 * that stays at the wall lies in a valley where it is slow: it is held there until what pushes it
 * along the wall exceeds `start` times what presses it. See models.md. */

/* The length of a face for a particle whose contact has moved along `along` (any length, projected
 * on the wall); on a wall with a lay by the ellipse of the two correlation lengths. 0 on a smooth
 * wall, which has no faces. */
double asp_wall_face_length(const asp_wall *wall, const asp_particle *particle,
                            const double along[3], const double n[3]);

/* The contact of a particle that has met its face already: by the law, on the mean wall. As
 * asp_wall_impact, of which it is the case of a smooth wall. */
asp_code asp_wall_impact_mean(const asp_wall *wall, const asp_particle *particle,
                              const double v1[3], const double n[3], const asp_key *key,
                              asp_impact *impact);

/* The contact of a particle that stays at the wall with the next face on its way: v1 counts as it
 * is along the wall, and the face looks against it, with the law of visible faces at grazing
 * incidence whatever the spread model; behind a trough that is sharper than the particle it comes
 * down to the face. False, and nothing is written, where the particle meets no face: the wall is
 * smooth, or `press`, the acceleration that presses the particle to the wall, keeps it on its way
 * over the face. Otherwise as asp_wall_impact. */
bool asp_wall_impact_grazing(const asp_wall *wall, const asp_particle *particle, const double v1[3],
                             const double n[3], double press, const asp_key *key,
                             asp_impact *impact);

/* A valley in which a particle lies. */
typedef struct asp_valley {
  double start;  /* tangent of the slope at which the particle starts to move */
  double height; /* of the lowest crest around it over its bottom: a length */
  /* Where a particle is that has fallen into it: its way from the crest ahead, over that from crest
   * to crest; and how far the valley rises across that way. */
  double place, rise;
} asp_valley;

/* Draws a valley; `along` as above, for the lay. Zeros on a smooth wall. */
asp_valley asp_wall_valley(const asp_wall *wall, const asp_particle *particle,
                           const double along[3], const double n[3], const asp_key *key);

/* The flow along the wall takes a deposit away (`deposit freeze remove`) when the integral of
 * `rate` over the time since it stuck exceeds `most`: an exponential number, drawn with the
 * deposit's adhesion by the key. rate 0: there is no flow, or nothing is known of the adhesion. */
typedef struct asp_removal {
  double rate, most;
} asp_removal;
asp_removal asp_wall_removal(const asp_wall *wall, const asp_particle *particle,
                             const asp_key *key);

/* Bytes of a struct, by its name without asp_, for a caller that lays it out by itself: body,
 * coefficients, error, impact, key, lay, particle, question. 0 for another name. */
size_t asp_struct_size(const char *name);

#if defined(__GNUC__)
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif

#endif
