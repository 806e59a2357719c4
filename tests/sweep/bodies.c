/* Bodies at rough walls: bodies [COUNT].
 *
 * Energy: COUNT random bodies hit random rough walls with friction; none gains energy, and all
 * touching spheres leave. Equilibrium: COUNT elastic dumbbells and rods with the velocities and
 * spins of a gas reach a rough wall, each with the weight of its approach speed; what leaves must
 * have the same mean energy of flight, and for the velocity u of the touching sphere the cosine law
 * in the metric of K: c^2 = (u_n^2/K_nn)/(u K^-1 u) is uniform over 0 ... 1.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "random.h"
#include "wall/body.h"

#include <stdio.h>
#include <time.h>

static vec normal_vec(aspi_stream *s) {
  vec v = {aspi_stream_normal(s), aspi_stream_normal(s), aspi_stream_normal(s)};
  return v;
}

static asp_wall *wall_of(const char *text) {
  asp_error error;
  asp_wall *wall = asp_wall_from_text(text, 1, 1, &error);
  if (!wall) {
    fprintf(stderr, "%s: %s\n", text, error.text);
    exit(1);
  }
  return wall;
}

/* A rigid body by its principal axes. */
typedef struct shape {
  vec axes[3];
  double inertia[3], mass; /* infinite: it does not turn about that axis */
} shape;

static shape random_axes(aspi_stream *s) {
  shape b;
  b.axes[0] = unit(normal_vec(s));
  b.axes[1] = unit(cross(b.axes[0], normal_vec(s)));
  b.axes[2] = cross(b.axes[0], b.axes[1]);
  return b;
}

static asp_body body_of(const shape *b, vec lever) {
  asp_body body = {1 / b->mass, {0}, {lever.x, lever.y, lever.z}, {0}};
  for (int i = 0; i < 3; i++) {
    vec a = b->axes[i];
    double parts[6] = {a.x * a.x, a.y * a.y, a.z * a.z, a.x * a.y, a.x * a.z, a.y * a.z};
    for (int k = 0; k < 6; k++)
      body.inverse_inertia[k] += parts[k] / b->inertia[i];
  }
  return body;
}

static double energy_of(const shape *b, vec v, vec w) {
  double sum = 0.5 * b->mass * dot(v, v);
  for (int i = 0; i < 3; i++)
    sum += isinf(b->inertia[i]) ? 0 : 0.5 * b->inertia[i] * dot(w, b->axes[i]) * dot(w, b->axes[i]);
  return sum;
}

static const double up[3] = {0, 0, 1};

static long gains(const char *text, long count) {
  asp_wall *wall = wall_of(text);
  aspi_stream s = aspi_stream_begin(&(asp_key){4, asp_key_wall(text), 1, 1, 0});
  long wrong = 0, met = 0;
  double start = (double)clock() / CLOCKS_PER_SEC, worst = 0;
  for (long i = 0; i < count; i++) {
    shape b = random_axes(&s);
    double moments[3]; /* second moments of the mass along the axes */
    for (int k = 0; k < 3; k++)
      moments[k] = power_of_ten(&s, -3, 0);
    b.mass = 1;
    for (int k = 0; k < 3; k++)
      b.inertia[k] = moments[(k + 1) % 3] + moments[(k + 2) % 3];
    vec x = normal_vec(&s), lever = scaled(b.axes[0], sqrt(moments[0]) * x.x);
    lever = plus(lever, sqrt(moments[1]) * x.y, b.axes[1]);
    lever = plus(lever, sqrt(moments[2]) * x.z, b.axes[2]);
    asp_body body = body_of(&b, lever);
    vec v = normal_vec(&s), w = normal_vec(&s), u = plus(v, 1, cross(w, lever));
    if (!(u.z < 0))
      continue;
    met++;
    asp_particle particle = {
        .d_p = power_of_ten(&s, -2, 0), .omega = {w.x, w.y, w.z}, .body = &body};
    asp_impact impact;
    asp_wall_impact(wall, &particle, (double[3]){v.x, v.y, v.z}, up,
                    &(asp_key){1, 1, (uint64_t)i, 1, 0}, &impact);
    vec v2 = load(impact.v2), w2 = load(impact.omega), u2 = plus(v2, 1, cross(w2, lever));
    double gain = energy_of(&b, v2, w2) / energy_of(&b, v, w) - 1;
    worst = fmax(worst, gain);
    if (!(gain <= 1e-11) || !(u2.z > -1e-14 * sqrt(dot(u, u))))
      wrong++;
  }
  printf("%s: %ld impacts, %.2f us each, worst gain of energy %.2g, wrong %ld\n", text, met,
         1e6 * ((double)clock() / CLOCKS_PER_SEC - start) / (double)met, worst, wrong);
  asp_wall_free(wall);
  return wrong;
}

