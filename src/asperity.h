/* asperity: rough walls for particle simulation. The one public header of the core.
 *
 * A wall is a surface (its roughness), a spread model (the distribution of the face that a particle
 * hits at an impact angle), and a rebound law (velocity after the hit). asp_wall_impact() combines
 * the three for one contact. Units: any consistent set; angles are radians,
 * measured from the wall plane (90 degrees is normal impact); velocities are relative to the wall.
 * A positive tilt delta_alpha turns the wall toward the particle (luff), so that the local impact
 * angle is alpha1 + delta_alpha.
 *
 * Objects from ..._create are freed by ..._free (NULL is allowed). Threads may share an object as
 * long as none of them changes it. Setup allocates, a contact does not. The library prints nothing,
 * never exits, and keeps no state of its own. A call that can fail takes an asp_error, or NULL, for
 * the message; it returns a code, or NULL for an object. Returned strings live as long as the
 * object that they belong to. The few structs that a program holds itself change with the major
 * version only; their `reserved` members are 0.
 *
 *   asp_error error;
 *   asp_wall *wall = asp_wall_from_text("surface rq 5um lambda_c 40um materials quartz 304-ss",
 *                                       0, 0, &error);
 *   asp_particle grain = {0};
 *   grain.d_p = 1e-5;
 *   grain.density = 2650;
 *   asp_key key = {asp_wall_seed(wall), asp_key_wall("plate"), 1, 1, 0};
 *   double v1[3] = {93.97, 0, -34.20}, n[3] = {0, 0, 1};
 *   asp_impact impact;
 *   asp_wall_impact(wall, &grain, v1, n, &key, &impact);
 *   asp_wall_free(wall);
 *
 * The numbered equations are those of Altmeppen, Sommerfeld, Koch & Staudacher (2020), "An
 * analytical approach to estimate the effect of surface roughness on particle rebound".
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_H
#define ASPERITY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
#if defined(__GNUC__)
#pragma GCC visibility push(default)
#endif

/* The version of this header, and as "1.0.0" that of the library at hand. */
#define ASP_VERSION_MAJOR 1
#define ASP_VERSION_MINOR 0
#define ASP_VERSION_PATCH 0
const char *asp_version(void);

#define ASP_PI 3.14159265358979323846
#define ASP_SPHERE_VOLUME(d_p) (ASP_PI / 6 * (d_p) * (d_p) * (d_p))

/* ---- errors ---------------------------------------------------------------------------------- */
typedef enum asp_code {
  ASP_OK = 0,
  ASP_EARG = -1,   /* an argument is outside its range */
  ASP_ENAME = -2,  /* no model, law, parameter or material of that name */
  ASP_ENOMEM = -3, /* out of memory */
  ASP_EFILE = -4,  /* a file cannot be opened, read or written */
  ASP_EDATA = -5,  /* a file's contents are not what they should be */
  ASP_ERANGE = -6  /* outside the range of a table or of a law's validity */
} asp_code;

typedef struct asp_error {
  asp_code code;
  char text[480]; /* one line without a full stop: name, value, and what it must be */
  int reserved[4];
} asp_error;

const char *asp_code_name(asp_code code); /* as "ASP_EARG" */

/* ---- a wall and its impacts ------------------------------------------------------------------ */
typedef struct asp_pair asp_pair;

/* A wall from its description in SI units, as in a script; see below. It is ready for contacts of
 * particles with diameters from d_least to d_most, which count for measured walls only. */
typedef struct asp_wall asp_wall;
asp_wall *asp_wall_from_text(const char *text, double d_least, double d_most, asp_error *error);
void asp_wall_free(asp_wall *wall);

/* The seed of its description, for asp_key. */
uint32_t asp_wall_seed(const asp_wall *wall);

/* The draws of a contact depend on this key alone, so results do not depend on the number of MPI
 * ranks, the order of contacts, or a restart. */
typedef struct asp_key {
  uint32_t seed;   /* the user's, see asp_wall_seed */
  uint32_t wall;   /* which wall, see asp_key_wall */
  uint64_t tag;    /* which particle */
  uint32_t impact; /* which impact of that particle, from 1 */
  uint32_t reserved;
} asp_key;

/* A number from a wall's name (32-bit FNV-1a): walls with the same seed get independent random
 * numbers. */
uint32_t asp_key_wall(const char *name);

