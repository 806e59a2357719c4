/* What an engine needs beside asperity.h: contacts in quick succession, materials by type, and its
 * own words between those of the description. The walls of LIGGGHTS, LAMMPS and OpenFOAM use these
 * two headers; a small engine with one grain and a plane is examples/c_program/engine.c. Stays the
 * same within a major version.
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
/* The parts of a wall. The surface of a smooth wall is NULL. */
const asp_surface *asp_wall_surface(const asp_wall *wall);
const asp_spread_model *asp_wall_spread(const asp_wall *wall);
const char *asp_spread_name(const asp_spread_model *model);

/* ---- surface --------------------------------------------------------------------------------- */
/* ASP_ERANGE and a message if d_p is beyond the range of the size law. Call it at setup. */
asp_code asp_surface_check(const asp_surface *surface, double d_p, asp_error *error);

/* The wall's numbers; NaN if a wall given by sigma has none. phi_r: eq. 9. */
double asp_surface_r_q(const asp_surface *surface);
double asp_surface_lambda_c(const asp_surface *surface);
double asp_surface_lambda_along(const asp_surface *surface); /* lambda_c if there is no lay */
double asp_surface_phi_r(const asp_surface *surface);

/* ---- description ----------------------------------------------------------------------------- */
/* Parse one clause at a time. Use this if your script mixes wall keywords with its own. Begin with
 * asp_description_parse(""). read parses the clause at the beginning of words[count]; *taken is its
 * number of words, 0 if the first word is in `others`, a list of the caller's own words with blanks
 * between (NULL: none). After an error every call fails with it. Call check after the last clause.
 */
asp_code asp_description_read(asp_description *description, int count, const char *const *words,
                              const char *others, int *taken, asp_error *error);
asp_code asp_description_check(const asp_description *description, asp_error *error);

/* ASP_EARG and a message if the law with these parameters does not work for bodies. */
asp_code asp_description_check_bodies(const asp_description *description, asp_error *error);

/* ASP_EARG and a message if `temperature` or `soften` has no effect. have_own: the particles have
 * temperatures of their own. */
asp_code asp_description_check_heat(const asp_description *description, bool have_own,
                                    asp_error *error);

/* Makes `plane` the default tilt, for two dimensions. Call it before a clause is read. */
void asp_description_default_plane(asp_description *description);

/* True if the description has this keyword. */
bool asp_description_is_given(const asp_description *description, const char *keyword);

const asp_rebound_law *asp_description_rebound(const asp_description *description);
bool asp_rebound_needs_pair(const asp_rebound_law *law); /* materials, or asp_particle.pair */

/* States that particles come with their own pairs: the description may lack materials. */
void asp_description_expect_pairs(asp_description *description);
const char *asp_material_name(const asp_material *material);

/* Characters of the first clause of a canonical text, with the blank behind it; 0 at its end. */
size_t asp_description_clause(const char *text);

/* A wall and its particles. NULL or 0 marks what is not known yet. */
typedef struct asp_check_input {
  const asp_description *words;
  const asp_wall *wall;
  double d_least;                  /* diameter of the smallest particle */
  const asp_particle *largest;     /* its diameter, density, and pair */
  const asp_material *material[2]; /* of the particle and of the wall */
  double reserved[4];
} asp_check_input;

/* Lines for a log, each after an LF: the surface and its tilts for the smallest and the largest
 * particles; if `largest` has a pair, instead the speeds along the normal above which these
 * particles yield and below which they stick. Writes at most `size` characters with the NUL, and
 * returns how many characters there are without it. */
size_t asp_wall_report(const asp_check_input *input, char *text, size_t size);

/* Run check number `index`, from 0, for input that is valid but suspicious. Writes a warning to
 * `text`, at most `size` characters, "" if there is none; false past the last check. Checks:
 * heights over 1000 diameters; hardness under 50 MPa; R_Sm without its sampling length; odd heights
 * of a file that the library read; a file too coarse for the smallest particles; a law or model
 * that does not suit the wall; density more than 1 % off the material's; yield stress above a tenth
 * of the composite modulus; adhesion that holds every impact. */
bool asp_warning(const asp_check_input *input, int index, char *text, size_t size);

