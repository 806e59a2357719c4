/* Constants that are allowed and still look like a mistake.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/quantity.h"
#include "description/description.h"

#include <math.h>
#include <stdio.h>

/* A yield stress that is a larger share of the modulus is beyond all solids: then the modulus is
 * probably one that was made soft for a longer step. */
#define YIELD_MOST 0.1

/* Pa: no solid is as soft, and every modulus in GPa is less. */
#define YOUNGS_LEAST 1e4

/* A particle's density may be this share off that of its material. */
#define DENSITY_OFF 0.01

/* Speeds at which an impact is tried, in m/s; over the range of all that flies. */
#define SPEED_LEAST 1e-3
#define SPEED_MOST 1e4
enum { SPEEDS = 64 };

typedef struct question {
  const asp_description *d;
  const asp_particle *particle;
  const asp_material *material[2]; /* of the particle and of the wall */
  char *text;
  size_t size;
} question;

static bool yields_never(const question *q) {
  const asp_pair *pair = q->particle->pair;
  if (!pair || asp_description_get(q->d, "yield_rate") > 0 ||
      !(pair->yield_stress > YIELD_MOST * pair->modulus))
    return false;
  snprintf(q->text, q->size,
           "the yield stress, %g, is %.3g times the composite modulus, %g, so that nothing yields; "
           "is the modulus one that was made soft for the pair style? 'materials' takes real ones",
           pair->yield_stress, pair->yield_stress / pair->modulus, pair->modulus);
  return true;
}

static bool has_other_density(const question *q) {
  double own = q->particle->density, density = q->material[0]->density;
  if (!(own > 0 && density > 0))
    return false;
  double off = fabs(own / density - 1);
  if (!(off > DENSITY_OFF))
    return false;
  snprintf(q->text, q->size,
           "the density of particles is up to %.3g %% off that of material '%s', %g; theirs is "
           "taken",
           100 * off, q->material[0]->name, density);
  return true;
}

static bool is_in_gpa(const question *q, int which) {
  double pascal = aspi_quantity_factor("stress", &q->d->units);
  const asp_material *m = q->material[which];
  if (!(pascal > 0) || !(m->youngs_modulus < YOUNGS_LEAST * pascal))
    return false;
  snprintf(q->text, q->size,
           "Young's modulus of %s is %g, which is %g Pa; is it one in GPa? It must be in the "
           "script's unit of stress",
           m->name, m->youngs_modulus, m->youngs_modulus / pascal);
  return true;
}

static bool particle_in_gpa(const question *q) {
  return is_in_gpa(q, 0);
}

static bool wall_in_gpa(const question *q) {
  return is_in_gpa(q, 1);
}

/* Normal impacts at all speeds; oblique ones have less normal speed. */
static bool sticks_always(const question *q) {
  const asp_units *units = &q->d->units;
  const asp_rebound_law *law = q->d->choice.law;
  double speed = aspi_quantity_factor("speed", units);
  if (!law->needs_pair || !q->particle->pair || !(speed > 0) || !(q->particle->d_p > 0) ||
      !(q->particle->density > 0) || !q->d->choice.deposit ||
      aspi_flow_removes(&q->d->choice.flow, q->particle))
    return false;
  for (int i = 0; i < SPEEDS; i++) {
    double v = SPEED_LEAST * pow(SPEED_MOST / SPEED_LEAST, i / (SPEEDS - 1.0)) * speed;
    aspi_hit hit = {.v_n1 = v,
                    .d_p = q->particle->d_p,
                    .density = q->particle->density,
                    .pair = q->particle->pair,
                    .adhesion = true};
    if (law->rebound(q->d->choice.parameters, &hit).v_n2 > 0)
      return false;
  }
  snprintf(q->text, q->size,
           "every impact of particles of diameter %g and less sticks, whatever its speed: the "
           "surface energy, %g, is too much for a yield stress of %g",
           q->particle->d_p, q->particle->pair->surface_energy, q->particle->pair->yield_stress);
  return true;
}

bool asp_description_doubt(const asp_description *d, const asp_particle *particle,
                           const asp_material *of_particle, const asp_material *of_wall, int index,
                           char *text, size_t size) {
  static bool (*const doubts[])(const question *q) = {has_other_density, particle_in_gpa,
                                                      wall_in_gpa, yields_never, sticks_always};
  const question q = {d, particle, {of_particle, of_wall}, text, size};
  for (size_t i = 0; i < sizeof doubts / sizeof *doubts; i++)
    if (doubts[i](&q) && index-- == 0)
      return true;
  return false;
}
