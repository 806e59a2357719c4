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
 * on the order of contacts, or on a restart. Passed by pointer: a copy, read back in other widths
 * than it has just been written in, would wait until all before it is done. */
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
  double ready[2]; /* numbers that are drawn already, the last `left` of them */
  int left;
} asp_stream;

/* A number for a wall's name (32-bit FNV-1a), so that two walls with one seed draw differently. */
uint32_t asp_key_fix(const char *name);

/* The stream of one contact, at its beginning. */
asp_stream asp_stream_create(const asp_key *key);

/* The next uniform number of the stream, strictly between 0 and 1: in steps of 2^-53 below
 * 0.5 and of 2^-52 above. */
double asp_stream_uniform(asp_stream *stream);

/* The next standard normal number of the stream (inverse transform, one uniform each). */
double asp_stream_normal(asp_stream *stream);

/* ---- profile -----------------------------------------------------------------------------------
 */

/* Heights of a wall along a line, at equal spacing. Lengths are in any one unit. A generated
 * profile is periodic; a measured one continues beyond its ends as its mirror image. */
typedef struct asp_profile asp_profile;

/* A Gaussian profile (Garcia & Stoll 1984, secondary source): white noise filtered so that the
 * autocovariance is r_q^2 exp(-x^2/lambda_c^2); periodic. Of any number of points, but at least 20
 * lambda_c long and at most lambda_c/4 apart. r_q and lambda_c are those of the ensemble: a sample
 * has them within its sampling error. The same seed gives the same profile. NULL on error. */
asp_profile *asp_profile_create(double r_q, double lambda_c, double spacing, size_t points,
                                uint32_t seed, asp_error *error);

/* A profile of given heights, which are copied: at least three, all finite. NULL on error. */
asp_profile *asp_profile_from_heights(const double *heights, size_t points, double spacing,
                                      bool periodic, asp_error *error);

void asp_profile_free(asp_profile *profile);

size_t asp_profile_points(const asp_profile *profile);
double asp_profile_spacing(const asp_profile *profile);
bool asp_profile_periodic(const asp_profile *profile);
const double *asp_profile_heights(const asp_profile *profile);

enum { ASP_FORM_MAX = 9 };

/* How a measured profile is read. */
typedef struct asp_profile_options {
  double unit_x, unit_z; /* metres in one unit of a text file's columns; 0: as the file states */
  double metre;          /* one metre in the unit of the result: 1 for SI, 1e6 for micrometres */
  int form;              /* degree of the polynomial that is taken out as form, 0 to 9; -1: none */
  double spikes;         /* points this many robust sd off their neighbours are bad, and refused or
                            filled as those are; 0: none are */
  bool fill;     /* bad points and gaps are filled by straight lines; false: they are refused */
  bool resample; /* unequal spacing is resampled by straight lines; false: it is refused */
  int row;       /* of an SDF map, from 1 */
  int column;    /* 0, or: of an SDF map, read that column instead; of a text file, the heights */
} asp_profile_options;

/* Units as stated, metres, a mean line taken out, gaps refused, unequal spacing resampled, first
 * row of a map, heights in the second column of a text file. */
asp_profile_options asp_profile_options_default(void);

/* What the reader found and did. */
typedef struct asp_profile_report {
  size_t points;      /* read from the file */
  size_t bad;         /* bad points among them: not a number, or marked as bad */
  size_t spikes;      /* points taken for spikes */
  size_t filled;      /* points of the result that were filled in */
  size_t longest_gap; /* most of them in a row */
  bool resampled;
  double step_least, step_most; /* spacing of the file's positions, in the unit of the result */
  char text[480];               /* all of that as a sentence */
} asp_profile_report;

/* Reads a measured profile: text in columns (position, height; separated by commas, semicolons,
 * tabs or spaces; after any header), or SDF in ASCII (ISO 25178-71). The file is read as a stream.
 * A text file must state its unit in the last lines of its header (`x_um,z_um`, `Lateral um,Raw
 * Micrometer`, `x [mm]; z [nm]`, `unit: um`), or the options must. Positions may be rounded: the
 * spacing comes from all of them. options NULL: the defaults; report may be NULL. NULL on error;
 * the message names file and line. */
