/* Impacts of bodies: closed forms of a dumbbell, spheres as bodies, Routh's path against one in
 * small steps, energy, momentum, sticking, and eccentric grains.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "choice.h"

#include <stdlib.h>
#include <unistd.h>

#include "base/stream.h"
#include "wall/body.h"

static const double up[3] = {0, 0, 1};
#define D 2e-3
#define RHO 2500.0

static double between(aspi_stream *s, double low, double high) {
  return low + (high - low) * aspi_stream_uniform(s);
}

/* Two equal spheres that touch; the axis points down at the angle theta to the wall. */
static asp_body dumbbell(double theta) {
  double m = RHO * ASP_PI / 6 * D * D * D, r = D / 2, c = cos(theta), s = sin(theta);
  double across = 1 / (2.8 * m * r * r), more = 1 / (0.8 * m * r * r) - across;
  return (asp_body){1 / (2 * m),
                    {across + more * c * c, across, across + more * s * s, 0, -more * c * s, 0},
                    {r * c, 0, -r * s},
                    {0}};
}

/* CoR_N of the center of a dumbbell without spin. */
static double cor_n(const asp_wall *wall, double theta) {
  asp_body body = dumbbell(theta);
  asp_particle particle = {.d_p = D, .density = RHO, .body = &body};
  asp_impact impact;
  assert_int_equal(asp_wall_impact(wall, &particle, (double[3]){0, 0, -3}, up,
                                   &(asp_key){1, 1, 1, 1, 0}, &impact),
                   ASP_OK);
  assert_near(impact.v2[0], 0, 1e-15);
  return impact.v2[2] / 3;
}

/* CoR_N = e - (1 + e) q/(1 + q), q = (5/7) cos^2 theta, and its mean and sd over random axes. */
TEST(dumbbells) {
  static const double of[][3] = {{1, .3872, .2268}, {0.9, .3179, .2155}, {0.6, .1098, .1814}};
  enum { N = 4000 };
  for (int i = 0; i < 3; i++) {
    char text[80];
    snprintf(text, sizeof text, "rebound walton %g 0 0 deposit off", of[i][0]);
    asp_wall *wall = wall_from(text, D);
    double sum = 0, squares = 0;
    for (int k = 0; k < N; k++) {
      double c = cor_n(wall, asin((k + 0.5) / N));
      sum += c;
      squares += c * c;
    }
    assert_near(sum / N, of[i][1], 5e-5);
    assert_near(sqrt(squares / N - sum / N * sum / N), of[i][2], 5e-5);
    if (i == 0) {
      assert_near(cor_n(wall, 0), 1. / 6, 1e-14);
      assert_near(cor_n(wall, ASP_PI / 4), 9. / 19, 1e-14);
      assert_near(cor_n(wall, ASP_PI / 2), 1, 1e-14);
    }
    asp_wall_free(wall);
  }
}

static vec random_vec(aspi_stream *s) {
  vec v = {aspi_stream_normal(s), aspi_stream_normal(s), aspi_stream_normal(s)};
  return v;
}

/* Words of a law with its defaults. */
static void words_of(const asp_rebound_law *law, char *text, size_t size) {
  int n = snprintf(text, size, "%s", law->name);
  for (int i = 0; i < law->n_parameters; i++)
    if (!*aspi_keyword_word(&law->parameters[i]))
      n += snprintf(text + n, size - (size_t)n, " %g", law->parameters[i].default_value);
  if (law->needs_pair)
    snprintf(text + n, size - (size_t)n, " materials quartz 304-ss");
}

