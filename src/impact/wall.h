/* What a wall keeps for its contacts. */
#ifndef ASP_IMPACT_WALL_H
#define ASP_IMPACT_WALL_H

#include "asperity.h"

struct asp_wall {
  const asp_surface *surface;
  const asp_spread_model *spread;
  const asp_spread_model *upward; /* for particles that fly up, where `spread` has no law */
  void *data;                     /* of the model */
  const asp_rebound_law *law;
  double parameters[ASP_PARAMETERS_MAX];
  const asp_cor_table *table;
  bool rough; /* false: smooth, and nothing is drawn */
  bool isotropic;
  bool multiple; /* a particle that a face sends into the wall goes on to the next face */
  bool forgets;  /* ASP_COLLISIONS_SMITH */
  bool deposit;
};

#endif