asp_profile *asp_profile_read(const char *path, const asp_profile_options *options,
                              asp_profile_report *report, asp_error *error);

/* Metres in a unit of length by its name (m cm mm um nm, or as instruments write them:
 * `Micrometer`, the Greek letter in UTF-8 or Latin-1, `Angstrom`); 0 when it is none. */
double asp_unit_metres(const char *name, size_t length);

/* Levels of the autocorrelation that define the correlation length. */
#define ASP_LEVEL_1_E 0.36787944117144233
#define ASP_LEVEL_S_AL 0.2 /* S_al of ISO 25178-2 */

typedef struct asp_description {
  double length, spacing;
  size_t points;
  double r_q, r_a;   /* rms and mean absolute height about the mean */
  double lambda_c;   /* the lag at which the autocorrelation falls to the level */
  double lambda_1_e; /* lambda_c / sqrt(-ln(level)): the 1/e lag of a Gaussian profile with it */
  double phi_r;      /* r_q/lambda_c */
  double slope_rms;  /* of the differences between neighbours */
} asp_description;

/* Describes a profile; 0 < level < 1. ASP_EDATA when it is constant, or too short for its
 * autocorrelation to fall to the level within half its length. Of a measured profile the
 * autocovariance at lag k is the sum of its n - k products over n. */
asp_code asp_profile_describe(const asp_profile *profile, double level,
                              asp_description *description, asp_error *error);

/* The path of the centre of a disc of diameter d_p that rolls over the profile (dilation), and the
 * deepest that its edge reaches (closing: dilation, then erosion); exact for the sampled points, in
 * a time that does not depend on d_p. `out` has asp_profile_points values. 0 < d_p <= length. */
asp_code asp_profile_dilate(const asp_profile *profile, double d_p, double *out, asp_error *error);
asp_code asp_profile_close(const asp_profile *profile, double d_p, double *out, asp_error *error);

/* ---- slopes ------------------------------------------------------------------------------------
 */

/* Mean, standard deviation, skewness, and excess kurtosis (0 for a normal law). */
typedef struct asp_moments {
  double mean, sd, skewness, kurtosis;
} asp_moments;

asp_moments asp_moments_of(const double *values, size_t count);

/* A density on equally spaced points, by a Gaussian kernel. */
typedef struct asp_density asp_density;

/* Kernel density estimate of at least two values, not all equal, at `points` (2 to 65536) points
 * from lo to hi. Bandwidth min(sd, quartile distance/1.349) (4/(3 count))^(1/5). Normalised over lo
 * to hi; values outside are left out. NULL on error. */
asp_density *asp_density_create(const double *values, size_t count, double lo, double hi,
                                size_t points, asp_error *error);
void asp_density_free(asp_density *density);
size_t asp_density_points(const asp_density *density);
double asp_density_at(const asp_density *density, size_t index, double *x);
double asp_density_bandwidth(const asp_density *density);

/* D_KL (eq. 2, natural logarithm) of the density against a normal law, and against another density
 * on the same points. Where the other density is less than one of its values spread over the range,
 * that least is taken instead. An estimate from N independent values is about B/(2N) too high, B
 * the number of bins that the kernel is worth over 8 sd: 8 sd/(2 sqrt(pi) bandwidth). */
double asp_density_kl_normal(const asp_density *density, double mean, double sd);
double asp_density_kl(const asp_density *reference, const asp_density *other);

typedef enum asp_contact {
  ASP_CONTACT_DILATION, /* where a particle with a uniformly spread centre touches */
  ASP_CONTACT_CLOSING   /* the filtered profile itself; equal to it in law */
} asp_contact;

/* Slopes of the dilated or closed profile between neighbouring points, into `out`; *count is how
 * many there are: the number of points, one less on a profile that is not periodic. */
asp_code asp_profile_slopes(const asp_profile *profile, double d_p, asp_contact contact,
                            double *out, size_t *count, asp_error *error);

/* The contact slopes of a profile for one particle size, in numbers. */
typedef struct asp_slopes {
  double slope_rms;         /* s_eff */
  asp_moments slope, angle; /* angle in rad */
  double bandwidth;         /* of the density of the angles, rad */
  double kl_normal;         /* D_KL of the normal law with the angles' mean and sd */
} asp_slopes;

