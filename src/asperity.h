/* asperity: rough walls for particle simulation. The one public header of the core.
 *
 * A wall is a surface (how rough), a spread model (which face a particle meets at a given impact
 * angle), and a rebound law (what the material makes of the hit). asp_wall_impact() joins the three
 * for one contact. All of it works in any consistent set of units; angles are radians, measured
 * from the wall plane (90 degrees is normal impact); velocities are relative to the wall. A
 * positive tilt delta_alpha turns the wall towards the particle (luff), so that the local impact
 * angle is alpha1 + delta_alpha.
 *
 * Objects are made by ..._create and freed by ..._free; once made they are const and may be shared
 * by threads. Setup allocates, a contact does not. The library prints nothing and never exits: a
 * call that can fail takes an asp_error (or NULL) and says there what was wrong.
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

#define ASP_VERSION "0.1.0"
#define ASP_PI 3.14159265358979323846

/* ---- errors ------------------------------------------------------------------------------------
 */

typedef enum asp_code {
  ASP_OK = 0,
  ASP_EARG = -1,   /* an argument is outside its allowed range */
  ASP_ENAME = -2,  /* no model, law, parameter or material of that name */
  ASP_ENOMEM = -3, /* out of memory */
  ASP_EFILE = -4,  /* a file cannot be opened, read or written */
  ASP_EDATA = -5,  /* a file's contents are not what they should be */
  ASP_ERANGE = -6  /* outside the range of a table or of a law's validity */
} asp_code;

typedef struct asp_error {
  asp_code code;
  char text[480]; /* one line, without a full stop: what, its value, what is allowed */
} asp_error;

/* ---- random numbers ----------------------------------------------------------------------------
 */

/* What a draw depends on, and nothing else: so a result does not depend on the number of MPI ranks,
 * on the order of contacts, or on a restart. */
typedef struct asp_key {
  uint32_t seed;   /* the user's */
  uint32_t fix;    /* which wall, see asp_key_fix */
  uint64_t tag;    /* which particle */
  uint32_t impact; /* which impact of that particle, from 1 */
} asp_key;

/* The random numbers of one contact: Philox4x32-10 (Salmon et al. 2011) keyed by (seed, fix),
 * counted by (tag, impact, block of two draws). Lives on the stack. */
typedef struct asp_stream {
  uint32_t key[2];
  uint32_t counter[4];
  double spare;
  bool has_spare;
} asp_stream;

/* A number for a wall's name (32-bit FNV-1a), so that two walls with one seed draw differently. */
uint32_t asp_key_fix(const char *name);

/* The stream of one contact, at its beginning. */
asp_stream asp_stream_create(asp_key key);

/* The next uniform number of the stream, strictly between 0 and 1, in steps of 2^-53. */
double asp_stream_uniform(asp_stream *stream);

/* The next standard normal number of the stream (inverse transform, one uniform each). */
double asp_stream_normal(asp_stream *stream);

/* ---- surface -----------------------------------------------------------------------------------
 */

/* The size law of a rough wall: which rms slope a sphere of diameter d_p meets on it. */
typedef struct asp_surface asp_surface;

/* A Gaussian wall by its two numbers, both in one unit of length and both greater than zero:
 * r_q, the rms height, and lambda_c, the lag at which the autocorrelation exp(-x^2/lambda_c^2) has
 * fallen to 1/e. Returns NULL on error. */
asp_surface *asp_surface_create(double r_q, double lambda_c, asp_error *error);

void asp_surface_free(asp_surface *surface);

/* The wall's own numbers: phi_r = r_q/lambda_c (eq. 9), and the unfiltered rms slope sqrt(2) phi_r.
 */
double asp_surface_r_q(const asp_surface *surface);
double asp_surface_lambda_c(const asp_surface *surface);
double asp_surface_phi_r(const asp_surface *surface);
double asp_surface_slope_rms(const asp_surface *surface);

/* kappa = sqrt(3) d_p r_q / lambda_c^2: the particle's radius times the rms curvature of the
 * profile. Under about 0.4 the particle follows the profile and its size does not matter. */
double asp_surface_kappa(const asp_surface *surface, double d_p);

/* The rms slope s_eff that a sphere of diameter d_p (>= 0, the surface's unit) meets: that of the
 * profile closed by a disc of that diameter,
 *   s_eff = s (1 + 0.92 kappa^3)^(-1/6),
 * within 2-3 % for phi_r <= 0.25. */
double asp_surface_slope(const asp_surface *surface, double d_p);

/* ---- spread ------------------------------------------------------------------------------------
 */