/* A rigid body by the sphere of it that touches the wall: of a clump, or of an eccentric grain. */
typedef struct asp_body {
  double inverse_mass;       /* > 0 */
  double inverse_inertia[6]; /* about the center of mass, in the axes of the velocities: xx, yy, zz,
                                xy, xz, yz; an axis without inertia has 0 */
  double lever[3];           /* from the center of mass to the center of the touching sphere */
  double reserved[2];
} asp_body;

/* The gas at the point of impact, which takes deposits away (`deposit freeze remove`). */
typedef enum asp_gas {
  ASP_GAS_NONE = 0,    /* nothing is known of it: by the description */
  ASP_GAS_AT_REST = 1, /* takes nothing away */
  ASP_GAS_FLOWS = 2    /* with the friction velocity u_tau */
} asp_gas;

typedef struct asp_particle {
  double d_p;           /* diameter, > 0; for a body, of the touching sphere */
  double density;       /* > 0; ignored for a body */
  const asp_pair *pair; /* NULL: that of the wall */
  double omega[3];      /* angular velocity, rad per time, for laws that turn the particle */
  const double *lay;    /* direction of the lay at the particle, projected onto the wall; NULL: that
                           of the wall's description, an angle from x toward y. Parallel to n: the
                           flight is across it */
  double temperature;   /* particle temperature, K; 0: use the description's value */
  double u_tau;         /* friction velocity at the point of impact, > 0, if the gas flows */
  asp_gas gas;
  const asp_body *body; /* NULL: a solid sphere */
  double reserved[4];
} asp_particle;

typedef enum asp_outcome { ASP_REBOUND = 0, ASP_DEPOSIT = 1 } asp_outcome;

typedef struct asp_impact {
  double v2[3];       /* velocity after the contact, relative to the wall */
  double omega[3];    /* angular velocity after it; unchanged by laws without spin */
  double delta_alpha; /* tilt of the first hit in the plane of incidence, rad */
  double tilt_out;    /* tilt of the first hit out of it, rad, positive along n x t */
  int hits;           /* 1, or more with later hits */
  bool capped;        /* true if 64 draws or hits were not enough and the mean wall was used */
  asp_outcome outcome;
  double eroded; /* eroded wall mass per particle mass */
  double reserved[4];
} asp_impact;

/* One contact. v1: velocity relative to the wall; n: outward unit normal of the mean wall. The
 * caller ensures v1.n < 0. Afterwards v2.n > 0, or the particle is deposited (v2 = 0), or, on a
 * wall without deposits whose law leaves no normal speed, it slides (v2.n = 0). Kinetic energy
 * never grows; with a law that turns the particle that includes the spin of a solid sphere. For a
 * body, v1 and v2 are the velocity of its center of mass, and every law changes its spin; u = v1 +
 * omega x lever must approach (u.n < 0). Afterwards u leaves the wall, but v2 may not. A wall with
 * `grain lever` makes every particle without a body an eccentric one. No allocation. ASP_EARG if
 * the law needs a pair and neither particle nor wall has one, or if an eccentric grain has no
 * density > 0, ASP_ERANGE if `viscosity` or
 * `soften_modulus` does not hold at the temperature; velocity and spin are then unchanged.
 * Where a number of the particle, v1 or n is not finite, v2 is NAN in a rebound without hits. */
asp_code asp_wall_impact(const asp_wall *wall, const asp_particle *particle, const double v1[3],
                         const double n[3], const asp_key *key, asp_impact *impact);

/* n contacts like asp_wall_impact, from arrays: particles[n], velocities v1[3 n], normals[3 n] and
 * keys[n]; results go to impacts[n]. */
asp_code asp_wall_impacts(const asp_wall *wall, size_t n, const asp_particle *particles,
                          const double *v1, const double *normals, const asp_key *keys,
                          asp_impact *impacts, asp_error *error);

/* The coefficients of restitution of a contact about the mean wall (eq. 1). A quotient is NAN for a
 * deposit, and if its denominator is below 1e-6 of v1 or of 1 rad: cor_n and cor_alpha of a
 * sliding particle; cor_t above 89.99 degrees. */
