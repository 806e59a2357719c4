/* Rebound laws against the same laws in long double, written out anew: precision [COUNT [SEED]].
 *
 * Random hits over the extremes that the project allows. Near the capture threshold v_n2 is as ill
 * conditioned as the difference it is made of, and v_t2 is where friction stops it; so the table
 * has a row per decade of the distance from there: the largest relative error, the same in ulps,
 * and how often capture was decided otherwise. Fails when an error times its distance is over 1e-14
 * (thornton_ning, which solves for the largest contact: 2e-13) beyond a distance of 1e-4, or a
 * capture is wrong beyond 1e-12.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity_internal.h"
#include "random.h"
#include "rebound/laws.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define FAR 1e-4
#define DECIDED 1e-12

enum { DECADES = 17 };

typedef struct decade {
  long count, wrong_capture;
  double worst, ulps;
} decade;

typedef struct table {
  decade rows[DECADES];
} table;

/* The law in long double, and how far the hit is from the places where digits go. */
typedef struct reference {
  long double v_n2, v_t2;
  double from_capture, from_stop;
  bool captured;
} reference;

/* The share of the yield stress that heat leaves. */
static long double softened(const double *p, const aspi_hit *hit) {
  long double over = (long double)hit->temperature - p[4];
  return over > 0 ? fmaxl(0, 1 - p[5] * over) : 1;
}

static long double yield_speed(const double *p, const aspi_hit *hit, long double speed) {
  long double yield = p[0] > 0 ? p[0] * speed : (long double)hit->pair->yield_stress;
  return yield * softened(p, hit) / sqrtl((long double)hit->density * hit->pair->modulus);
}

static reference bons(const double *p, const aspi_hit *hit) {
  long double n1 = hit->v_n1, t1 = hit->v_t1, speed2 = n1 * n1 + t1 * t1;
  long double v_y = yield_speed(p, hit, sqrtl(speed2)), spring = fminl(n1, v_y);
  long double ratio = n1 < v_y ? n1 / v_y : 1;
  long double share = p[1] + p[2] * powl(ratio, p[3]);
  long double taken =
      6 * (long double)hit->pair->surface_energy * share / ((long double)hit->density * hit->d_p);
  long double left = spring * spring - taken;
  reference r = {.captured = !(left > 0)};
  r.v_n2 = left > 0 ? sqrtl(left) : 0;
  r.from_capture =
      fmin((double)(fabsl(left) / fmaxl(spring * spring, taken)), (double)softened(p, hit));
  long double lost = hit->pair->friction * (n1 + r.v_n2) * t1 * t1 / speed2;
  r.v_t2 = fmaxl(0, t1 - lost);
  r.from_stop = fmin((double)(fabsl(t1 - lost) / fmaxl(t1, lost)), r.from_capture);
  return r;
}

/* The work of the loading in long double: see src/rebound/thornton_ning.c. */
static long double plastic(long double d, long double give, long double u) {
  long double u4 = u * u * u * u;
  return give / 2 * u4 * u4 - d * (2 - d / 5) * u4 * u + (d - 2 / 3.0L) * u4 + d * d * u * u +
         d * (2 / 3.0L - d) * u;
}

static long double elastic(long double d, long double dent, long double u) {
  long double root = powl(u, 5) / dent;
  return 8 / 15.0L * root * root - 4 / 3.0L * d * u * u * root + d * d * powl(u, 4) / 2;
}