/* A sphere as a body is a sphere: for some laws, then for every one with its defaults. */
TEST(a_sphere_is_a_body) {
  static const char *const some[] = {"walton 0.8 0.3 0", "walton 1 100 0", "constant 0.7 0.6",
                                     "bons spin on materials quartz 304-ss"};
  enum { SOME = sizeof some / sizeof *some };
  aspi_stream s = aspi_stream_begin(&(asp_key){3, 1, 1, 1, 0});
  double m = RHO * ASP_PI / 6 * D * D * D, turn = 10 / (m * D * D);
  asp_body body = {1 / m, {turn, turn, turn, 0, 0, 0}, {0, 0, 0}, {0}};
  for (int k = 0; k < SOME + asp_rebound_count(); k++) {
    char words[100], text[200];
    const asp_rebound_law *law = asp_rebound_at(k - SOME);
    if (law && law->needs_table)
      continue;
    if (law)
      words_of(law, words, sizeof words);
    snprintf(text, sizeof text, "surface sigma 12 rebound %s", law ? words : some[k]);
    asp_wall *wall = wall_from(text, D);
    for (uint64_t i = 0; i < 300; i++) {
      vec v = random_vec(&s), w = wall->spins ? scaled(random_vec(&s), 2 / D) : (vec){0, 0, 0};
      v = scaled((vec){v.x, v.y, -fabs(v.z)}, 10);
      asp_particle particle = {.d_p = D, .density = RHO, .omega = {w.x, w.y, w.z}};
      asp_impact one, other;
      double v1[3] = {v.x, v.y, v.z};
      asp_wall_impact(wall, &particle, v1, up, &(asp_key){1, 1, i, 1, 0}, &one);
      particle.body = &body;
      asp_wall_impact(wall, &particle, v1, up, &(asp_key){1, 1, i, 1, 0}, &other);
      assert_int_equal(one.outcome, other.outcome);
      for (int j = 0; j < 3; j++) {
        assert_near(other.v2[j], one.v2[j], 1e-11);
        assert_near(other.omega[j] * D, one.omega[j] * D, 1e-10);
      }
    }
    asp_wall_free(wall);
  }
}

/* A random body of mass 1: points on and around a random box, and one of its spheres. */
static asp_body random_body(aspi_stream *s, double inertia[6]) {
  double i[6] = {0}, flat[3];
  for (int k = 0; k < 3; k++)
    flat[k] = pow(10, between(s, -1.5, 0));
  for (int k = 0; k < 6; k++) {
    vec x = random_vec(s);
    x = (vec){flat[0] * x.x, flat[1] * x.y, flat[2] * x.z};
    i[0] += (x.y * x.y + x.z * x.z) / 6;
    i[1] += (x.x * x.x + x.z * x.z) / 6;
    i[2] += (x.x * x.x + x.y * x.y) / 6;
    i[3] -= x.x * x.y / 6;
    i[4] -= x.x * x.z / 6;
    i[5] -= x.y * x.z / 6;
  }
  memcpy(inertia, i, sizeof i);
  double a = i[1] * i[2] - i[5] * i[5], b = i[4] * i[5] - i[3] * i[2],
         c = i[3] * i[5] - i[4] * i[1];
  double det = i[0] * a + i[3] * b + i[4] * c;
  vec r = random_vec(s);
  return (asp_body){1,
                    {a / det, (i[0] * i[2] - i[4] * i[4]) / det, (i[0] * i[1] - i[3] * i[3]) / det,
                     b / det, c / det, (i[3] * i[4] - i[0] * i[5]) / det},
                    {flat[0] * r.x, flat[1] * r.y, flat[2] * r.z},
                    {0}};
}

static vec inertia_times(const double i[6], vec w) {
  return (vec){i[0] * w.x + i[3] * w.y + i[4] * w.z, i[3] * w.x + i[1] * w.y + i[5] * w.z,
               i[4] * w.x + i[5] * w.y + i[2] * w.z};
}

/* Routh's path in small equal steps; the end of restitution by its work. */
static vec in_small_steps(const asp_body *body, vec arm, vec m, vec u, double e, double mu) {
  double p_most = -dot(u, m) / dot(m, aspi_body_kick(body, arm, m)), work = 0, least = 0;
  double dp = 2e-5 * p_most;
  vec impulse = {0, 0, 0};
  for (long i = 0; i < 6000000; i++) {
    vec t = plus(u, -dot(u, m), m);
    double speed = sqrt(dot(t, t));
    vec j = plus(scaled(m, dp), speed > 0 ? -mu * dp / speed : 0, t);
    vec next = plus(u, 1, aspi_body_kick(body, arm, j));
    work += 0.5 * dp * dot(plus(u, 1, next), m);
    u = next;
    impulse = plus(impulse, 1, j);
    least = fmin(least, work);
    if (dot(u, m) >= 0 && work >= (1 - e * e) * least)
      return impulse;
  }
  fail_msg("no end of restitution");
  return impulse;
}

