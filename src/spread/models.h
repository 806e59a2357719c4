/* The record of a spread model, and the list of models. To add a model, write one file with its
 * record and add one line here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "base/stream.h"
#include "spread/flight.h"
#include "spread/sizes.h"

enum { ASP_HITS_MAX = 64 }; /* draws or hits in one contact before it is called capped */

/* The input of a spread model: one particle that approaches one wall. */
typedef struct aspi_spread_input {
  double slope;  /* s_eff, the rms slope that a particle of this size meets */
  double sigma;  /* atan(s_eff), the one number that describes the wall to the paper's models */
  double alpha1; /* impact angle, 0 <= alpha1 <= pi/2; negative, down to -pi/2, for a particle that
                    flies up after an earlier hit (models with `covers_rising` only) */
  double d_p;    /* diameter, in the surface's unit; for models of a measured wall */
  const void *data; /* made by the model when the wall was prepared, or NULL */
  double kappa;     /* of the particle along its flight; for models with geometry */
  double phi_r;     /* r_q/lambda_c along the flight; for models with geometry */
  bool has_azimuth; /* the wall has a lay, and `azimuth` (rad) is the angle from the axis across it
                       to the flight, counted toward the lay's other side: from n x lay */
  double azimuth;
} aspi_spread_input;

/* The state of a particle that a model follows over the heights of a wall; all 0 before the first
 * face. */
typedef struct aspi_path {
  bool begun;
  bool back;      /* flies toward smaller x of a profile */
  double turn;    /* angle from the previous flight to this one, from t toward b */
  int field;      /* index of a field of the model */
  double azimuth; /* over a map, from x toward y */
  aspi_spot spot;
  double p, q; /* slopes of the last face, along the flight and across it; over a map q is drawn
                  by the model */
} aspi_path;

/* The heights of a wall, or (heights NULL) its Gaussian statistics. */
typedef struct aspi_height_field {
  const asp_surface *surface;
  const asp_heights *heights;
  bool in_space; /* the profile represents an isotropic wall */
} aspi_height_field;

/* An input for models that need no more than sigma (0 <= sigma < pi/2) and alpha1. */
aspi_spread_input aspi_spread_input_of(double sigma, double alpha1);

/* A spread model: the distribution of the tilt delta_alpha of the face that is hit. Each is cut to
 * |delta_alpha| < 90 degrees and alpha1 + delta_alpha < 180 degrees (a height function has no
 * overhangs, and a particle hits only faces turned toward it) and normalized. At sigma = 0
 * delta_alpha = 0. */
struct asp_spread_model {
  const char *name;
  const char *summary; /* one line */
  const char *source;  /* author, year, equation */
  bool geometry;       /* includes the smaller slopes of summits at grazing incidence */
  bool covers_rising;  /* also covers particles that fly up: faces with delta > -alpha1; otherwise
                          `visible` covers them */
  /* Density in 1/rad and distribution at delta; NULL for `none`. */
  double (*density)(const aspi_spread_input *input, double delta);
  double (*distribution)(const aspi_spread_input *input, double delta);
  /* The delta at which the distribution is u, 0 < u < 1; NULL if the model follows particles. */
  double (*quantile)(const aspi_spread_input *input, double u);
  /* Makes aspi_spread_input.data out of the heights of a wall, NULL on error, and frees it; NULL
   * where none is needed. */
  void *(*prepare)(const aspi_height_field *of, const aspi_sizes *sizes, asp_error *error);
  void (*release)(void *data);
  /* The delta of the next face on the way of a particle that flies at input->alpha1, first or
   * later; false when it leaves the wall. NULL for models without positions. */
  bool (*follow)(const aspi_spread_input *input, aspi_stream *stream, aspi_path *path,
                 double *delta);
  /* The heights over which it follows those of a diameter, over the map or over each profile; NULL:
   * there is no such part. NULL for models without positions. */
  const aspi_field *(*field)(const void *data, int bin, int part);
};

/* One delta of the model, from the stream: a first face where it follows particles; false if there
 * is none. */
bool aspi_spread_draw(const asp_spread_model *model, const aspi_spread_input *input,
                      aspi_stream *stream, double *delta);

#define ASP_SPREAD_MODELS(X)                                                                       \
  X(none)                                                                                          \
  X(normal)                                                                                        \
  X(rejection)                                                                                     \
  X(effective)                                                                                     \
  X(truncated)                                                                                     \
  X(weibull)                                                                                       \
  X(visible)                                                                                       \
  X(profile)                                                                                       \
  X(traced)

#define ASP_SPREAD_DECLARE(name) extern const asp_spread_model aspi_spread_##name;
ASP_SPREAD_MODELS(ASP_SPREAD_DECLARE)
#undef ASP_SPREAD_DECLARE

/* Below this sigma (rad) a wall is smooth to the last bit, and alpha1/sigma could overflow. */
#define ASP_SIGMA_ZERO 1e-290

/* No face of a height function is steeper than this. With alpha1 <= 90 degrees it also is the
 * steepest face that a particle can hit: 180 degrees - alpha1 is never less. */
#define ASP_DELTA_MOST (ASP_PI / 2)

/* The normal distribution with mean 0 and sd sigma > 0, cut to lo <= delta <= hi with lo <= 0 < hi,
 * and normalized (eq. 5). The quantile uses the complementary form in the upper half, so that it
 * keeps its digits for u near 1, and never leaves [lo, hi]. */
double aspi_cut_normal_density(double sigma, double lo, double hi, double delta);
double aspi_cut_normal_distribution(double sigma, double lo, double hi, double delta);
double aspi_cut_normal_quantile(double sigma, double lo, double hi, double u);

/* The Weibull distribution for sigma > 0 and alpha1, both in rad; see weibull.c: delta = b + lambda
 * y, where y >= 0 has the distribution 1 - exp(-y^k). */
typedef struct aspi_weibull {
  double b, k, lambda;
} aspi_weibull;
aspi_weibull aspi_weibull_at(double sigma, double alpha1);

/* The law that `truncated` and `rejection` share. */
double aspi_truncated_density(const aspi_spread_input *input, double delta);
double aspi_truncated_distribution(const aspi_spread_input *input, double delta);
double aspi_truncated_quantile(const aspi_spread_input *input, double u);