static reference thornton_ning(const double *p, const aspi_hit *hit) {
  const asp_pair *pair = hit->pair;
  long double n1 = hit->v_n1, pi = acosl(-1), modulus = pair->modulus;
  long double pressure = pi * p[0] * pair->yield_stress / modulus;
  long double pull = sqrtl(8 * pi * pair->surface_energy / (modulus * hit->d_p));
  long double b = sqrtl(pressure / 2) + cbrtl(pull / 2);
  for (int i = 0; i < 20; i++)
    b = (4 * b * b * b + pull) / (6 * b * b - pressure);
  long double d = pull / (b * b * b), give = pressure / (b * b), scale = powl(d, 10 / 3.0L),
              part = 0.2L / powl(4, 4 / 3.0L);
  long double unit = sqrtl(1.5L / pi * modulus / hit->density) * powl(b, 5), u = 1, dent = 1;
  long double work = n1 * n1 / (unit * unit) - 0.3L * scale, at_yield = elastic(d, 1, 1);
  long double spring = work + 0.3L * scale, back = work - part * scale, from = fmaxl(1, cbrtl(d));
  if (work > at_yield || d >= 1) {
    long double low = from, high = 2 * from,
                goal = work - (d < 1 ? at_yield : -0.3L * scale) + plastic(d, give, from);
    while (plastic(d, give, high) < goal)
      high *= 2;
    for (int i = 0; i < 80; i++) {
      u = (low + high) / 2;
      *(plastic(d, give, u) < goal ? &low : &high) = u;
    }
    long double force = give * powl(u, 4) - 2 * d * u + d - 2 / 3.0L;
    dent = 4 / 3.0L * powl(u, 6) / (force + 2 * d * u * u * u);
    spring = elastic(d, dent, u);
    back = spring - part * scale * powl(dent, 4 / 3.0L);
  }
  reference r = {.captured = !(back > 0), .v_n2 = back > 0 ? unit * sqrtl(back) : 0};
  r.from_capture = (double)(fabsl(back) / fmaxl(spring, part * scale * powl(dent, 4 / 3.0L)));
  return r;
}

static decade *row_of(table *t, double distance) {
  int k = distance > 0 ? (int)floor(-log10(distance)) : DECADES - 1;
  return &t->rows[k < 0 ? 0 : k < DECADES ? k : DECADES - 1];
}

static void note(table *t, double distance, double is, long double should) {
  decade *row = row_of(t, distance);
  row->count++;
  if (!(should > DBL_MIN))
    return;
  double error = (double)fabsl((is - should) / should);
  double value = (double)should, ulp = nextafter(value, INFINITY) - value;
  if (error > row->worst) {
    row->worst = error;
    row->ulps = (double)fabsl((is - should) / ulp);
  }
}

/* Nine in ten surface energies are chosen near the capture threshold of the hit. */
static void choose_energy(aspi_stream *s, const double *p, asp_pair *pair, const aspi_hit *hit) {
  pair->surface_energy = 1;
  reference r = bons(p, hit);
  pair->surface_energy = 0;
  long double spring = bons(p, hit).v_n2, taken = spring * spring - r.v_n2 * r.v_n2;
  pair->surface_energy = or_zero(s, -12, 6);
  if (r.captured) {
    long double share = p[1] + p[2];
    taken = 6 * share / ((long double)hit->density * hit->d_p);
  }
  double at = taken > 0 ? (double)(spring * spring / taken) : 0;
  double off = power_of_ten(s, -16, 0) * (aspi_stream_uniform(s) < 0.5 ? 1 : -1);
  if (aspi_stream_uniform(s) < 0.9 && at > 0 && at < 1e6)
    pair->surface_energy = at * (1 + off);
}

/* A hit in four is given the friction that just stops it, or nearly. */
static void choose_friction(aspi_stream *s, const double *p, asp_pair *pair, const aspi_hit *hit) {
  if (aspi_stream_uniform(s) > 0.25)
    return;
  double n1 = hit->v_n1, t1 = hit->v_t1, lost = (n1 + (double)bons(p, hit).v_n2) * t1;
  double off = power_of_ten(s, -16, 0) * (aspi_stream_uniform(s) < 0.5 ? 1 : -1);
  pair->friction = (n1 * n1 + t1 * t1) / lost * (1 + off);
}

static void choose_parameters(aspi_stream *s, const asp_rebound_law *law, double *p) {
  for (int k = 0; k < law->n_parameters; k++)
    p[k] = law->parameters[k].default_value;
  if (aspi_stream_uniform(s) < 0.3)
    p[0] = power_of_ten(s, 0, 10);
  if (aspi_stream_uniform(s) < 0.3)
    p[3] = between(s, 0, 10);
}

