/* Sweeps the extremes of everything that a contact depends on, together: extremes COUNT [SEED
 * [FIRST]]. `extremes 1 SEED NUMBER` repeats the combination of that number.
 *
 * Each of COUNT random combinations of particle, material, law, wall, velocity and normal is one
 * contact, and one more with an input changed by 1e-8 of itself; for one in four by 1e-2, and where
 * that makes a large change, the interval is halved toward it until it is as short. Checked: no
 * invalid operation, division by zero or overflow anywhere (they trap), nothing NaN or infinite,
 * energy does not grow, the particle leaves the wall or is deposited, and a small change makes a
 * small change. Where it does not, the jump is put down to the place where the law has one; the
 * table of places is the output, and a jump without a place is a failure.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE
#include "base/tolerances.h"
#include "wall/wall.h"
#include "random.h"
#include "surface/heights.h"

#include <fenv.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define CHANGE 1e-8
#define CHANGE_FAR 1e-2
#define JUMP 1e-2
#define JUMP_FAR 5e-2
#define ENERGY 1e-13
#define U_LEAST 1.1102230246251565e-16 /* 2^-53, and the largest number under 1 */
#define U_MOST (1 - U_LEAST)

enum { SLOPES = 17, MODELS_MOST = 32, HALVINGS = 20 };

typedef enum place {
  CAPTURE,
  NORMAL_IMPACT,
  OTHER_FACE,
  OTHER_HITS,
  LATER_FACE,
  APPROACH,
  PLACES
} place;

static const char *const place_names[PLACES] = {
    "capture: the deposited particle loses its tangential speed at once",
    "normal impact: under v_T1 = 1e-12 v_1 the direction is drawn",
    "another face: a draw is refused, or the model has a step",
    "another number of hits",
    "a later hit, on another face or after a steep path",
    "grazing to the last bit: the particle approaches or it does not",
};

typedef struct tally {
  long count[PLACES];
  double worst[PLACES];
  long deposits, capped;
} tally;

/* One combination of everything. */
typedef struct combination {
  uint64_t number;
  double slope; /* tan sigma */
  asp_wall wall;
  asp_pair pair;
  asp_particle particle;
  double v1[3], n[3];
  asp_key key;
} combination;

static asp_surface *surfaces[SLOPES];
static asp_wall *walls[MODELS_MOST][SLOPES];
static asp_spread_model forced[MODELS_MOST];
static aspi_cor_table *table;

/* Of this thread: the u that a forced model takes, the model behind it, the combination at work. */
static _Thread_local double u_forced;
static _Thread_local const asp_spread_model *behind;
static _Thread_local const combination *at_work;

static double forced_quantile(const aspi_spread_input *input, double u) {
  (void)u;
  return behind->quantile(input, u_forced);
}

/* The walls of one slope, of every model. */
static bool make_walls_of(int i, double slope) {
  asp_error error;
  asp_heights *profile = aspi_profile_generate(slope / sqrt(2), 1, 1. / 32, 2048, 1, NULL);
  surfaces[i] = asp_surface_create(slope / sqrt(2), 1, &error);
  bool made = surfaces[i];
  for (int k = 0; k < asp_spread_count() && made; k++) {
    aspi_wall_choice choice = aspi_wall_choice_smooth();
    choice.surface = surfaces[i];
    choice.heights = profile;
    choice.spread = asp_spread_at(k);
    choice.sizes = (aspi_sizes){1, 1, 1};
    walls[k][i] = aspi_wall_create(&choice, &error);
    made = walls[k][i];
  }
  asp_heights_free(profile);
  if (!made)
    fprintf(stderr, "slope %g: %s\n", slope, error.text);
  return made;
}

static double slope_at(int i) {
  return i < 16 ? pow(10, i - 15) : tan(54 * ASP_PI / 180);
}