asp_code asp_profile_describe_slopes(const asp_profile *profile, double d_p, asp_contact contact,
                                     asp_slopes *slopes, asp_error *error);

/* ---- surface -----------------------------------------------------------------------------------
 */

/* The size law of a rough wall: which rms slope a sphere of diameter d_p meets on it. */
typedef struct asp_surface asp_surface;

/* What rolls over what. */
typedef enum asp_filter {
  ASP_FILTER_DISC,  /* a disc on a profile (the paper) */
  ASP_FILTER_SPHERE /* a sphere on an isotropic surface: it finds a little less slope */
} asp_filter;

/* A Gaussian wall by its two numbers, both in one unit of length and both greater than zero:
 * r_q, the rms height, and lambda_c, the lag at which the autocorrelation exp(-x^2/lambda_c^2) has
 * fallen to 1/e; filtered by a disc. Up to phi_r = 0.25 the closed form (see asp_surface_slope),
 * beyond it a table over (phi_r, d_p/lambda_c), up to phi_r = 1. NULL on error. */
asp_surface *asp_surface_create(double r_q, double lambda_c, asp_error *error);

/* The same with the filter as chosen; a sphere up to phi_r = 0.25, by a table of small slopes: its
 * s_eff is within 3 % up to phi_r = 0.1, and up to 6 % low at 0.25. */
asp_surface *asp_surface_create_filter(double r_q, double lambda_c, asp_filter filter,
                                       asp_error *error);

/* A wall by its measured profile, which need not outlive it: the rms slopes of the profile closed
 * by discs of `bins` diameters from d_min to d_max at equal ratios (one bin: the geometric mean),
 * monotone between them, the end values beyond. r_q and lambda_c are the profile's, by the 1/e lag.
 * spacing <= d_min <= d_max <= length; bins 1 to 10000. NULL on error. */
asp_surface *asp_surface_create_profile(const asp_profile *profile, double d_min, double d_max,
                                        int bins, asp_error *error);

void asp_surface_free(asp_surface *surface);

/* The bins of a wall made from a profile; none for other walls. 0 <= bin < asp_surface_bins(). */
int asp_surface_bins(const asp_surface *surface);
double asp_surface_bin_d_p(const asp_surface *surface, int bin);
double asp_surface_bin_slope(const asp_surface *surface, int bin);

/* The largest d_p that the size law has been checked for, and ASP_ERANGE with a message when d_p is
 * beyond it: for setup to call before the contacts begin. */
double asp_surface_d_p_most(const asp_surface *surface);
asp_code asp_surface_check(const asp_surface *surface, double d_p, asp_error *error);

/* The wall's own numbers: phi_r = r_q/lambda_c (eq. 9), and the unfiltered rms slope: sqrt(2) phi_r
 * of a Gaussian wall. */
double asp_surface_r_q(const asp_surface *surface);
double asp_surface_lambda_c(const asp_surface *surface);
double asp_surface_phi_r(const asp_surface *surface);
double asp_surface_slope_rms(const asp_surface *surface);

/* kappa = sqrt(3) d_p r_q / lambda_c^2: the particle's radius times the rms curvature of the
 * profile. Under about 0.4 the particle follows the profile and its size does not matter. */
double asp_surface_kappa(const asp_surface *surface, double d_p);

/* s_eff/s of a Gaussian profile closed by a disc, kappa >= 0: 1 when nothing is filtered,
 *   s_eff = s (1 + 0.92 kappa^3)^(-1/6).
 * Against generated profiles, kappa up to 16: within 3 % at phi_r 0.05, up to 5 % low at 0.25; 5 %
 * high at kappa 64. */
double asp_closed_form(double kappa);

/* The rms slope s_eff that a sphere of diameter d_p (>= 0, the surface's unit) meets: that of the
 * profile closed by a disc of that diameter; by asp_closed_form for phi_r <= 0.25. No allocation,
 * no failure, and no cost that grows with tables or bins: beyond asp_surface_d_p_most a tabled law
 * keeps its last value. */
double asp_surface_slope(const asp_surface *surface, double d_p);

/* ---- spread ------------------------------------------------------------------------------------
 */