/* A body wears as the mass that meets the wall: of a dumbbell 1/(1 + q) of it. */
TEST(bodies_wear_by_the_mass_that_hits) {
  asp_wall *wall = wall_from("rebound walton 0.9 0.3 0 erosion dnv density 7800 deposit off", D);
  const double v1[3] = {0, 0, -3};
  const asp_key key = {1, 1, 1, 1, 0};
  asp_particle particle = {.d_p = D, .density = RHO};
  asp_impact alone, impact;
  asp_wall_impact(wall, &particle, v1, up, &key, &alone);
  assert_true(alone.eroded > 0);
  for (double theta = 0; theta < 1.6; theta += 0.2) {
    asp_body body = dumbbell(theta);
    particle.body = &body;
    asp_wall_impact(wall, &particle, v1, up, &key, &impact);
    assert_near(impact.eroded / alone.eroded, 1 / (1 + 5. / 7 * pow(cos(theta), 2)), 1e-12);
  }
  asp_wall_free(wall);
}

TEST(the_path_of_routh) {
  aspi_stream s = aspi_stream_begin(&(asp_key){5, 1, 1, 1, 0});
  double worst = 0;
  for (int i = 0; i < 12; i++) {
    double inertia[6];
    asp_body body = random_body(&s, inertia);
    vec m = unit(random_vec(&s)), arm = load(body.lever), u = random_vec(&s);
    u = dot(u, m) > 0 ? scaled(u, -1) : u;
    double e = between(&s, 0, 1), mu = between(&s, 0.05, 1);
    vec j = aspi_body_impulse(&body, arm, m, u, e, mu), k = in_small_steps(&body, arm, m, u, e, mu);
    vec apart = plus(j, -1, k);
    worst = fmax(worst, sqrt(dot(apart, apart) / dot(k, k)));
  }
  print_message("Routh's path: apart by %.2g\n", worst);
  assert_true(worst < 1e-3);
}

/* Energy does not grow, with friction; without it the angular momentum about the contact is kept;
 * the touching sphere leaves. On demand: bodies in tests/sweep. */
TEST(energy_and_momentum) {
  aspi_stream s = aspi_stream_begin(&(asp_key){7, 1, 1, 1, 0});
  for (int i = 0; i < 15000; i++) {
    double inertia[6], e = i % 3 ? between(&s, 0, 1) : 1, mu = i % 4 ? between(&s, 0, 2) : 0;
    asp_body body = random_body(&s, inertia);
    vec m = unit(random_vec(&s)), arm = load(body.lever), v = random_vec(&s), w = random_vec(&s);
    vec u = plus(v, 1, cross(w, arm));
    if (dot(u, m) >= 0)
      m = scaled(m, -1);
    vec j = aspi_body_impulse(&body, arm, m, u, e, mu), turn = aspi_body_turn(&body, arm, j);
    vec v2 = plus(v, 1, j), w2 = plus(w, 1, turn), u2 = plus(v2, 1, cross(w2, arm));
    double before = dot(v, v) + dot(w, inertia_times(inertia, w)),
           after = dot(v2, v2) + dot(w2, inertia_times(inertia, w2));
    assert_true(after <= before * (1 + 1e-11));
    assert_true(dot(u2, m) >= -1e-13 * sqrt(before * dot(m, aspi_body_kick(&body, arm, m))));
    if (mu > 0)
      continue;
    vec l = plus(inertia_times(inertia, w), -1, cross(arm, v)),
        l2 = plus(inertia_times(inertia, w2), -1, cross(arm, v2)), apart = plus(l2, -1, l);
    assert_true(sqrt(dot(apart, apart)) <= 1e-12 * (1 + sqrt(dot(l, l))) * (1 + sqrt(dot(v2, v2))));
    assert_near(dot(u2, m), -e * dot(u, m), 1e-11 * (1 + fabs(dot(u, m))));
  }
}

/* A deposit holds the whole body; the law takes the effective mass, which decides. */
TEST(sticks_as_a_whole) {
  asp_wall *wall = wall_from("rebound bons materials quartz 304-ss yield_stress 200MPa", D);
  int stuck = 0;
  double last = 0;
  for (int i = 0; i <= 40; i++) { /* the effective mass grows with the angle */
    asp_body body = dumbbell(i * ASP_PI / 80);
    asp_particle particle = {.d_p = D, .density = RHO, .omega = {0, 0, 3}, .body = &body};
    double v = 0.27;
    asp_impact impact;
    asp_wall_impact(wall, &particle, (double[3]){0, 0, -v}, up, &(asp_key){1, 1, 1, 1, 0}, &impact);
    if (impact.outcome == ASP_DEPOSIT)
      for (int k = 0; k < 3; k++)
        assert_true(impact.v2[k] == 0 && impact.omega[k] == 0);
    stuck += impact.outcome == ASP_DEPOSIT;
    last = impact.v2[2];
  }
  print_message("%d of 41 stick\n", stuck);
  assert_in_range(stuck, 5, 36);
  assert_true(last > 0);
  asp_wall_free(wall);
}

