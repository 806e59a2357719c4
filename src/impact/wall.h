/* What a wall keeps for its contacts. */
#ifndef ASP_IMPACT_WALL_H
#define ASP_IMPACT_WALL_H

#include "asperity.h"

struct asp_wall {
  const asp_surface *surface;
  const asp_spread_model *spread;
  const asp_rebound_law *law;
  double parameters[ASP_PARAMETERS_MAX];
  bool rough; /* false: smooth, and nothing is drawn */
  bool isotropic;
  bool multiple;
  bool deposit;
};

#endif