/* ---- files of measured walls ----------------------------------------------------------------- */
/* Reads a measured profile (one row of heights) or a map. `meter`: the caller's units per meter. A
 * profile is text in columns (position, height; separated by commas, semicolons, tabs or spaces;
 * after any header), or the first row of SDF in ASCII (ISO 25178-71). The names right above
 * the numbers state columns and units (`x_um,z_um`, `Lateral um,Raw Micrometer`, `x [mm]; z [nm]`,
 * or units in a line of their own below the names); two columns without names are positions and
 * heights. Positions may be rounded: the spacing comes from all of them. They may fall or repeat
 * (heights are averaged); unequal spacing is resampled by straight lines; text after the data is
 * ignored. Columns X and Y beside the heights give the distance along a straight line. A column
 * named depth or Tiefe counts downward and is turned over.
 *
 * A map is SDF, text or binary; a matrix of heights, a line a row, with the head of Gwyddion's; or
 * lines of x, y, z on a grid, in columns of these names or in exactly three columns. Closed formats
 * are refused with the name of a free program that converts them.
 *
 * Several profiles of one wall are a list of files, `A,B,C`, unless a file of that name exists.
 * They may differ in length, spacing and unit. Each is leveled by itself and nothing is joined at
 * their ends; the wall's numbers and its faces are those of all, each by its length.
 *
 * The mean line or plane is subtracted; bad points and gaps are refused. `text`, of `size`
 * characters (NULL: none): one sentence about points, form, positions and columns. *doubt:
 * ASP_EDATA and a message if the heights are doubtful: dust (points far off all neighbors),
 * heights in few levels, or cut off at an end of their range; else ASP_OK. It may be NULL. For
 * other files the command `asperity surface` has options. */
asp_heights *asp_heights_read(const char *path, bool is_map, double meter, char *text, size_t size,
                              asp_error *doubt, asp_error *error);

/* ---- contacts in quick succession ------------------------------------------------------------ */
/* A wall is made of faces that have a length. A particle that has met one meets the next after its
 * contact has moved by that length along the wall; until then it meets the mean wall. A particle
 * that stays at the wall lies in a valley where it is slow: it is held there until what pushes it
 * along the wall exceeds `start` times what presses it. See models.md. */

/* The length of a face for a particle whose contact has moved along `along` (any length, projected
 * on the wall); on a wall with a lay by the ellipse of the two correlation lengths. 0 on a smooth
 * wall, which has no faces. */
double asp_wall_face_length(const asp_wall *wall, const asp_particle *particle,
                            const double along[3], const double n[3]);

/* A contact on the mean wall, for a particle that has already met its face. Like asp_wall_impact on
 * a smooth wall. */
asp_code asp_wall_impact_mean(const asp_wall *wall, const asp_particle *particle,
                              const double v1[3], const double n[3], const asp_key *key,
                              asp_impact *impact);

/* A contact of a particle that stays at the wall with the next face on its way. Only v1 along the
 * wall counts. The face opposes the motion and is drawn from the visible faces at grazing
 * incidence, whatever the spread model; behind a trough sharper than the particle it comes down to
 * the face. Like asp_wall_impact, but with 0 hits and unchanged v2 where the particle meets no
 * face: the wall is smooth, or `press`, the acceleration toward the wall, is too small to keep it
 * on the surface. */
asp_code asp_wall_impact_grazing(const asp_wall *wall, const asp_particle *particle,
                                 const double v1[3], const double n[3], double press,
                                 const asp_key *key, asp_impact *impact);

/* A valley in which a particle lies. */
typedef struct asp_valley {
  double start;  /* tangent of the slope at which the particle starts to move */
  double height; /* of the lowest crest around it over its bottom: a length */
  /* Position of a particle that has fallen in: its distance from the crest ahead over that from
   * crest to crest; and how far the valley rises across that distance. */
  double place, rise;
  double reserved[2];
} asp_valley;

/* Draws a valley; `along` as above, for the lay. Zeros on a smooth wall. */
asp_valley asp_wall_valley(const asp_wall *wall, const asp_particle *particle,
                           const double along[3], const double n[3], const asp_key *key);

/* The flow along the wall takes a deposit away (`deposit freeze remove`) when the integral of
 * `rate` over the time since it stuck exceeds `most`: an exponential number, drawn with the
 * deposit's adhesion from the key. rate 0: no flow, or unknown adhesion. */
typedef struct asp_removal {
  double rate, most;
  double reserved[2];
} asp_removal;
asp_removal asp_wall_removal(const asp_wall *wall, const asp_particle *particle,
                             const asp_key *key);

/* The probability with which an impact of a particle sticks by its viscosity (`deposit freeze
 * viscosity`), besides what the law holds; 0 on a wall without. temperature: its own, K; 0: the
 * description's. ASP_ERANGE and a message if the wall's curves do not hold there; an impact then
 * returns this code, too, and the particle keeps its velocity. share may be NULL. */
asp_code asp_wall_sticking(const asp_wall *wall, double temperature, double *share,
                           asp_error *error);

#if defined(__GNUC__)
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