/* What a spread model looks at: one particle coming to one wall. */
typedef struct asp_view {
  double slope;  /* s_eff, the rms slope that a particle of this size meets */
  double sigma;  /* atan(s_eff), the one number that describes the wall to the paper's models */
  double alpha1; /* impact angle, 0 <= alpha1 <= pi/2 */
  double d_p;    /* diameter, in the surface's unit; for models that look up the profile itself */
  const void *data; /* what a model that needs more was given when the wall was made, or NULL */
} asp_view;

/* A view for laws that need no more than sigma (0 <= sigma < pi/2) and alpha1. */
asp_view asp_view_create(double sigma, double alpha1);

/* A spread model as data: how the tilt delta_alpha of the face that is hit is distributed. Every
 * law is cut to |delta_alpha| < 90 degrees and alpha1 + delta_alpha < 180 degrees (a height
 * function has no overhangs, and a particle hits only faces turned towards it) and normalised over
 * what is left. At sigma = 0 every law is delta_alpha = 0. */
typedef struct asp_spread_model {
  const char *name;
  const char *summary; /* one line */
  const char *source;  /* author, year, equation */
  /* Density in 1/rad and distribution at delta; NULL where the law has none (`none`). */
  double (*density)(const asp_view *view, double delta);
  double (*distribution)(const asp_view *view, double delta);
  /* The delta at which the distribution is u, 0 < u < 1; NULL where the law is only a loop. */
  double (*quantile)(const asp_view *view, double u);
  /* One delta by a loop, for laws that are one; NULL where the quantile is the draw. False when the
   * loop reached its bound (delta is then 0, the mean wall). */
  bool (*loop)(const asp_view *view, asp_stream *stream, double *delta);
} asp_spread_model;

/* One delta of the model, from the stream; false when a loop reached its bound. */
bool asp_spread_draw(const asp_spread_model *model, const asp_view *view, asp_stream *stream,
                     double *delta);

/* All models, in a fixed order: 0 <= index < asp_spread_count(). */
int asp_spread_count(void);
const asp_spread_model *asp_spread_at(int index);

/* The model of that name; NULL and a message that lists the names there are, when there is none. */
const asp_spread_model *asp_spread_find(const char *name, asp_error *error);

/* ---- rebound -----------------------------------------------------------------------------------
 */

enum { ASP_PARAMETERS_MAX = 8 };

/* One named number that a law can be given. */
typedef struct asp_parameter {
  const char *name;
  const char *unit;
  double fallback; /* the value where the user gives none */
  double least, most;
  const char *text; /* what it is, its source, and whether the original was seen */
} asp_parameter;

/* A material. */
typedef struct asp_material {
  const char *name;
  const char *title;
  double youngs_modulus; /* Pa */
  double poissons_ratio;
  double density;      /* kg/m^3 */
  double yield_stress; /* Pa; 0 where no value is given: it counts for the particle only */
  const char *source;
} asp_material;

int asp_material_count(void);
const asp_material *asp_material_at(int index);
const asp_material *asp_material_find(const char *name, asp_error *error);

/* What a contact between one particle material and one wall material needs, worked out once. */
typedef struct asp_pair {
  double modulus;        /* composite modulus E_c = 1/((1-nu_p^2)/E_p + (1-nu_w^2)/E_w) */
  double yield_stress;   /* of the particle, >= 0 */
  double surface_energy; /* gamma, energy per area, >= 0; 0 switches adhesion off */
  double friction;       /* mu, >= 0 */
} asp_pair;

/* Fills a pair. Moduli > 0, Poisson's ratios in (-1, 0.5), the others >= 0, all finite. */
asp_code asp_pair_create(double youngs_modulus_p, double poissons_ratio_p, double youngs_modulus_w,
                         double poissons_ratio_w, double yield_stress, double surface_energy,
                         double friction, asp_pair *pair, asp_error *error);

/* Defaults where a user gives none. */
#define ASP_FRICTION 0.3       /* Bons et al. 2017, secondary source */
#define ASP_SURFACE_ENERGY 0.8 /* J/m^2, Bons et al. 2017, recalled, original not seen */

/* One hit in the frame of the local face. */
typedef struct asp_hit {
  double v_n1; /* approach speed along the face's normal, > 0 */
  double v_t1; /* speed along the face, >= 0 */
  double d_p;
  double density;
  const asp_pair *pair; /* may be NULL for laws that need no material */
  bool adhesion;        /* false: the law leaves the surface energy out */
} asp_hit;

/* What is left of it: 0 <= v_t2 <= v_t1 and 0 <= v_n2 <= v_n1; v_n2 = 0 is a deposit, where the
 * wall takes deposits. */