/* What a spread model looks at: one particle coming to one wall. */
typedef struct asp_view {
  double slope;  /* s_eff, the rms slope that a particle of this size meets */
  double sigma;  /* atan(s_eff), the one number that describes the wall to the paper's models */
  double alpha1; /* impact angle, 0 <= alpha1 <= pi/2; negative, down to -pi/2, for a particle that
                    flies up after an earlier hit (models with `upward` only) */
  double d_p;    /* diameter, in the surface's unit; for models that look up the profile itself */
  const void *data; /* what a model that needs more was given when the wall was made, or NULL */
} asp_view;

/* A view for laws that need no more than sigma (0 <= sigma < pi/2) and alpha1. */
asp_view asp_view_create(double sigma, double alpha1);

/* Where a particle is that a model follows over a profile: nowhere yet, when all is 0. */
typedef struct asp_path {
  bool begun;
  bool back;   /* flies towards smaller x of the profile */
  double x, z; /* place along the profile and height, in points */
  size_t face; /* that it last hit */
  int hits;    /* so far */
} asp_path;

/* The diameters that a wall is made for: `bins` of them from least to most at equal ratios; one
 * bin is their geometric mean. 0 < least <= most, bins >= 1. */
typedef struct asp_sizes {
  double least, most;
  int bins;
} asp_sizes;

/* A spread model as data: how the tilt delta_alpha of the face that is hit is distributed. Every
 * law is cut to |delta_alpha| < 90 degrees and alpha1 + delta_alpha < 180 degrees (a height
 * function has no overhangs, and a particle hits only faces turned towards it) and normalised over
 * what is left. At sigma = 0 every law is delta_alpha = 0. */
typedef struct asp_spread_model {
  const char *name;
  const char *summary; /* one line */
  const char *source;  /* author, year, equation */
  int cost;            /* place in the order of what a contact costs, from 0; each its own */
  bool upward;         /* has a law for particles that fly up, too: faces with delta > -alpha1;
                          others borrow that of `visible` */
  /* The probability that a particle that a face has sent up at theta > 0 over the mean wall leaves;
   * NULL: by the heights of a Gaussian wall. A model with a rule of its own always uses it. */
  double (*escape)(const asp_view *view, double theta);
  /* Density in 1/rad and distribution at delta; NULL where the law has none (`none`). */
  double (*density)(const asp_view *view, double delta);
  double (*distribution)(const asp_view *view, double delta);
  /* The delta at which the distribution is u, 0 < u < 1; NULL where the law is only a loop. */
  double (*quantile)(const asp_view *view, double u);
  /* One delta by a loop, for laws that are one; NULL where the quantile is the draw. False when the
   * loop reached its bound (delta is then 0, the mean wall). */
  bool (*loop)(const asp_view *view, asp_stream *stream, double *delta);
  /* Makes asp_view.data out of a profile, NULL on error, and frees it; NULL where none is needed.
   */
  void *(*prepare)(const asp_profile *profile, const asp_sizes *sizes, asp_error *error);
  void (*release)(void *data);
  /* The delta of the next face on the way of a particle that flies at view->alpha1, first or later;
   * false when it leaves the wall. NULL where the model knows of no places. */
  bool (*follow)(const asp_view *view, asp_stream *stream, asp_path *path, double *delta);
} asp_spread_model;

/* One delta of the model, from the stream; false when a loop reached its bound. */
bool asp_spread_draw(const asp_spread_model *model, const asp_view *view, asp_stream *stream,
                     double *delta);

/* All models, in a fixed order: 0 <= index < asp_spread_count(). */
int asp_spread_count(void);
const asp_spread_model *asp_spread_at(int index);

/* The model of that name; NULL and a message that lists the names there are, when there is none. */
const asp_spread_model *asp_spread_find(const char *name, asp_error *error);

/* ---- geometry: the reference that the models are measured against ------------------------------
 */

/* The path of the centre of a disc over a profile (asp_profile_dilate), as straight faces between
 * its points, periodic (a measured profile goes on as its mirror image): particles that fall on it
 * at an angle, and where they hit it, without a model. */
typedef struct asp_track asp_track;

/* For a particle of diameter 0 <= d_p <= length of the profile, which need not outlive it. NULL on
 * error. */