/* Eccentric grains: at normal impact without friction CoR_N = e - (1 + e) q/(1 + q) with q = 10 S^2
 * x, x exponential of mean 2; energy; they leave. */
TEST(eccentric_grains) {
  enum { N = 30000 };
  double s = 0.02, expected = 0, mean = 0;
  for (int i = 0; i < 1000; i++) {
    double q = 10 * s * s * -2 * log1p(-(i + 0.5) / 1000);
    expected += (0.8 - 1.8 * q / (1 + q)) / 1000;
  }
  for (int rough = 0; rough < 2; rough++) {
    asp_wall *wall = wall_from(rough ? "surface sigma 10 rebound walton 0.8 0.3 0 grain lever 0.1"
                                     : "rebound walton 0.8 0 0 grain lever 0.02",
                               D);
    aspi_stream stream = aspi_stream_begin(&(asp_key){8, 1, 1, 1, 0});
    for (uint64_t i = 0; i < N; i++) {
      asp_particle particle = {.d_p = D, .density = RHO};
      double v1[3] = {0, 0, -1}, r2 = D * D / 10;
      for (int k = 0; k < 3 && rough; k++) {
        particle.omega[k] = aspi_stream_normal(&stream) / D;
        v1[k] = k == 2 ? -fabs(aspi_stream_normal(&stream)) : aspi_stream_normal(&stream);
      }
      asp_impact impact;
      asp_wall_impact(wall, &particle, v1, up, &(asp_key){1, 1, i, 1, 0}, &impact);
      double before = 0, after = 0;
      for (int k = 0; k < 3; k++) {
        before += v1[k] * v1[k] + r2 * particle.omega[k] * particle.omega[k];
        after += impact.v2[k] * impact.v2[k] + r2 * impact.omega[k] * impact.omega[k];
      }
      assert_true(after <= before * (1 + 1e-12) && impact.v2[2] > 0);
      mean += rough ? 0 : impact.v2[2] / N;
    }
    asp_wall_free(wall);
  }
  assert_near(mean, expected, 1e-4);
}

/* A grain without spin leaves a wall of any direction, with no more energy. */
TEST(eccentric_grains_of_all_walls) {
  asp_wall *wall = wall_from("rebound walton 0.8 0.3 0 grain lever 0.05", D);
  for (int of = 0; of < 27; of++) {
    double n[3] = {of % 3 - 1, of / 3 % 3 - 1, of / 9 - 1}, v1[3];
    asp_particle particle = {.d_p = D, .density = RHO};
    asp_impact is;
    if (of == 13)
      continue;
    for (int k = 0; k < 3; k++)
      v1[k] = -n[k];
    asp_wall_impact(wall, &particle, v1, n, &(asp_key){1, 1, (uint64_t)of, 1, 0}, &is);
    vec v = load(is.v2), spin = load(is.omega);
    assert_true(dot(v, load(n)) > 0);
    assert_true(dot(v, v) + D * D / 10 * dot(spin, spin) < dot(load(n), load(n)));
  }
  asp_wall_free(wall);
}

/* The mass of an eccentric grain turns it: a grain without one is refused. */
TEST(eccentric_grains_have_a_density) {
  asp_wall *wall = wall_from("rebound walton 0.8 0.3 0 grain lever 0.05", D);
  const asp_particle particle = {.d_p = D, .omega = {1, 2, 3}};
  const double v1[3] = {1, 0, -1};
  asp_impact is;
  asp_error error;
  assert_int_equal(
      asp_wall_impacts(wall, 1, &particle, v1, up, &(asp_key){1, 1, 1, 1, 0}, &is, &error),
      ASP_EARG);
  assert_string_equal(error.text, "density is 0; it must be > 0 with 'grain lever'");
  assert_memory_equal(is.v2, v1, sizeof v1);
  assert_memory_equal(is.omega, particle.omega, sizeof is.omega);
  asp_wall_free(wall);
}