/* Walls of every model and slope: tan sigma from 1e-15 to 1, and the largest sigma, 54 degrees. */
static bool make_walls(void) {
  for (int k = 0; k < asp_spread_count(); k++) {
    forced[k] = *asp_spread_at(k);
    forced[k].quantile = forced_quantile;
  }
  for (int i = 0; i < SLOPES; i++)
    if (!make_walls_of(i, slope_at(i)))
      return false;
  static const aspi_cor_point points[] = {{1e-3, 0, 1, 1},     {1e-3, 0.7, 0.9, 0.7},
                                          {1e-3, 1.5, 0.5, 1}, {1e3, 0, 1, 1},
                                          {1e3, 0.7, 0.2, 0},  {1e3, 1.5, 0, -0.5}};
  table = aspi_cor_table_create(points, 6, NULL);
  return table != NULL;
}

static int one_of(aspi_stream *s, int count) {
  return (int)(aspi_stream_uniform(s) * count);
}

static void choose_law(aspi_stream *s, asp_wall *wall) {
  int which = one_of(s, 2) ? 0 : one_of(s, asp_rebound_count());
  wall->law = asp_rebound_at(which);
  wall->table = table;
  for (int i = 0; i < wall->law->n_parameters; i++) {
    const aspi_keyword *p = &wall->law->parameters[i];
    wall->parameters[i] = p->default_value;
    if (one_of(s, 4) == 0)
      wall->parameters[i] = isfinite(p->most) ? between(s, p->least, p->most) : or_zero(s, 0, 12);
  }
  wall->spins = wall->law->spins && wall->law->spins(wall->parameters);
}

static void choose_wall(aspi_stream *s, combination *c) {
  int model = one_of(s, asp_spread_count()), slope = one_of(s, SLOPES);
  c->wall = *walls[model][slope];
  c->slope = slope_at(slope);
  behind = asp_spread_at(model);
  if (behind->quantile && one_of(s, 8) == 0)
    c->wall.spread = &forced[model];
  u_forced = one_of(s, 2) ? U_LEAST : U_MOST;
  c->wall.rough = c->wall.rough && one_of(s, 6) > 0;
  c->wall.isotropic = one_of(s, 2);
  c->wall.multiple = c->wall.multiple || one_of(s, 2);
  c->wall.deposit = one_of(s, 4) > 0;
  choose_law(s, &c->wall);
}

static void choose_particle(aspi_stream *s, combination *c) {
  c->pair = random_pair(s);
  c->pair.surface_energy = or_zero(s, -12, 6);
  c->pair.friction = or_zero(s, -6, 1);
  c->particle = (asp_particle){
      .d_p = power_of_ten(s, -9, -1), .density = power_of_ten(s, -3, 6), .pair = &c->pair};
}

/* A third of the velocities lie along the axes, to be exact at grazing and normal incidence. */
static void choose_velocity(aspi_stream *s, combination *c) {
  double speed = power_of_ten(s, -9, 5), normal, along;
  double length = one_of(s, 2) ? 1 : 1 + (one_of(s, 2) ? 1 : -1) * power_of_ten(s, -16, -3);
  double alpha = one_of(s, 2) ? between(s, 0, ASP_PI / 2) : ASP_PI / 2 * power_of_ten(s, -17, 0);
  normal = speed * sin(alpha);
  along = speed * cos(alpha);
  if (one_of(s, 3)) {
    double turn = between(s, 0, 6.3), tip = acos(between(s, -1, 1)), spin = between(s, 0, 6.3);
    double n[3] = {sin(tip) * cos(turn), sin(tip) * sin(turn), cos(tip)};
    double e[3] = {cos(tip) * cos(turn), cos(tip) * sin(turn), -sin(tip)};
    double g[3] = {-sin(turn), cos(turn), 0};
    for (int i = 0; i < 3; i++) {
      c->v1[i] = along * (cos(spin) * e[i] + sin(spin) * g[i]) - normal * n[i];
      c->n[i] = length * n[i];
    }
    return;
  }
  int exact = one_of(s, 3), axis = one_of(s, 3);
  static const double nothings[] = {0, 5e-324, 1e-310, 1e-300, 1e-200, 1e-100, 1e-30};
  if (exact == 1)
    along = nothings[one_of(s, 7)];
  if (exact == 2)
    normal = nothings[one_of(s, 7)];
  for (int i = 0; i < 3; i++)
    c->v1[i] = c->n[i] = 0;
  c->n[axis] = length;
  c->v1[axis] = -normal;
  c->v1[(axis + 1) % 3] = along;
}

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double length_of(const double a[3]) {
  return sqrt(dot(a, a));
}

