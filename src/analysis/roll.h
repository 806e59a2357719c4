/* A sphere on a rough slope: the reference by geometry, for grains that stay on a wall. The
 * slope falls toward x.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_ROLL_H
#define ASP_ANALYSIS_ROLL_H

#include "asperity_front.h"
#include "surface/ball.h"

/* A slope and its sphere. The wall's law must turn particles. */
typedef struct aspi_slope {
  const asp_wall *wall;
  asp_particle particle;
  double friction;                 /* Coulomb's, of a sphere that stays at the mean wall */
  double lambda_c, gravity, angle; /* angle in rad */
} aspi_slope;

/* Units of time and speed of the slope: sqrt(lambda_c/gravity), sqrt(lambda_c gravity). */
double aspi_slope_time(const aspi_slope *slope);
double aspi_slope_speed(const aspi_slope *slope);

/* Mean speed along the slope in the last half of the motion; `stopped`: none. */
typedef struct aspi_roll {
  double speed;
  bool stopped;
} aspi_roll;

/* Where the center of a sphere may be: above a profile, or above a periodic map. */
typedef struct aspi_ground {
  asp_profile *path; /* of the center */
  asp_map *map;      /* if path is NULL */
  aspi_ball *ball;
} aspi_ground;

/* A generated wall under spheres of diameter d_p: a surface (in_space), or a profile. To be freed,
 * also after an error. */
asp_code aspi_ground_create(aspi_ground *ground, double r_q, double lambda_c, double d_p,
                            bool in_space, uint32_t seed, asp_error *error);
void aspi_ground_free(aspi_ground *ground);

/* A sphere on the ground: its center, velocity and spin. */
typedef struct aspi_sphere {
  double x[3], v[3], omega[3], time;
  aspi_ball_search way;
  bool stuck; /* the law has deposited it */
} aspi_sphere;

/* At rest, in touch with the ground at (x, y). */
aspi_sphere aspi_sphere_place(const aspi_ground *ground, double x, double y);

/* Moves it by one short step. */
void aspi_sphere_step(const aspi_ground *ground, const aspi_slope *slope, aspi_sphere *sphere);

/* A sphere that begins to roll at (x, y), with ASPI_ROLL_SPEED sqrt(lambda_c gravity), for that
 * time in units of sqrt(lambda_c/gravity). */
#define ASPI_ROLL_SPEED 1.5
aspi_roll aspi_ground_roll(const aspi_ground *ground, const aspi_slope *slope, double x, double y,
                           double duration);

/* Tangent of the slope at which a sphere that lies near (x, y) rolls away, as the slope rises
 * slowly from 0; s_eff is that of the wall. INFINITY: it stays beyond 45 degrees. */
double aspi_ground_start(const aspi_ground *ground, const aspi_slope *slope, double x, double y,
                         double s_eff);

/* The motion by the model of the wall, which must be rough; time steps are in units of
 * sqrt(lambda_c/gravity). */
aspi_roll aspi_slope_roll(const aspi_slope *slope, double step, double duration, uint64_t tag);

#endif