typedef struct asp_coefficients {
  double v1, alpha1;
  double v2;                           /* in space */
  double alpha2;                       /* in the plane of incidence: atan2(v2.n, v2.t), 0 to pi; 0
                                          for a deposit */
  double cor_v, cor_alpha, cor_n;      /* in the plane */
  double cor_v_space, cor_alpha_space; /* v2/v1, and asin(v2.n/v2)/alpha1 */
  double cor_t;                        /* signed */
  double reserved[2];
} asp_coefficients;
asp_coefficients asp_impact_coefficients(const double v1[3], const double n[3],
                                         const asp_impact *impact);

/* Coefficients of n contacts in the arrays of asp_wall_impacts. */
void asp_impacts_coefficients(size_t n, const double *v1, const double *normals,
                              const asp_impact *impacts, asp_coefficients *coefficients);

/* ---- the description of a wall --------------------------------------------------------------- */
/* The caller's units per SI unit (1 for SI, 1e6 for micrometers; 0: unknown). The name is for
 * messages, as "'units lj'". */
typedef struct asp_units {
  const char *name;
  double meter, kilogram, second;
  double reserved[2];
} asp_units;

/* A description of a wall in words, as in a script and in the command:
 *
 *   surface rq 15.6um lambda_c 120um rebound bons friction 0.4 materials quartz hastelloy-x
 *
 * `asperity help wall` prints all of them. Without words it is a smooth wall with the law `bons`. A
 * number alone is in the caller's units (NULL: SI; their name must live as long as the
 * description), one with a unit behind it, as 5um, 200MPa or 30deg, is converted to them; angles
 * are degrees. Names with blanks stand in quotes, where a quote is doubled. A word without an
 * effect on the wall is an error. Files of tables and materials are read here; asp_wall_create
 * reads files of measured walls. */
typedef struct asp_description asp_description;
asp_description *asp_description_parse(const char *text, const asp_units *units, asp_error *error);
void asp_description_free(asp_description *description);

/* The canonical text, numbers in the caller's units, in SI lengths with their unit (um or m):
 * parsing it gives the same wall. Writes at most `size` characters with the NUL, and returns how
 * many characters there are without it. */
size_t asp_description_text(const asp_description *description, char *text, size_t size);

/* Gets or sets a number by name: a law parameter or a numeric keyword. get returns NaN if the name
 * is unknown or unset. set checks the range; it works on a clause's keyword only if the clause has
 * it. */
double asp_description_get(const asp_description *description, const char *name);
asp_code asp_description_set(asp_description *description, const char *name, double value,
                             asp_error *error);

/* A word by name: that of the keywords surface (smooth, sigma, rq, profile or map), spread,
 * tilt, collisions, rebound and deposit; `file` of the profile or the map. NULL for another
 * name, or if there is no file. */
const char *asp_description_word(const asp_description *description, const char *name);

/* The lay of a wall: a vector of length 1 that is fixed to the wall, or, on a cylinder, the angle
 * (rad) from its axis about the outward normal. */
typedef enum asp_lay_kind { ASP_LAY_NONE, ASP_LAY_VECTOR, ASP_LAY_ANGLE } asp_lay_kind;
typedef struct asp_lay {
  asp_lay_kind kind;
  double vector[3];
  double angle;
  double reserved[2];
} asp_lay;
asp_lay asp_description_lay(const asp_description *description);

/* A wall of a description, for diameters from d_least to d_most in its units; they are used only
 * if asp_description_needs_sizes, otherwise they may be 0. ASP_EARG if the law needs a pair and
 * the description has no two materials, unless particles come with theirs (asperity_engine.h).
 * Reads the file of a measured wall unless the caller has set its heights. The wall needs neither
 * description nor heights any longer. */
asp_wall *asp_wall_create(const asp_description *description, double d_least, double d_most,
                          asp_error *error);
bool asp_description_needs_sizes(const asp_description *description);

/* The rms slope of the wall's tilt for spheres of diameter d_p, across its lay: with `isotropic` of
 * the sphere, with `plane` of the disc, by the formulas of src/wall/models.md; 0 on a smooth
 * wall. */
double asp_wall_slope(const asp_wall *wall, double d_p);

/* ---- heights of a measured wall -------------------------------------------------------------- */
/* Heights of a wall at equal spacing: over an area, row after row, or along a line, which is one
 * row; read from files (asperity_engine.h) also several such lines of one wall. A profile that is
 * not periodic continues beyond its ends as its mirror image. Lengths are in any one unit. */
typedef struct asp_heights asp_heights;

/* Copies z[rows * columns], row after row: at least three finite numbers per row, and one row or at
 * least three. step_x: between the points of a row; step_y: between rows, not used
 * for one row. */