/* Half of the particles come with a spin, whose surface is up to a thousand times as fast. */
static void choose_spin(aspi_stream *s, combination *c) {
  for (int i = 0; i < 3; i++)
    c->particle.omega[i] = 0;
  if (!one_of(s, 2))
    return;
  double speed = length_of(c->v1) * power_of_ten(s, -9, 3);
  for (int i = 0; i < 3; i++)
    c->particle.omega[i] = between(s, -1, 1) * speed / (c->particle.d_p / 2);
}

/* The speed of a flight that has the energy of both. */
static double energy_of(const combination *c, const double v[3], const double omega[3]) {
  return hypot(length_of(v), sqrt(0.4) * c->particle.d_p / 2 * length_of(omega));
}

static const char *wrong_with(const combination *c, const asp_impact *impact) {
  double before = energy_of(c, c->v1, c->particle.omega);
  double after = energy_of(c, impact->v2, impact->omega), away = dot(impact->v2, c->n);
  asp_coefficients cor = asp_impact_coefficients(c->v1, c->n, impact);
  if (!c->wall.spins) { /* flight alone */
    before = length_of(c->v1);
    after = length_of(impact->v2);
  }
  if (!isfinite(after) || !isfinite(impact->delta_alpha) || !isfinite(impact->tilt_out))
    return "not a number";
  bool oblique = cos(cor.alpha1) > ASPI_NORMAL_PART; /* otherwise there is no CoR_T */
  bool dips = sin(cor.alpha1) > ASPI_ROUNDING_PART;  /* otherwise there is no CoR_N */
  bool rebound = impact->outcome != ASP_DEPOSIT;     /* a deposit has no coefficients */
  if (isfinite(cor.cor_n) != (rebound && dips) || isfinite(cor.cor_v) != rebound ||
      isfinite(cor.cor_alpha) != (rebound && dips) || isfinite(cor.cor_t) != (rebound && oblique) ||
      !isfinite(cor.alpha1) || !isfinite(cor.alpha2))
    return "a coefficient that is not a number, or one too many";
  if (after > before * (1 + ENERGY))
    return "more energy";
  if (fabs(impact->delta_alpha) > ASP_PI / 2)
    return "an overhanging face";
  if (impact->outcome == ASP_DEPOSIT)
    return after > 0 || !c->wall.deposit ? "a deposit that moves, or none allowed" : NULL;
  if (!(away > (c->wall.deposit ? 0 : -1e-15 * before)))
    return away < 0 || c->wall.deposit ? "into the wall" : NULL;
  return NULL;
}

/* The same contact with one input changed by that part of itself. */
static void change(aspi_stream *s, combination *c, double part) {
  double off = dot(c->v1, c->n) / dot(c->n, c->n);
  switch (one_of(s, 4)) {
  case 0:
    c->particle.d_p *= 1 + part;
    return;
  case 1:
    c->pair.yield_stress *= 1 + part;
    return;
  case 2:
    for (int i = 0; i < 3; i++)
      c->v1[i] *= 1 + part;
    return;
  default: /* the impact angle */
    for (int i = 0; i < 3; i++)
      c->v1[i] += part * off * c->n[i];
  }
}

static void meet(const combination *c, asp_impact *impact) {
  asp_particle particle = {
      .d_p = c->particle.d_p,
      .density = c->particle.density,
      .pair = &c->pair,
      .omega = {c->particle.omega[0], c->particle.omega[1], c->particle.omega[2]}};
  asp_wall_impact(&c->wall, &particle, c->v1, c->n, &c->key, impact);
}