typedef struct asp_bounce {
  double v_n2;
  double v_t2;
} asp_bounce;

typedef struct asp_rebound_law {
  const char *name;
  const char *summary;
  const char *source;
  bool needs_material; /* whether asp_hit.pair must be given */
  int n_parameters;
  const asp_parameter *parameters;
  asp_bounce (*rebound)(const double *parameters, const asp_hit *hit);
} asp_rebound_law;

int asp_rebound_count(void);
const asp_rebound_law *asp_rebound_at(int index);
const asp_rebound_law *asp_rebound_find(const char *name, asp_error *error);

/* Index of the law's parameter of that name, or a negative code. */
int asp_rebound_parameter(const asp_rebound_law *law, const char *name, asp_error *error);

/* ---- wall and impact ---------------------------------------------------------------------------
 */

typedef enum asp_tilt {
  ASP_TILT_PLANE,    /* the face turns in the plane of incidence only (the paper) */
  ASP_TILT_ISOTROPIC /* and out of it, by a slope that is normal with sd s_eff */
} asp_tilt;

typedef enum asp_collisions {
  ASP_COLLISIONS_SINGLE,  /* a rebound into the wall is drawn again */
  ASP_COLLISIONS_MULTIPLE /* a rebound into the wall hits the next face */
} asp_collisions;

enum { ASP_HITS_MAX = 64 }; /* draws or hits in one contact before it is called capped */

/* What a wall is made of; names are looked up once, in asp_wall_create. */
typedef struct asp_wall_spec {
  const asp_surface *surface; /* NULL: smooth; otherwise must outlive the wall */
  const char *spread;         /* name of the model */
  asp_tilt tilt;
  asp_collisions collisions;
  const char *rebound; /* name of the law */
  double parameters[ASP_PARAMETERS_MAX];
  bool deposit; /* whether a particle may stick; false also leaves adhesion out */
} asp_wall_spec;

/* A smooth wall, `none`, `bons` with its defaults, deposits on. */
asp_wall_spec asp_wall_spec_default(void);

/* Chooses the rebound law of a spec and sets its parameters to their defaults. */
asp_code asp_wall_spec_rebound(asp_wall_spec *spec, const char *law, asp_error *error);

/* Sets one parameter of the spec's law by name; the value must lie in the parameter's range. */
asp_code asp_wall_spec_set(asp_wall_spec *spec, const char *parameter, double value,
                           asp_error *error);

typedef struct asp_wall asp_wall;

asp_wall *asp_wall_create(const asp_wall_spec *spec, asp_error *error);
void asp_wall_free(asp_wall *wall);

typedef struct asp_particle {
  double d_p;           /* diameter, > 0 */
  double density;       /* > 0 */
  const asp_pair *pair; /* may be NULL when the law needs no material */
} asp_particle;

typedef enum asp_outcome { ASP_REBOUND = 0, ASP_DEPOSIT = 1 } asp_outcome;

typedef struct asp_impact {
  double v2[3];       /* velocity after the contact, relative to the wall */
  double delta_alpha; /* tilt of the first hit in the plane of incidence, rad */
  double tilt_out;    /* tilt of the first hit out of it, rad, positive along n x t */
  int hits;           /* 1, or more with later hits */
  bool capped;        /* the bound ASP_HITS_MAX was reached and the mean wall taken instead */
  asp_outcome outcome;
} asp_impact;

/* One contact. v1 is the velocity relative to the wall and n the outward unit normal of the mean
 * wall, with v1.n < 0; the caller sees to that. Afterwards v2.n > 0, or the particle is deposited
 * (v2 = 0), or, on a wall without deposits whose law leaves no normal speed, it slides (v2.n = 0).
 * Kinetic energy never grows. No allocation, no failure. */
void asp_wall_impact(const asp_wall *wall, const asp_particle *particle, const double v1[3],
                     const double n[3], asp_key key, asp_impact *impact);

/* The coefficients of restitution of a contact about the mean wall (eq. 1). */
typedef struct asp_coefficients {
  double v1, alpha1;
  double v2, alpha2; /* alpha2 = atan2(v2.n, v2.t), 0 to pi; 0 for a deposit */
  double cor_v, cor_alpha, cor_n;
  double cor_t;       /* signed; 0 where undefined */
  bool cor_t_defined; /* false where v1 has no tangential part (below 1e-12 of v1) */
} asp_coefficients;

asp_coefficients asp_impact_coefficients(const double v1[3], const double n[3],
                                         const asp_impact *impact);

#ifdef __cplusplus
}
#endif
#endif