asp_heights *asp_heights_create(const double *z, size_t columns, size_t rows, double step_x,
                                double step_y, bool periodic, asp_error *error);
void asp_heights_free(asp_heights *heights);

/* Heights in numbers. For a map, s_q to s_tr follow ISO 25178-2 without a filter; for a profile,
 * s_q, s_a and s_dq are R_q, R_a and R_dq of ISO 21920-2. */
typedef struct asp_heights_numbers {
  double mean;
  double s_q, s_a;           /* rms and mean absolute height, from the mean */
  double s_sk, s_ku;         /* skewness, kurtosis (3 for a normal law) */
  double s_p, s_v, s_z;      /* highest peak, deepest valley, both together */
  double s_dq;               /* rms gradient */
  double s_al, s_tr;         /* shortest way to the autocorrelation 0.2; that over the longest */
  double lambda_1, lambda_2; /* half axes of the ellipse that fits the 1/e contour of the
                                autocorrelation best, lambda_1 <= lambda_2; of a profile lambda_c */
  double lay;                /* direction of the longer one, from x toward y, rad, 0 to pi */
  double reserved[4];
} asp_heights_numbers;

/* ASP_EDATA when the heights are constant, or too few for their autocorrelation to fall to 1/e
 * within half the length in any direction. If it does so in some directions of a map only, the
 * ellipse is fitted to these, and s_tr is NaN. */
asp_code asp_heights_describe(const asp_heights *heights, asp_heights_numbers *numbers,
                              asp_error *error);

/* Heights in place of the file of `surface profile FILE` (one row) or `surface map FILE` (more);
 * they must live as long as the description. ASP_EARG if the surface is not of that kind. */
asp_code asp_description_set_heights(asp_description *description, const asp_heights *heights,
                                     asp_error *error);

/* ---- materials ------------------------------------------------------------------------------- */
typedef struct asp_material asp_material;

/* The materials of a description, in its units, which live as long as it does; NULL for an index
 * outside 0 <= index < asp_description_materials(). */
int asp_description_materials(const asp_description *description);
const asp_material *asp_description_material(const asp_description *description, int index);

/* A material. Its numbers, by name: youngs_modulus (Pa, > 0), poissons_ratio (more than -1, less
 * than 0.5), density (kg/m^3, > 0), yield_stress (Pa; 0 if unknown; used for the particle only).
 * Your own materials may use any consistent units. */

/* A material of your own; its numbers are 0 until you set them. */
asp_material *asp_material_create(const char *name, asp_error *error);
void asp_material_free(asp_material *material);
asp_code asp_material_set(asp_material *material, const char *name, double value, asp_error *error);
double asp_material_get(const asp_material *material, const char *name); /* NaN for another name */

/* Constants of a contact between a particle and a wall material. By name:
 *   modulus         composite modulus E_c = 1/((1-nu_p^2)/E_p + (1-nu_w^2)/E_w); only to get
 *   yield_stress    the particle's, >= 0
 *   surface_energy  half of the work of adhesion, energy per area, >= 0; 0: no adhesion
 *                   (default ASP_SURFACE_ENERGY, in SI: set it if the materials use other units)
 *   friction        coefficient of friction, >= 0 (ASP_FRICTION) */
asp_pair *asp_pair_create(const asp_material *particle, const asp_material *wall, asp_error *error);
void asp_pair_free(asp_pair *pair);
asp_code asp_pair_set(asp_pair *pair, const char *name, double value, asp_error *error);
double asp_pair_get(const asp_pair *pair, const char *name); /* NaN for another name */

/* Defaults. */
#define ASP_FRICTION 0.3       /* Bons et al. 2017, secondary source */
#define ASP_SURFACE_ENERGY 0.8 /* J/m^2, Bons et al. 2017, recalled, original not seen */

/* A pair of materials in the description's units, with the description's friction, surface energy
 * and yield stress. Defaults: ASP_FRICTION, ASP_SURFACE_ENERGY (0 if the units are unknown), and
 * the particle's own yield stress. */
asp_pair *asp_description_pair(const asp_description *description, const asp_material *particle,
                               const asp_material *target, asp_error *error);

/* The pair of the first two materials of the description, the particle's and the wall's; NULL if
 * there are fewer, or the law takes none. */
const asp_pair *asp_wall_pair(const asp_wall *wall);

#if defined(__GNUC__)
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