/* How far apart two outcomes are, by the speed. */
static double jump_of(const combination *c, const asp_impact *x, const asp_impact *y) {
  double apart[3] = {x->v2[0] - y->v2[0], x->v2[1] - y->v2[1], x->v2[2] - y->v2[2]};
  return length_of(apart) / energy_of(c, c->v1, c->particle.omega);
}

/* Halves the way from a to b, toward the larger part of the change. */
static void close_in(combination *a, asp_impact *x, combination *b, asp_impact *y) {
  for (int k = 0; k < HALVINGS; k++) {
    combination middle = *a;
    asp_impact z;
    middle.particle.d_p = (a->particle.d_p + b->particle.d_p) / 2;
    middle.pair.yield_stress = (a->pair.yield_stress + b->pair.yield_stress) / 2;
    for (int i = 0; i < 3; i++)
      middle.v1[i] = (a->v1[i] + b->v1[i]) / 2;
    meet(&middle, &z);
    bool first = jump_of(a, x, &z) > jump_of(a, &z, y);
    *(first ? b : a) = middle;
    *(first ? y : x) = z;
  }
}

static bool has_direction(const combination *c) {
  double normal = fabs(dot(c->v1, c->n)) / length_of(c->n), speed = length_of(c->v1);
  return (speed - normal) * (speed + normal) >= 1e-24 * normal * normal;
}

/* Where a jump belongs; PLACES when nowhere. */
static place place_of(const combination *a, const asp_impact *x, const combination *b,
                      const asp_impact *y) {
  double normal = dot(a->v1, a->n), size = length_of(a->v1) * length_of(a->n);
  if (fabs(normal) < 1e-15 * size)
    return APPROACH;
  if (x->hits != y->hits || x->capped != y->capped)
    return OTHER_HITS;
  if (!has_direction(a) || !has_direction(b) || -normal > size * (1 - 1e-15))
    return NORMAL_IMPACT;
  bool scatters = a->wall.law->scatters && a->wall.law->scatters(a->wall.parameters);
  if (x->capped || (a->wall.rough && scatters) || fabs(x->delta_alpha - y->delta_alpha) > 1e-4 ||
      fabs(x->tilt_out - y->tilt_out) > 1e-4)
    return OTHER_FACE;
  if (x->hits > 1)
    return LATER_FACE;
  return x->outcome != y->outcome ? CAPTURE : PLACES;
}

/* The words of its wall, and its numbers. */
static void print_combination(const combination *c) {
  const asp_wall *wall = &c->wall;
  const char *last = "";
  printf("surface tan_sigma %g spread %s %s collisions %s deposit %s", wall->rough ? c->slope : 0,
         wall->spread->name, wall->isotropic ? "isotropic" : "plane",
         wall->multiple ? "multiple" : "single", wall->deposit ? "freeze" : "off");
  if (wall->spread->quantile == forced_quantile)
    printf(" (its quantile at u = %.17g)", u_forced);
  printf(" rebound %s", wall->law->name);
  for (int i = 0; i < wall->law->n_parameters; i++) {
    const char *keyword = aspi_keyword_word(&wall->law->parameters[i]);
    if (strcmp(keyword, last) != 0)
      printf(" %s", keyword);
    last = keyword;
    printf(" %.17g", wall->parameters[i]);
  }
  printf("\nd_p %.17g rho %.17g E %.17g sigma_y %.17g gamma %.17g mu %.17g\n", c->particle.d_p,
         c->particle.density, c->pair.modulus, c->pair.yield_stress, c->pair.surface_energy,
         c->pair.friction);
  printf("v1 %.17g %.17g %.17g n %.17g %.17g %.17g omega %.17g %.17g %.17g\n", c->v1[0], c->v1[1],
         c->v1[2], c->n[0], c->n[1], c->n[2], c->particle.omega[0], c->particle.omega[1],
         c->particle.omega[2]);
}

/* Traps come from arithmetic, never from within printf. */
static void on_trap(int number) {
  printf("combination %llu: signal %d (%s)\n", (unsigned long long)at_work->number, number,
         strsignal(number));
  print_combination(at_work);
  fflush(stdout);
  _exit(1);
}

