/* Constants that are allowed and still look like a mistake.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/quantity.h"
#include "description/description.h"
#include "surface/instrument.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A yield stress that is a larger share of the modulus is beyond all solids: then the modulus is
 * probably one that was made soft for a longer step. */
#define YIELD_MOST 0.1

/* Pa: no solid is as soft, and every modulus in GPa is less. */
#define YOUNGS_LEAST 1e4

/* A particle's density may be this share off that of its material. */
#define DENSITY_OFF 0.01

/* Pa: a hardness under this is one in GPa or MPa. */
#define HARDNESS_LEAST 1e6

/* Heights over this many diameters are probably in another unit; no pair has more friction. */
#define DIAMETERS_MOST 1e3
#define FRICTION_MOST 3

/* Speeds at which an impact is tried, in m/s; over the range of all that flies. */
#define SPEED_LEAST 1e-3
#define SPEED_MOST 1e4
enum { SPEEDS = 64 };

/* Relative precision of a critical speed. */
#define PRECISION 1e-4

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

/* True if a normal impact at v sticks; oblique ones have less normal speed. */
static bool sticks_at(const asp_description *d, const asp_particle *particle, double v) {
  aspi_hit hit = {.v_n1 = v,
                  .d_p = particle->d_p,
                  .density = particle->density,
                  .pair = particle->pair,
                  .adhesion = true};
  return !(d->choice.law->rebound(d->choice.parameters, &hit).v_n2 > 0);
}

double asp_description_capture_speed(const asp_description *d, const asp_particle *particle) {
  double unit = aspi_quantity_factor("speed", &d->units);
  if (!d->choice.law->needs_pair || !particle->pair || !(unit > 0) || !(particle->d_p > 0) ||
      !(particle->density > 0) || !d->choice.deposit ||
      aspi_flow_removes(&d->choice.flow, particle))
    return 0;
  double low = SPEED_LEAST * unit, step = pow(SPEED_MOST / SPEED_LEAST, 1 / (SPEEDS - 1.0));
  if (!sticks_at(d, particle, low))
    return 0;
  int i = 1;
  while (i < SPEEDS && sticks_at(d, particle, low * step)) {
    low *= step;
    i++;
  }
  if (i == SPEEDS)
    return INFINITY;
  for (double high = low * step; high > (1 + PRECISION) * low;) {
    double middle = sqrt(low * high);
    *(sticks_at(d, particle, middle) ? &low : &high) = middle;
  }
  return low;
}

static bool sticks_always(const question *q) {
  if (!isinf(asp_description_capture_speed(q->d, q->particle)))
    return false;
  snprintf(q->text, q->size,
           "every impact of particles of diameter %g and less sticks, whatever its speed: the "
           "surface energy, %g, is too much for a yield stress of %g",
           q->particle->d_p, q->particle->pair->surface_energy, q->particle->pair->yield_stress);
  return true;
}

/* ---- the description alone ---- */

static bool is_high(const question *q) {
  if (!(q->d->r_q > DIAMETERS_MOST * q->particle->d_p && q->particle->d_p > 0))
    return false;
  snprintf(q->text, q->size,
           "rq is %g, %.3g times the diameter of the largest particle, %g; is it in another unit?",
           q->d->r_q, q->d->r_q / q->particle->d_p, q->particle->d_p);
  return true;
}

static bool rubs_much(const question *q) {
  if (!(q->d->friction > FRICTION_MOST))
    return false;
  snprintf(q->text, q->size, "friction is %g; it is a coefficient, mostly under 1, no angle",
           q->d->friction);
  return true;
}

static bool is_soft(const question *q) {
  const aspi_erosion *erosion = &q->d->choice.erosion;
  const asp_parameter *p = erosion->law ? &erosion->law->parameters[0] : NULL;
  if (!p || strcmp(p->unit, "stress") != 0 || !(erosion->si[0] < HARDNESS_LEAST))
    return false;
  snprintf(q->text, q->size, "%s is %g, which is %g Pa; is it one in GPa or MPa?", p->name,
           erosion->given[0], erosion->si[0]);
  return true;
}

static bool has_no_sampling(const question *q) {
  double length = q->d->r_sm;
  if (!(length > 0))
    return false;
  snprintf(q->text, q->size,
           "rsm depends on the sampling length: lambda_c is taken as %.3g and may be %.3g to %.3g; "
           "say 'sampling LR', or rather rdq",
           q->d->lambda_c, length / aspi_r_sm_factor(ASPI_RSM_MOST),
           length / aspi_r_sm_factor(ASPI_RSM_LEAST));
  return true;
}

bool asp_description_doubt(const asp_description *d, const asp_particle *particle,
                           const asp_material *of_particle, const asp_material *of_wall, int index,
                           char *text, size_t size) {
  enum { ALONE = 4 };
  static bool (*const doubts[])(const question *q) = {
      is_high,         rubs_much,   is_soft,      has_no_sampling, has_other_density,
      particle_in_gpa, wall_in_gpa, yields_never, sticks_always};
  const question q = {d, particle, {of_particle, of_wall}, text, size};
  const bool alone = !of_particle || !of_wall;
  const size_t end = alone ? ALONE : sizeof doubts / sizeof *doubts;
  for (size_t i = alone ? 0 : ALONE; i < end; i++)
    if (doubts[i](&q) && index-- == 0)
      return true;
  return false;
}
