/* A wall as its contacts read it, and the choice that it is made of.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"
#include "erosion/laws.h"
#include "rebound/heat.h"
#include "rebound/laws.h"
#include "rebound/removal.h"
#include "spread/models.h"
#include "wall/valleys.h"

/* The parts of a wall. The caller keeps ownership. */
typedef struct aspi_wall_choice {
  const asp_surface *surface; /* NULL: smooth */
  const asp_heights *heights; /* NULL: a profile is generated where the model needs one */
  const asp_spread_model *spread;
  aspi_sizes sizes; /* of the particles, for models with tables; one bin where both are equal */
  bool isotropic, multiple;
  const asp_rebound_law *law;
  double parameters[ASP_PARAMETERS_MAX];
  const aspi_cor_table *table;
  const asp_pair *pair; /* for particles without a pair; may be NULL */
  bool deposit;
  aspi_flow flow; /* takes away what sticks */
  aspi_erosion erosion;
  double lever;   /* sd of the center of mass of grains per axis and diameter; 0: spheres */
  double scatter; /* sd of the logarithm of yield stresses over the material's; 0: all alike */
  bool has_lay;
  double lay[3]; /* its direction */
  uint32_t seed;
  aspi_heat heat;
} aspi_wall_choice;

/* A measured wall: doubts about its file, and its points. */
typedef struct aspi_wall_heights {
  asp_error doubt;
  double spacing, length, lambda; /* the widest, the shortest, the longest; spacing 0: no points */
} aspi_wall_heights;

struct asp_wall {
  asp_surface *surface;  /* a copy; NULL: smooth */
  aspi_cor_table *table; /* alike */
  asp_pair *pair;        /* alike */
  const asp_spread_model *spread;
  const asp_spread_model *rising; /* for particles that fly up, where `spread` has no law */
  void *data;                     /* of the model */
  bool (*follow)(const aspi_spread_input *input, aspi_stream *stream, aspi_path *path,
                 double *delta);
  aspi_valleys *valleys; /* of the heights that the model follows; NULL: Gaussian */
  bool has_cross_slope;  /* the model draws the slope across the flight, too */
  const asp_rebound_law *law;
  double parameters[ASP_PARAMETERS_MAX];
  bool rough; /* false: smooth, and nothing is drawn */
  bool isotropic;
  bool multiple; /* a particle that a face sends into the wall flies on to the next face */
  bool deposit;
  bool spins;     /* the law turns the particle */
  aspi_flow flow; /* takes away what sticks */
  aspi_erosion erosion;
  double lever, scatter;
  aspi_heat *heat; /* a copy */
  bool varies;     /* each grain has its own yield stress or adhesion, or its heat counts */
  bool has_lay;
  double lay[3];
  uint32_t seed;
  aspi_wall_heights heights;
};

/* A smooth wall with `bons` and its defaults, in the plane. */
aspi_wall_choice aspi_wall_choice_smooth(void);

/* Chooses a law with its defaults. */
void aspi_wall_choose_law(aspi_wall_choice *choice, const asp_rebound_law *law);

/* Checks a choice and makes its wall; NULL on error. */
asp_wall *aspi_wall_create(const aspi_wall_choice *choice, asp_error *error);

/* Replaces the wall by another one, whose struct is freed. */
void aspi_wall_replace(asp_wall *wall, asp_wall *by);

/* Replaces the law, deposit and erosion settings; keeps the surface and its tables. */
void aspi_wall_take_law(asp_wall *wall, const aspi_wall_choice *choice);
