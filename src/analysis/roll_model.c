/* A sphere on a rough slope, by the wall's model: contacts on the mean wall, in time steps as an
 * engine takes them. The rule is that of src/dem/step/faces.cpp, for one plane, by the same
 * functions of the wall. A valley that holds the sphere holds it for good.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/roll.h"

#include <math.h>

static const double up[3] = {0, 0, 1};

/* The draws of impacts, and of a sphere that stays. */
enum { WALL_KEY = 1, STAY_KEY = 2 };

typedef struct grain {
  const aspi_slope *slope;
  double press, push; /* gravity's parts into the wall and along it */
  double x[2], face[2], v[3], omega[3], time;
  asp_valley valley; /* behind the face; 0: not drawn yet */
  asp_key hit, stay;
  bool flies;
} grain;

static asp_particle particle_of(const grain *g) {
  asp_particle particle = g->slope->particle;
  for (int d = 0; d < 3; d++)
    particle.omega[d] = g->omega[d];
  return particle;
}

/* True if the sphere sticks. */
static bool take(grain *g, const asp_impact *impact) {
  for (int d = 0; d < 3; d++) {
    g->v[d] = impact->v2[d];
    g->omega[d] = impact->omega[d];
  }
  return impact->outcome == ASP_DEPOSIT;
}

/* Coulomb's friction, for what is pressed into the wall per mass: the sphere slides, or rolls. */
static void rub(grain *g, double pressed) {
  double r = g->slope->particle.d_p / 2;
  double u[2] = {g->v[0] - r * g->omega[1], g->v[1] + r * g->omega[0]}, speed = hypot(u[0], u[1]);
  double share = speed > 0 ? fmin(g->slope->friction * pressed / speed, 2. / 7) : 0;
  for (int d = 0; d < 2; d++)
    g->v[d] -= share * u[d];
  g->omega[1] += 2.5 / r * share * u[0];
  g->omega[0] -= 2.5 / r * share * u[1];
}

/* Moves the sphere to its next contact: a step on along the wall, or to the end of its flight. True
 * if it stays at the wall. */
static bool move(grain *g, double step) {
  double dt = g->flies ? 2 * g->v[2] / g->press : step;
  if (!g->flies) {
    g->v[0] += g->push * dt;
    rub(g, g->press * dt);
  }
  g->x[0] += (g->v[0] + (g->flies ? 0.5 * g->push * dt : 0)) * dt;
  g->x[1] += g->v[1] * dt;
  g->time += dt;
  if (!g->flies)
    return true;
  g->v[0] += g->push * dt;
  g->v[2] = -g->v[2];
  return -g->v[2] <= 0.5 * g->press * step;
}

static void draw_valley(grain *g) {
  asp_particle particle = particle_of(g);
  if (g->valley.start > 0)
    return;
  g->stay.impact++;
  g->valley = asp_wall_valley(g->slope->wall, &particle, g->v, up, &g->stay);
}

/* True if the sphere cannot leave its valley. */
static bool lies(const grain *g) {
  double r = g->slope->particle.d_p / 2, steep = g->push / (g->press * g->valley.start);
  double energy = 0.5 * (g->v[0] * g->v[0] + g->v[1] * g->v[1]) +
                  0.2 * r * r * (g->omega[0] * g->omega[0] + g->omega[1] * g->omega[1]);
  return steep < 1 &&
         energy < g->press * g->valley.height * (sqrt(1 - steep * steep) - steep * acos(steep));
}

/* The contact that the sphere has come to. True if it stops there: it sticks, or a valley holds it.
 */
static bool meet(grain *g, bool stays) {
  const asp_wall *wall = g->slope->wall;
  asp_particle particle = particle_of(g);
  asp_impact impact;
  double way[3] = {g->x[0] - g->face[0], g->x[1] - g->face[1], 0};
  bool moved = hypot(way[0], way[1]) >= asp_wall_face_length(wall, &particle, way, up);
  if (moved) {
    g->face[0] = g->x[0];
    g->face[1] = g->x[1];
    g->valley.start = 0;
  }
  if (moved && !stays) {
    g->hit.impact++;
    asp_wall_impact(wall, &particle, g->v, up, &g->hit, &impact);
    return take(g, &impact);
  }
  draw_valley(g);
  bool held = lies(g);
  if (!stays && 0.5 * g->v[2] * g->v[2] >= g->press * g->valley.height) {
    if (held)
      g->v[0] = g->v[1] = particle.omega[0] = particle.omega[1] = 0;
    asp_wall_impact_mean(wall, &particle, g->v, up, &g->hit, &impact);
    return take(g, &impact);
  }
  rub(g, -g->v[2]);
  g->v[2] = 0;
  g->stay.impact += moved;
  if (moved && !held &&
      asp_wall_impact_grazing(wall, &particle, g->v, up, g->press, &g->stay, &impact))
    return take(g, &impact);
  return held;
}

aspi_roll aspi_slope_roll(const aspi_slope *slope, double step, double duration, uint64_t tag) {
  double unit = aspi_slope_time(slope), half = 0.5 * duration * unit, x = 0, at = 0;
  double speed = ASPI_ROLL_SPEED * aspi_slope_speed(slope);
  grain g = {.slope = slope,
             .press = slope->gravity * cos(slope->angle),
             .push = slope->gravity * sin(slope->angle),
             .v = {speed, 0, 0},
             .omega = {0, 2 * speed / slope->particle.d_p, 0},
             .hit = {1, WALL_KEY, tag, 0},
             .stay = {1, STAY_KEY, tag, 0}};
  while (g.time < 2 * half) {
    bool stays = move(&g, step * unit);
    if (meet(&g, stays))
      return (aspi_roll){0, true};
    g.flies = g.v[2] > 0.5 * g.press * step * unit;
    if (!g.flies)
      g.v[2] = 0;
    if (!(at > 0) && g.time >= half) {
      at = g.time;
      x = g.x[0];
    }
  }
  return (aspi_roll){(g.x[0] - x) / (g.time - at), false};
}
