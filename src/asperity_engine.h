/* What an engine needs beside asperity.h to let particles fly at a wall: one that steps in time,
 * with contacts that follow each other, materials by type, and its own words between those of the
 * description. The walls of LIGGGHTS, LAMMPS and OpenFOAM use these two headers; a small engine
 * with one grain and a plane is examples/c_program/engine.c. Stays the same within a major version.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_ENGINE_H
#define ASPERITY_ENGINE_H

#include "asperity.h"

#ifdef __cplusplus
extern "C" {
#endif
#if defined(__GNUC__)
#pragma GCC visibility push(default)
#endif

typedef struct asp_surface asp_surface;
typedef struct asp_spread_model asp_spread_model;
typedef struct asp_rebound_law asp_rebound_law;

/* ---- wall ------------------------------------------------------------------------------------ */
/* The parts of a wall. The surface is NULL where it is smooth. */
const asp_surface *asp_wall_surface(const asp_wall *wall);
const asp_spread_model *asp_wall_spread(const asp_wall *wall);
const char *asp_spread_name(const asp_spread_model *model);

/* ---- surface --------------------------------------------------------------------------------- */
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

/* The bins of a wall made from a profile; none for other walls. 0 <= bin < asp_surface_bins(). */
int asp_surface_bins(const asp_surface *surface);
double asp_surface_bin_d_p(const asp_surface *surface, int bin);

/* The standard error of the mean tilt at an impact angle of 2 degrees that comes from the length of
 * the profile, as a part of sigma: about 1.1 over the root of the length in correlation lengths. 0
 * for walls without a profile. */
double asp_surface_uncertainty(const asp_surface *surface);

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
bool asp_rebound_needs_pair(const asp_rebound_law *law); /* materials, or asp_particle.pair */

/* Particles come with their own pairs: a wall can be made whose law needs one and whose words have
 * none. */
void asp_description_expect_pairs(asp_description *description);
const char *asp_material_name(const asp_material *material);

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

#if defined(__GNUC__)
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
