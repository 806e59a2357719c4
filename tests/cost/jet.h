/* The jet of the flat plate, a small part of it: dust of quartz of 1 to 100 um, log-normal with a
 * median of 10 um, at 100 m/s and angles between 2 and 88 degrees. No two meet, and each comes to
 * z = 0 after 5 to 75 % of the steps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <math.h>
#include <random>
#include <vector>

const char JET_LAW[] = "materials quartz surface rq 15.6e-6 lambda_c 120e-6 seed 1";
const int JET_SIDE = 20, JET_STEPS = 2000;
const double JET_DT = 4e-9, JET_PITCH = 0.4e-3;
const double JET_LO = -1e-3, JET_HI = JET_SIDE * JET_PITCH + 1e-3; /* of the plate */

struct JetGrain {
  double x[3], v[3], radius, mass;
};

inline std::vector<JetGrain> jet_grains() {
  const int n = JET_SIDE * JET_SIDE;
  const double pi = acos(-1.0), speed = 100;
  std::minstd_rand0 numbers(20200709);
  const auto uniform = [&]() { return static_cast<double>(numbers()) / 2147483647.; };
  std::vector<JetGrain> all;
  for (int i = 0; i < n; i++) {
    const double angle = (2 + 86 * (i + 0.5) / n) * pi / 180;
    double d;
    do {
      const double r = sqrt(-2 * log(uniform()));
      d = 10e-6 * exp(log(100) / 5 * r * cos(2 * pi * uniform()));
    } while (d < 1e-6 || d > 100e-6);
    const double t = (0.05 + 0.7 * uniform()) * JET_STEPS * JET_DT;
    const double vx = speed * cos(angle), vz = -speed * sin(angle);
    const int k = 79 * (i + 1) % n; /* a place that has nothing to do with the angle */
    all.push_back(
        {{JET_PITCH * (k % JET_SIDE) - vx * t, JET_PITCH * (k / JET_SIDE), d / 2 - vz * t},
         {vx, 0, vz},
         d / 2,
         2650 * pi / 6 * d * d * d});
  }
  return all;
}