static void print_impact(const asp_impact *impact) {
  printf("v2 %.17g %.17g %.17g delta %.17g hits %d capped %d outcome %d\n", impact->v2[0],
         impact->v2[1], impact->v2[2], impact->delta_alpha, impact->hits, impact->capped,
         impact->outcome);
}

/* Puts a large change between two contacts down to a place; false when there is none. */
static bool explain(const combination *a, const asp_impact *x, const combination *b,
                    const asp_impact *y, tally *t) {
  double jump = jump_of(a, x, y);
  if (!(jump > JUMP))
    return true;
  place where = place_of(a, x, b, y);
  if (where == PLACES)
    return false;
  t->count[where]++;
  t->worst[where] = fmax(t->worst[where], jump);
  return true;
}

/* One combination; false when something is wrong with it. */
static bool sweep_one(uint32_t seed, uint64_t number, tally *t) {
  aspi_stream s = aspi_stream_begin(&(asp_key){seed, 1, number, 0, 0});
  combination c = {.number = number};
  asp_impact here, there;
  at_work = &c;
  choose_wall(&s, &c);
  choose_particle(&s, &c);
  choose_velocity(&s, &c);
  choose_spin(&s, &c);
  c.key = (asp_key){seed, 2, number, 1, 0};
  combination d = c;
  bool far = one_of(&s, 4) == 0;
  change(&s, &d, far ? CHANGE_FAR : CHANGE);
  meet(&c, &here);
  at_work = &d;
  meet(&d, &there);
  t->deposits += here.outcome == ASP_DEPOSIT;
  t->capped += here.capped;
  const char *wrong = wrong_with(&c, &here);
  if (!wrong && far && jump_of(&c, &here, &there) > JUMP_FAR)
    close_in(&c, &here, &d, &there);
  else if (far)
    there = here;
  if (!wrong && !explain(&c, &here, &d, &there, t))
    wrong = "a jump without a place";
  if (!wrong)
    return true;
#pragma omp critical
  {
    printf("combination %llu: %s (change %g)\n", (unsigned long long)number, wrong,
           jump_of(&c, &here, &there));
    print_combination(&c);
    print_impact(&here);
    print_combination(&d);
    print_impact(&there);
  }
  return false;
}

static long sweep(uint32_t seed, long first, long count, tally *total) {
  long wrong = 0;
#pragma omp parallel reduction(+ : wrong)
  {
    tally own = {{0}, {0}, 0, 0};
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
#pragma omp for schedule(static)
    for (long i = first; i < first + count; i++)
      if (wrong < 5)
        wrong += !sweep_one(seed, (uint64_t)i, &own);
    fedisableexcept(FE_ALL_EXCEPT);
#pragma omp critical
    {
      for (int i = 0; i < PLACES; i++) {
        total->count[i] += own.count[i];
        total->worst[i] = fmax(total->worst[i], own.worst[i]);
      }
      total->deposits += own.deposits;
      total->capped += own.capped;
    }
  }
  return wrong;
}

int main(int argc, char **argv) {
  long count = argc > 1 ? atol(argv[1]) : 100000;
  uint32_t seed = argc > 2 ? (uint32_t)atol(argv[2]) : 1;
  tally total = {{0}, {0}, 0, 0};
  if (count < 1 || !make_walls()) {
    fputs("usage: extremes COUNT [SEED [FIRST]]\n", stderr);
    return 2;
  }
  signal(SIGFPE, on_trap);
  long wrong = sweep(seed, argc > 3 ? atol(argv[3]) : 0, count, &total);
  printf("# %ld combinations, seed %u; %ld deposits, %ld capped, %ld wrong\n", count, seed,
         total.deposits, total.capped, wrong);
  printf("place,jumps,largest_jump_of_v1\n");
  for (int i = 0; i < PLACES; i++)
    printf("\"%s\",%ld,%.3g\n", place_names[i], total.count[i], total.worst[i]);
  return wrong ? 1 : 0;
}