asp_track *asp_track_create(const asp_profile *profile, double d_p, asp_error *error);
void asp_track_free(asp_track *track);

size_t asp_track_faces(const asp_track *track);
double asp_track_slope_rms(const asp_track *track); /* s_eff of these very faces */

/* Slope of a face in the direction of flight, 0 <= face < asp_track_faces(); particles fly towards
 * larger x. */
double asp_track_face_slope(const asp_track *track, size_t face);

/* The smallest impact angle that a track of this length can tell: below it particles would see no
 * more than a handful of its peaks, and it stands for every smaller one. */
double asp_track_alpha_least(const asp_track *track);

/* The exact law of the first hit at alpha1 (0 to pi/2): the share of the particles that first touch
 * each face, into weight[asp_track_faces()], sum 1. A path is a constant value of g = D + x tan
 * alpha1, and touches where g passes its running maximum. */
void asp_track_first_hit(const asp_track *track, double alpha1, double *weight);

/* Puts a particle of an even beam in front of the track: u, 0 < u < 1, is its place in the beam. */
void asp_track_enter(const asp_track *track, double u, asp_path *path);

/* Moves the particle to the next face on its way, at an elevation of -alpha1 (from -pi/2 to pi/2;
 * negative alpha1 is a flight up), and tells the face's tilt as the particle sees it; false when it
 * leaves. */
bool asp_track_next(const asp_track *track, double alpha1, asp_path *path, double *delta);

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
  bool seen; /* whether the original of that source was seen for this */
} asp_material;

/* The presets. find: NULL and a message that lists the names, when there is none. */
int asp_material_count(void);
const asp_material *asp_material_at(int index);
const asp_material *asp_material_find(const char *name, asp_error *error);

/* A user's own materials. */
typedef struct asp_materials asp_materials;

/* Reads materials from a text file in columns, a row a material, as `asperity materials` prints
 * them: under a line of column names name, youngs_modulus_pa (> 0), poissons_ratio (-1 to 0.5),
 * density_kg_m3 (> 0), and where wanted title, yield_stress_pa (>= 0; empty: none), source, and
 * seen (yes or no). Columns are separated by commas, semicolons, tabs or blanks; # begins a
 * comment. NULL on error: ASP_EFILE, or ASP_EDATA with file and line. */
asp_materials *asp_materials_read(const char *path, asp_error *error);
void asp_materials_free(asp_materials *materials);
int asp_materials_count(const asp_materials *materials);
const asp_material *asp_materials_at(const asp_materials *materials, int index);

/* The material of that name: of the user's own (NULL: none), which go before presets of the same
 * name, or of the presets. */
const asp_material *asp_materials_find(const asp_materials *own, const char *name,
                                       asp_error *error);

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

/* Coefficients of restitution over impact angle and speed, as measured or computed by a user: on a
 * full grid of angles and speeds. Between angles a monotone cubic (Steffen 1990), between speeds a
 * straight line, so that nothing overshoots; beyond the ends the end values. */
typedef struct asp_cor_table asp_cor_table;

typedef struct asp_cor_point {
  double speed, alpha1; /* >= 0; 0 to pi/2 */
  double cor_n, cor_t;  /* >= 0; any sign. Together they make no energy */
} asp_cor_point;

/* A table of points in any order: at least two angles, every angle at every speed, each once. NULL
 * on error: ASP_EARG for a point out of range, ASP_EDATA for two points in one place or a gap. */
asp_cor_table *asp_cor_table_create(const asp_cor_point *points, size_t count, asp_error *error);

/* Reads a table from a text file with the columns alpha1_deg, cor_n, cor_t, and v1_m_s where it
 * depends on speed. metre_per_second is one m/s in the unit of the speeds that the table will be
 * asked for: 1 for SI. NULL on error; the message names the file, and the line where there is one.
 */
asp_cor_table *asp_cor_table_read(const char *path, double metre_per_second, asp_error *error);
void asp_cor_table_free(asp_cor_table *table);

/* The coefficients at a speed and an impact angle (rad). No allocation, no failure. */
void asp_cor_table_at(const asp_cor_table *table, double speed, double alpha1, double *cor_n,
                      double *cor_t);

