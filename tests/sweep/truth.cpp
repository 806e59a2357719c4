/* Walls in a simulation against figures that no wall made: speeds of spheres that roll down rough
 * slopes, by the geometry of rolling.csv; impacts on measured profiles, by spheres that were
 * followed over generated surfaces (README.md); deposits that a flow removes; bodies in a box,
 * whose energy is shared as a gas has it, however far they fly in a step. truth ROLLING.CSV
 * Equilibrium is in equilibrium.c, the weights of each model in unit/test_sensitivity.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "alone.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contact/vector.h"
#include "dem/shapes/primitive.h"

using namespace asperity;

namespace {

int failures;

void expect(const std::string &what, double is, double should, double error) {
  const bool good = fabs(is - should) <= error;
  printf("%s%s: %.4g, %.4g +- %.2g\n", good ? "" : "FAILED: ", what.c_str(), is, should, error);
  failures += !good;
}

std::unique_ptr<Shape> plane(int axis, double at) {
  const double still[3] = {0, 0, 0};
  return std::unique_ptr<Shape>(new PlaneShape(axis, at, still));
}

/* Of the standard normal law, nearly. */
double normal() {
  static uint64_t state = 88172645463325252ULL;
  double sum = -6;
  for (int k = 0; k < 12; k++) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    sum += static_cast<double>(state >> 11) / 9007199254740992.0;
  }
  return sum;
}

/* ---- rolling ---- */

/* A row of rolling.csv, and how far the model may be from it, of the speed. */
struct Row {
  const char *begin;
  double within;
};
const Row ROWS[] = {{"2,0.05,4,5,", 0.05}, {"2,0.2,4,12,", 0.05}, {"3,0.2,4,5,0.5,1,", 0.05}};

void roll(const char *path, const Row &row) {
  const int n = 40;
  const double duration = 300, dt = 0.02;
  double d[9];
  char line[400];
  FILE *file = fopen(path, "r");
  while (file && fgets(line, sizeof line, file) &&
         strncmp(line, row.begin, strlen(row.begin)) != 0) {
  }
  if (!file || sscanf(line, "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", d, d + 1, d + 2, d + 3, d + 4, d + 5,
                      d + 6, d + 7) != 8)
    abort();
  fclose(file);
  const double slope = d[3] * ASP_PI / 180;
  char words[200];
  snprintf(
      words, sizeof words,
      "surface rq %.17g lambda_c 1 spread visible %s collisions multiple rebound walton %g %g 0 "
      "deposit off",
      d[1] / sqrt(2), d[0] < 3 ? "plane" : "isotropic", d[4], d[5]);
  GrainsAtWall s(plane(2, 0), words, n, d[2] / 2, dt);
  s.engine.least = s.engine.most = d[2];
  s.grains.spins = true;
  for (int i = 0; i < n; i++) {
    s.grains.put(static_cast<size_t>(i), {0, 10. * i, d[2] / 2}, {1.5, 0, 0});
    s.grains.f[static_cast<size_t>(3 * i)] = sin(slope);
    s.grains.f[static_cast<size_t>(3 * i + 2)] = -cos(slope);
  }
  s.begin();
  const int half = static_cast<int>(0.5 * duration / dt);
  s.grains.fly(half);
  const std::vector<double> x = s.grains.x;
  s.grains.fly(half);
  double mean = 0, moving = 0;
  for (size_t i = 0; i < n; i++) {
    const double speed = (s.grains.x[3 * i] - x[3 * i]) / (half * dt);
    if (speed > 0.1)
      mean += speed;
    moving += speed > 0.1;
  }
  expect(std::string("rolling, ") + row.begin, mean / moving, d[6], 4 * d[7] + row.within * d[6]);
}

/* ---- removal ---- */

/* Deposits that adhesion hardly holds leave as often as a burst comes, 0.00658 u_tau^2/nu (Reeks &
 * Hall 2001): exponentially. */
void remove() {
  const int n = 1000;
  const double u_tau = 30, viscosity = 1.5e-5, rate = 0.00658 * u_tau * u_tau / viscosity;
  const double d = 1e-5, dt = 1e-8;
  char words[200];
  snprintf(words, sizeof words,
           "materials quartz deposit freeze remove u_tau %g gas_density 1.2 gas_viscosity %g "
           "adhesion 1e-4 adhesion_spread 1",
           u_tau, viscosity);
  GrainsAtWall s(plane(2, 0), words, n, d / 2, dt);
  s.engine.least = s.engine.most = d;
  s.grains.mass.assign(n, 2650 * ASP_PI / 6 * d * d * d);
  for (int i = 0; i < n; i++)
    s.grains.put(static_cast<size_t>(i), {i * d, 0, 0.5 * d + 1e-12}, {0, 0, -1e-3});
  s.begin();
  s.grains.fly(1);
  expect("deposits", s.wall->stuck(), n, 0.1 * n);
  const double first = s.wall->stuck();
  for (int k = 1; k <= 2; k++) {
    const int steps = static_cast<int>(lround(0.7 / (rate * dt)));
    s.grains.fly(steps);
    const double left = exp(-rate * dt * steps * k);
    expect("deposits that are left", s.wall->stuck() / first, left,
           4 * sqrt(left * (1 - left) / first));
  }
}

