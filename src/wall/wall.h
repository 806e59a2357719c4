/* The state of a wall: what was chosen and set, and what its contacts read.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_WALL_WALL_H
#define ASP_WALL_WALL_H

#include "erosion/laws.h"
#include "rebound/laws.h"
#include "rebound/removal.h"
#include "spread/models.h"

/* Numbers of a wall that are no parameters of its law. */
enum {
  ASP_WALL_DEPOSIT,
  ASP_WALL_SCATTER_TWICE,
  ASP_WALL_REMOVE_U_TAU,
  ASP_WALL_REMOVE_GAS_DENSITY,
  ASP_WALL_REMOVE_MEAN_FREE_PATH,
  ASP_WALL_REMOVE_WORK,
  ASP_WALL_D_P_LEAST,
  ASP_WALL_D_P_MOST,
  ASP_WALL_D_P_BINS,
  ASP_WALL_NUMBERS
};

/* The wall as the user states it. */
typedef struct aspi_wall_choice {
  const asp_surface *surface; /* NULL: smooth */
  const asp_map *map;         /* goes before the profile */
  const asp_profile *profile; /* NULL: one is generated where the model needs one */
  const aspi_cor_table *table;
  const asp_spread_model *spread;
  const asp_rebound_law *law;
  bool isotropic, multiple;
  double parameters[ASP_PARAMETERS_MAX];
  double numbers[ASP_WALL_NUMBERS];
  aspi_erosion erosion;
} aspi_wall_choice;

typedef struct aspi_description aspi_description;

struct asp_wall {
  aspi_wall_choice choice;
  aspi_description *said; /* NULL: not made of a description */
  /* asp_wall_prepare derives the members below. */
  const asp_surface *surface;
  const asp_spread_model *spread;
  const asp_spread_model *upward; /* for particles that fly up, where `spread` has no law */
  void *data;                     /* of the model */
  bool (*follow)(const aspi_view *view, aspi_stream *stream, aspi_path *path, double *delta);
  bool draws_q; /* the model draws the slope across the flight, too */
  const asp_rebound_law *law;
  double parameters[ASP_PARAMETERS_MAX];
  const aspi_cor_table *table;
  bool rough; /* false: smooth, and nothing is drawn */
  bool isotropic;
  bool multiple; /* a particle that a face sends into the wall flies on to the next face */
  bool deposit;
  bool spins;     /* the law turns the particle */
  aspi_flow flow; /* takes away what sticks */
  aspi_erosion erosion;
};

/* Takes over the law, its parameters and the other numbers as they have been set since
 * asp_wall_prepare; surface, profile, map and model stay as they were then. */
asp_code aspi_wall_renew(asp_wall *wall, asp_error *error);

#endif
