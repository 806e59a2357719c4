/* The list of the rebound laws, and their record. To add a law, write one file with its record and
 * add one line here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "base/keyword.h"
#include "base/stream.h"
#include "rebound/cor_table.h"
#include "rebound/materials.h"

#include <math.h>

enum { ASP_PARAMETERS_MAX = 8 };

/* One hit in the frame of the local face. */
typedef struct aspi_hit {
  double v_n1; /* approach speed along the face's normal, > 0 */
  double v_t1; /* speed along the face, >= 0 */
  double u_t1; /* speed of the particle's surface at the contact; v_t1 without spin */
  double d_p;
  double density;
  const asp_pair *pair;        /* may be NULL for laws that need no material */
  bool adhesion;               /* false: the law leaves the surface energy out */
  const aspi_cor_table *table; /* for laws that need one */
  aspi_stream *stream;         /* for laws that draw */
  double temperature;          /* of the particle, K; 0: unknown, cold */
} aspi_hit;

/* Velocities after a hit: v_n2 >= 0, v_n2^2 + v_t2^2 <= v_n1^2 + v_t1^2; v_n2 = 0 is a deposit,
 * where the wall takes deposits. A law that turns the particle gives, instead of v_t2, the impulse
 * along the face per mass, against the velocity of the particle's surface: 0 <= rub <= (4/7) u_t1,
 * where the energy of flight and spin together does not grow. */
typedef struct aspi_bounce {
  double v_n2;
  double v_t2;
  double rub;
  double friction; /* for bodies: impulse along the face over that normal to it while it slides */
} aspi_bounce;

/* The friction of a law that gives the speed v_t2 only; at most 1e9. */
static inline double aspi_bounce_friction(const aspi_hit *hit, double v_n2, double v_t2) {
  double along = fmax(0, hit->v_t1 - v_t2), normal = hit->v_n1 + v_n2;
  return normal > 1e-9 * along ? along / normal : 1e9;
}

/* Impulse per mass that stops the surface of a solid sphere, over the surface's speed: along the
 * face the contact point moves as if the sphere had 2/7 of its mass. */
#define ASPI_ROLLING (2.0 / 7)

/* The largest diameter for adhesion of smooth spheres, in m. Larger grains touch the wall on a few
 * asperities, which hold them far less (an estimate of this project). */
#define ASPI_ADHESIVE_MOST 200e-6

struct asp_rebound_law {
  const char *name;
  const char *summary;
  const char *source;
  bool needs_pair;        /* whether aspi_hit.pair must be given */
  bool needs_table;       /* whether aspi_hit.table must be given */
  bool measured;          /* coefficients measured on a wall, so they include its roughness */
  double d_least, d_most; /* range of diameters for its adhesion, m; 0: no adhesion */
  int n_parameters;
  const aspi_keyword *parameters;
  aspi_bounce (*rebound)(const double *parameters, const aspi_hit *hit);
  /* Yield stress at a temperature over the cold one; NULL: 1. */
  double (*softening)(const double *parameters, double temperature);
  /* True if the law draws scatter itself with these parameters; NULL: never. */
  bool (*scatters)(const double *parameters);
  /* True if the contact is compliant along the face with these parameters, which is not implemented
   * for bodies; NULL: never. */
  bool (*is_compliant)(const double *parameters);
  /* True if it turns the particle with these parameters; NULL: never. */
  bool (*spins)(const double *parameters);
};

/* Index of the law's parameter of that name; -1: it has none. */
int aspi_rebound_parameter_find(const asp_rebound_law *law, const char *name);

/* ASP_EARG and a message if the law has no meaning for bodies with these parameters. */
asp_code aspi_rebound_check_bodies(const asp_rebound_law *law, const double *parameters,
                                   asp_error *error);

/* A law that does so with all parameters. */
static inline bool aspi_rebound_always(const double *parameters) {
  return parameters;
}

#define ASP_REBOUND_LAWS(X)                                                                        \
  X(bons)                                                                                          \
  X(constant) X(grant_tabakoff) X(table) X(thornton_ning) X(walton)

#define ASP_REBOUND_DECLARE(name) extern const asp_rebound_law aspi_rebound_##name;
ASP_REBOUND_LAWS(ASP_REBOUND_DECLARE)
#undef ASP_REBOUND_DECLARE

/* Limits the rebound to the speed of the hit and keeps its direction: measured coefficients may
 * create energy at some angles. */
static inline aspi_bounce aspi_bounce_capped(const aspi_hit *hit, double cor_n, double cor_t) {
  double n1 = hit->v_n1, t1 = hit->v_t1, n2 = cor_n * n1, t2 = cor_t * t1;
  double before = n1 * n1 + t1 * t1, after = n2 * n2 + t2 * t2;
  if (after <= before)
    return (aspi_bounce){n2, t2, 0, aspi_bounce_friction(hit, n2, t2)};
  double scale = sqrt(before / after);
  n2 *= scale;
  t2 *= scale;
  return (aspi_bounce){n2, t2, 0, aspi_bounce_friction(hit, n2, t2)};
}