/* ---- bodies ---- */

double energy_of(const Body &body) {
  double twice = body.mass * aspi_dot(body.v, body.v);
  for (int k = 0; k < 3; k++)
    twice += pow(aspi_dot(body.angular_momentum, body.axes[k]), 2) / body.inertia[k];
  return 0.5 * twice;
}

/* Rods of two spheres that touch, a gas in a box of 10 diameters with elastic walls, which keep it
 * one: they turn about two axes, so that 2/5 of the energy is in their spin, of one rod a share of
 * the law Beta(1, 3/2). */
void box(double diameters, int n, int steps) {
  const double half = 5, mass = 1, side = 0.5 * (0.4 * 0.25 + 0.25) * 2, dt = diameters;
  Alone engine;
  Shapes walls;
  for (int axis = 0; axis < 3; axis++)
    for (int to = -1; to <= 1; to += 2)
      walls.push_back(plane(axis, to * half));
  std::unique_ptr<Wall> wall =
      make_wall(engine, std::move(walls), "rebound walton 1 0 0 deposit off");
  Grains none(0, 0.5, dt);
  none.begin({wall.get()});
  Bodies bodies;
  bodies.dt = dt;
  for (int i = 0; i < n; i++) {
    Body rod = Body();
    rod.tag = i;
    rod.first = bodies.spheres.size();
    rod.count = 2;
    rod.mass = 2 * mass;
    rod.inertia[0] = 2 * 0.4 * 0.25 * mass;
    rod.inertia[1] = rod.inertia[2] = 2 * side;
    for (int d = 0; d < 3; d++) {
      rod.axes[d][d] = 1;
      rod.v[d] = normal() / sqrt(rod.mass);
      rod.angular_momentum[d] = d > 0 ? normal() * sqrt(rod.inertia[d]) : 0;
    }
    const double scale = sqrt(mass / energy_of(rod));
    aspi_scale(scale, rod.v);
    aspi_scale(scale, rod.angular_momentum);
    bodies.spheres.resize(rod.first + 2);
    for (int k = 0; k < 2; k++)
      bodies.spheres[rod.first + static_cast<size_t>(k)] =
          BodySphere{{k - 0.5, 0, 0}, 0.5, 1, 1, 2 * i + k + 1};
    bodies.all.push_back(rod);
  }
  claim_bodies(none.walls, bodies, MPI_COMM_WORLD);
  double spin = 0, count = 0, outside = 0, drift = 0;
  for (int step = 1; step <= steps; step++) {
    bodies.step = step;
    for (Body &rod : bodies.all) {
      advance(rod, dt);
      rod.is_changed = false;
    }
    step_walls(none.walls, none.spheres(), &bodies);
    end_walls(none.walls, none.spheres(), &bodies);
    bodies.begins = false;
    for (const Body &rod : bodies.all) {
      for (int k = 0; k < 3; k++)
        outside += !(fabs(rod.x[k]) < half);
      const double all = energy_of(rod);
      drift = std::max(drift, fabs(all / mass - 1));
      if (2 * step > steps) {
        spin += 1 - 0.5 * rod.mass * aspi_dot(rod.v, rod.v) / all;
        count++;
      }
    }
  }
  const std::string what =
      "bodies, " + std::to_string(static_cast<int>(diameters)) + " diameters a step: ";
  expect(what + "outside", outside, 0, 0);
  expect(what + "energy", drift, 0, 1e-3);
  expect(what + "share of spin", spin / count, 0.4, 4 * sqrt(1.5 / (6.25 * 3.5)) / sqrt(n));
}

/* ---- profiles ---- */

/* A wall by a profile in space against exact spheres that a program of its own followed over
 * surfaces: Gaussian ones with this R_q and lambda_c, or functions of these, one with high peaks
 * and one with deep valleys. In um, m/s and degrees; what is not compared is negative. */