/* c^2 of a velocity of the touching sphere. */
static double cosine2(const asp_body *body, vec u) {
  vec lever = load(body->lever), e[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, k[3];
  for (int i = 0; i < 3; i++)
    k[i] = aspi_body_kick(body, lever, e[i]);
  double det = dot(k[0], cross(k[1], k[2]));
  vec j = {dot(u, cross(k[1], k[2])) / det, dot(u, cross(k[2], k[0])) / det,
           dot(u, cross(k[0], k[1])) / det};
  return u.z * u.z / k[2].z / dot(u, j);
}

/* Means that should be 0, weighted, with their standard errors. */
typedef struct mean {
  double weight, sum, squares;
} mean;

static void add(mean *m, double weight, double x) {
  m->weight += weight;
  m->sum += weight * x;
  m->squares += weight * weight * x * x;
}

static bool is_zero(const char *what, const mean *m) {
  double value = m->sum / m->weight, error = sqrt(m->squares) / m->weight;
  printf("  %s %+.5f +- %.5f\n", what, value, error);
  return fabs(value) < 4 * error + 0.001;
}

/* Dumbbells of two spheres that touch, or rods of two points without inertia about their axis. */
static bool in_equilibrium(bool rod, double sigma, long count) {
  char text[100];
  snprintf(text, sizeof text, "surface sigma %g rebound constant 1 1 deposit off", sigma);
  asp_wall *wall = wall_of(text);
  aspi_stream s = aspi_stream_begin(&(asp_key){6, rod, 1, 1, 0});
  mean flight = {0}, first = {0}, second = {0};
  for (long i = 0; i < count; i++) {
    shape b = random_axes(&s);
    double across = rod ? 0.25 : 0.35;
    b.mass = 1;
    b.inertia[0] = rod ? INFINITY : 0.1;
    b.inertia[1] = b.inertia[2] = across;
    vec lever = scaled(b.axes[0], b.axes[0].z < 0 ? 0.5 : -0.5), v = normal_vec(&s), w = {0, 0, 0};
    for (int k = rod; k < 3; k++)
      w = plus(w, aspi_stream_normal(&s) / sqrt(b.inertia[k]), b.axes[k]);
    asp_body body = body_of(&b, lever);
    vec u = plus(v, 1, cross(w, lever));
    if (!(u.z < 0))
      continue;
    asp_particle particle = {.d_p = 1, .omega = {w.x, w.y, w.z}, .body = &body};
    asp_impact impact;
    asp_wall_impact(wall, &particle, (double[3]){v.x, v.y, v.z}, up,
                    &(asp_key){1, 1, (uint64_t)i, 1, 0}, &impact);
    vec v2 = load(impact.v2), u2 = plus(v2, 1, cross(load(impact.omega), lever));
    double c2 = cosine2(&body, u2);
    add(&flight, -u.z, 0.25 * (dot(v2, v2) - dot(v, v))); /* of 2, the mean at the wall */
    add(&first, -u.z, c2 - 0.5);
    add(&second, -u.z, c2 * c2 - 1. / 3);
  }
  asp_wall_free(wall);
  printf("%s, sigma %g\n", rod ? "rods" : "dumbbells", sigma);
  bool right = is_zero("energy of flight", &flight);
  right = is_zero("mean of c^2", &first) && right;
  return is_zero("mean of c^4", &second) && right;
}

int main(int argc, char **argv) {
  long count = argc > 1 ? atol(argv[1]) : 100000, wrong = 0;
  wrong += gains("surface sigma 10 rebound walton 1 0.3 0 deposit off", count);
  wrong += gains("surface sigma 10 rebound walton 0.7 1 0 deposit off", count);
  wrong += gains("rebound walton 1 0.05 0 deposit off", count);
  wrong += gains("surface sigma 20 rebound constant 0.9 0.5 deposit off", count);
  for (int rod = 0; rod < 2; rod++)
    for (int steep = 0; steep < 2; steep++)
      wrong += !in_equilibrium(rod, steep ? 20 : 5, count);
  return wrong > 0;
}