/* One hit in the frame of the local face. */
typedef struct asp_hit {
  double v_n1; /* approach speed along the face's normal, > 0 */
  double v_t1; /* speed along the face, >= 0 */
  double d_p;
  double density;
  const asp_pair *pair;       /* may be NULL for laws that need no material */
  bool adhesion;              /* false: the law leaves the surface energy out */
  const asp_cor_table *table; /* for laws that need one */
  asp_stream *stream;         /* for laws that draw */
} asp_hit;

/* What is left of it: v_n2 >= 0, v_n2^2 + v_t2^2 <= v_n1^2 + v_t1^2; v_n2 = 0 is a deposit, where
 * the wall takes deposits. */
typedef struct asp_bounce {
  double v_n2;
  double v_t2;
} asp_bounce;

typedef struct asp_rebound_law {
  const char *name;
  const char *summary;
  const char *source;
  bool needs_material; /* whether asp_hit.pair must be given */
  bool needs_table;    /* whether asp_hit.table must be given */
  bool measured;       /* whether its coefficients were measured, and so hold roughness already */
  int n_parameters;
  const asp_parameter *parameters;
  asp_bounce (*rebound)(const double *parameters, const asp_hit *hit);
  /* Whether it draws a scatter of its own with these parameters; NULL: never. */
  bool (*scatters)(const double *parameters);
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
  ASP_COLLISIONS_SINGLE,   /* a rebound into the wall is drawn again */
  ASP_COLLISIONS_MULTIPLE, /* a rebound into the wall hits the next face, and so may one that leaves
                              a low place at a small angle: the walk in height of Heitz, Hanika,
                              d'Eon & Dachsbacher 2016 */
  ASP_COLLISIONS_SMITH     /* the same with Smith's probability to escape, which forgets how deep
                              the particle is after its first hit */
} asp_collisions;

enum { ASP_HITS_MAX = 64 }; /* draws or hits in one contact before it is called capped */

/* What a wall is made of; names are looked up once, in asp_wall_create. */
typedef struct asp_wall_spec {
  const asp_surface *surface; /* NULL: smooth; otherwise must outlive the wall */
  const asp_profile *profile; /* for models that look at one, used while the wall is made; NULL: one
                                 is generated with the surface's r_q and lambda_c */
  asp_sizes sizes;            /* the diameters that such a model prepares for */
  const char *spread;         /* name of the model */
  asp_tilt tilt;
  asp_collisions collisions;
  const char *rebound; /* name of the law */
  double parameters[ASP_PARAMETERS_MAX];
  bool deposit;               /* whether a particle may stick; false also leaves adhesion out */
  const asp_cor_table *table; /* for laws that need one; must outlive the wall */
  bool scatter_twice; /* allows a law with a scatter of its own on a rough wall; it counts the
                         roughness twice, so that asp_wall_create refuses it otherwise */
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

/* The asp_view.data that the wall's model has made of a profile, or NULL; lives as long as the
 * wall.
 */
const void *asp_wall_data(const asp_wall *wall);

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
                     const double n[3], const asp_key *key, asp_impact *impact);

/* ---- choosing a model --------------------------------------------------------------------------
 */

typedef struct asp_choice {
  const asp_spread_model *model;
  double divergence; /* its measured D_KL at worst */
  char text[400];    /* which, and why, as one line */
} asp_choice;

/* The cheapest model whose measured D_KL between its rebound angles and those of the geometry
 * (specular, bins of one degree) stays below the tolerance (> 0), for the surface's phi_r, the
 * kappas of the diameters sizes->least to sizes->most, and impact angles from alpha_least to
 * alpha_most (rad, within 0 ... pi/2). The worst of all measured points around them counts.
 * Measured for Gaussian walls: of a wall by its measured profile only phi_r and kappa are looked
 * at. ASP_EARG: an argument is out of range. ASP_ERANGE: the wall is beyond what was measured, or
 * no model stays below the tolerance; the message says which comes closest. */
asp_code asp_spread_auto(const asp_surface *surface, const asp_sizes *sizes, double alpha_least,
                         double alpha_most, asp_collisions collisions, double tolerance,
                         asp_choice *choice, asp_error *error);

/* Larger ratios, at an impact angle of nearly nothing, are told as this. */
#define ASP_RATIO_MOST 1e300

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