struct Shots {
  enum { GAUSS, SKEWED, PLATEAU } shape;
  double r_q, lambda_c, d_p, speed, angle, stuck, later, tilt, within;
};
const Shots SHOTS[] = {
    {Shots::GAUSS, 7.1, 42, 20, 150, 25, 0.00557, -1, -1, 0.25},
    {Shots::GAUSS, 5, 40, 10, 150, 50, 0.0134, -1, -1, 0.2},
    {Shots::GAUSS, 10, 40, 10, 100, 20, 0.0153, -1, -1, 0.25},
    {Shots::GAUSS, 5, 40, 10, 30, 3, 0.3594, -1, -1, 0.1},
    {Shots::GAUSS, 5, 40, 10, 150, 85, 0.0171, -1, -1, 0.25},
    {Shots::SKEWED, 5, 40, 10, 100, 20, 0.0110, -1, -1, 0.25},
    {Shots::PLATEAU, 5, 40, 10, 150, 50, 0.0147, -1, -1, 0.25},
    {Shots::PLATEAU, 1, 4.16, 10, 60, 20, 0.0198, -1, -1, 0.25},
    {Shots::SKEWED, 0.6, 2.28, 20, 40, 25, 0.0187, -1, -1, 0.25},
    {Shots::GAUSS, 20, 40, 2, 1, 30, -1, 0.206, -1, 0.07},
    {Shots::GAUSS, 5, 40, 739, 1, 5, -1, -1, 3.67, 0.05},
    {Shots::GAUSS, 5, 40, 1848, 1, 5, -1, -1, 1.66, 0.07},
};

/* A profile, of white noise filtered by exp(-2 x^2/lambda_c^2). */
asp_heights *profile_of(const Shots &at) {
  const int lengths = 1000, per = 24, reach = 2 * per, n = lengths * per;
  const double r_q = 1e-6 * at.r_q, step = 1e-6 * at.lambda_c / per;
  std::vector<double> noise(n + 2 * reach), z(n);
  for (double &x : noise)
    x = normal();
  double square = 0;
  for (int i = 0; i < n; i++) {
    for (int k = -reach; k <= reach; k++)
      z[i] += noise[i + reach + k] * exp(-2. * k * k / (per * per));
    square += i > 0 ? pow((z[i] - z[i - 1]) / step, 2) / (n - 1) : 0;
  }
  const double scale = sqrt(2) * at.r_q / at.lambda_c / sqrt(square) / r_q;
  for (double &x : z)
    x = at.shape == Shots::SKEWED    ? 1.6 * r_q * exp(0.5 * scale * x)
        : at.shape == Shots::PLATEAU ? -1.3 * r_q * log1p(exp(0.6 - 1.4 * scale * x))
                                     : r_q * scale * x;
  return asp_heights_create(z.data(), n, 1, step, step, false, nullptr);
}

void shoot(const Shots &at) {
  const int n = 20000;
  const double d_p = 1e-6 * at.d_p, angle = at.angle * ASP_PI / 180;
  asp_error error = asp_error();
  asp_heights *heights = profile_of(at);
  asp_description *words = asp_description_parse(
      at.stuck > 0 ? "surface profile generated rebound bons materials quartz ti-6al-4v"
                   : "surface profile generated rebound constant 1 1 deposit off",
      nullptr, &error);
  if (!words || asp_description_set_heights(words, heights, &error))
    abort();
  asp_wall *wall = asp_wall_create(words, d_p, d_p, &error);
  if (!wall)
    abort();
  asp_particle particle = asp_particle();
  particle.d_p = d_p;
  particle.density = 2650;
  const double v[3] = {at.speed * cos(angle), 0, -at.speed * sin(angle)}, up[3] = {0, 0, 1};
  double stuck = 0, later = 0, tilt = 0;
  for (int i = 0; i < n; i++) {
    asp_impact impact;
    asp_key key = asp_key();
    key.tag = static_cast<uint64_t>(i);
    asp_wall_impact(wall, &particle, v, up, &key, &impact);
    stuck += (impact.outcome == ASP_DEPOSIT) / double(n);
    later += (impact.hits > 1) / double(n);
    tilt += impact.delta_alpha * 180 / ASP_PI / n;
  }
  char what[100];
  snprintf(what, sizeof what, "profile %d, R_q %g, d %g, %g m/s at %g degrees: ", at.shape, at.r_q,
           at.d_p, at.speed, at.angle);
  if (at.stuck > 0)
    expect(std::string(what) + "share that sticks", stuck, at.stuck, at.within * at.stuck);
  if (at.later > 0)
    expect(std::string(what) + "later hits", later, at.later, at.within * at.later);
  if (at.tilt > 0)
    expect(std::string(what) + "first tilt", tilt, at.tilt, at.within * at.tilt);
  asp_wall_free(wall);
  asp_description_free(words);
  asp_heights_free(heights);
}

} // namespace

int main(int, char **argv) {
  for (const Row &row : ROWS)
    roll(argv[1], row);
  remove();
  box(10, 200, 20);
  box(100, 60, 4);
  for (const Shots &at : SHOTS)
    shoot(at);
  return failures > 0;
}