static void measure(uint32_t seed, long count, table *normal, table *tangential) {
  const asp_rebound_law *law = asp_rebound_find("bons", NULL);
  for (long i = 0; i < count; i++) {
    aspi_stream s = aspi_stream_begin(&(asp_key){seed, 3, (uint64_t)i, 0, 0});
    double p[ASP_PARAMETERS_MAX] = {0};
    choose_parameters(&s, law, p);
    double speed = power_of_ten(&s, -9, 5), alpha = ASP_PI / 2 * power_of_ten(&s, -15, 0);
    asp_pair pair = random_pair(&s);
    pair.friction = or_zero(&s, -6, 1);
    aspi_hit hit = {.v_n1 = speed * sin(alpha),
                    .v_t1 = speed * cos(alpha),
                    .d_p = power_of_ten(&s, -9, -1),
                    .density = power_of_ten(&s, -3, 6),
                    .pair = &pair,
                    .adhesion = true};
    if (aspi_stream_uniform(&s) < 0.3)
      hit.temperature = between(&s, 0, 2000);
    choose_energy(&s, p, &pair, &hit);
    choose_friction(&s, p, &pair, &hit);
    reference r = bons(p, &hit);
    aspi_bounce b = law->rebound(p, &hit);
    bool captured = !(b.v_n2 > 0);
    row_of(normal, r.from_capture)->wrong_capture += captured != r.captured;
    if (captured == r.captured) {
      note(normal, r.from_capture, b.v_n2, r.v_n2);
      note(tangential, r.from_stop, b.v_t2, r.v_t2);
    }
  }
}

/* Half of the surface energies are put near the threshold by bisection. */
static void measure_thornton_ning(uint32_t seed, long count, table *normal) {
  const asp_rebound_law *law = asp_rebound_find("thornton_ning", NULL);
  for (long i = 0; i < count; i++) {
    aspi_stream s = aspi_stream_begin(&(asp_key){seed, 5, (uint64_t)i, 0, 0});
    const double p[ASP_PARAMETERS_MAX] = {between(&s, 0.1, 10)};
    asp_pair pair = random_pair(&s);
    aspi_hit hit = {.v_n1 = power_of_ten(&s, -9, 5),
                    .d_p = power_of_ten(&s, -9, -1),
                    .density = power_of_ten(&s, -3, 6),
                    .pair = &pair,
                    .adhesion = true};
    pair.surface_energy = power_of_ten(&s, -12, 6);
    double low = 0, high = 1e30, off = power_of_ten(&s, -16, 0);
    for (int k = 0; k < 300 && i % 2; k++) {
      pair.surface_energy = k < 200 ? sqrt(fmax(low, 1e-60) * high) : 0.5 * (low + high);
      *(thornton_ning(p, &hit).captured ? &high : &low) = pair.surface_energy;
    }
    if (i % 2)
      pair.surface_energy *= i % 4 == 1 ? 1 + off : 1 - off;
    if (!(pair.surface_energy > 0))
      continue;
    reference r = thornton_ning(p, &hit);
    aspi_bounce b = law->rebound(p, &hit);
    bool captured = !(b.v_n2 > 0);
    row_of(normal, r.from_capture)->wrong_capture += captured != r.captured;
    if (captured == r.captured)
      note(normal, r.from_capture, b.v_n2, r.v_n2);
  }
}

static int print(const char *name, const table *t, double allowed) {
  int bad = 0;
  for (int k = 0; k < DECADES; k++) {
    const decade *row = &t->rows[k];
    double least = pow(10, -k - 1);
    printf("%s,1e-%d,%ld,%.3g,%.3g,%ld\n", name, k + 1, row->count, row->worst, row->ulps,
           row->wrong_capture);
    bad += least >= FAR * (1 - 1e-9) && row->worst * least > allowed;
    bad += least >= DECIDED * (1 - 1e-9) && row->wrong_capture > 0;
  }
  return bad;
}

int main(int argc, char **argv) {
  long count = argc > 1 ? atol(argv[1]) : 200000;
  uint32_t seed = argc > 2 ? (uint32_t)atol(argv[2]) : 1;
  table normal = {0}, tangential = {0}, plastic = {0};
  measure(seed, count, &normal, &tangential);
  printf("# bons against long double: %ld hits, seed %u\n", count, seed);
  puts("quantity,distance_at_least,hits,worst_relative_error,ulps,wrong_captures");
  int bad = print("v_n2", &normal, 1e-14) + print("v_t2", &tangential, 1e-14);
  measure_thornton_ning(seed, count / 10, &plastic);
  printf("# thornton_ning against long double: %ld hits, seed %u\n", count / 10, seed);
  bad += print("v_n2", &plastic, 2e-13);
  return bad ? 1 : 0;
}
