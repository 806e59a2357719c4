/* Sustained contact; see sustained.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/sustained.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

namespace {

/* Sweeps over several contacts. They end when a sweep changes the velocity by less than CONVERGED
 * of what the first one did; they have found no solution if more than DIVERGED of it is left as
 * approach. */
const int SWEEPS = 100;
const double CONVERGED = 1e-6, DIVERGED = 1e-3;

/* Adds an impulse per mass at the contact with normal n. */
void push(const double n[3], const double p[3], double radius, double v[3], double omega[3]) {
  double across[3];
  vector_cross(n, p, across);
  vector_add_scaled(v, 1, p, v);
  vector_add_scaled(omega, -2.5 / radius, across, omega);
}

/* The velocity of the sphere's surface at a contact, relative to the wall. */
void slip(const Support &s, double radius, const double v[3], const double omega[3], double u[3]) {
  double across[3];
  vector_cross(omega, s.n, across);
  vector_subtract(v, s.w, u);
  vector_add_scaled(u, -radius, across, u);
}

/* Solves one contact for the present impulses of the others. */
void solve_one(Support &s, double radius, double v[3], double omega[3]) {
  double u[3], p[3], change[3];
  slip(s, radius, v, omega, u);
  /* Without this contact's own impulse, which moves its surface 7/2 times as much along the wall.
   */
  const double own = vector_dot(s.p, s.n), normal = vector_dot(u, s.n) - own;
  vector_add_scaled(u, -vector_dot(u, s.n), s.n, u);
  vector_add_scaled(u, -3.5, s.p, u);
  vector_add_scaled(u, 3.5 * own, s.n, u);
  const double p_n = std::max(0.0, -normal), stop = 2.0 / 7 * vector_length(u);
  const double most = s.friction * p_n;
  for (int d = 0; d < 3; d++)
    p[d] = p_n * s.n[d] - (stop > most ? most / stop : 1) * 2.0 / 7 * u[d];
  vector_subtract(p, s.p, change);
  push(s.n, change, radius, v, omega);
  vector_copy(p, s.p);
}

/* Sweeps from no impulses on. False if an approach is left. */
bool sweep(std::vector<Support> &supports, double radius, double v[3], double omega[3]) {
  for (Support &s : supports)
    s.p[0] = s.p[1] = s.p[2] = 0;
  double first = 0, left = 0;
  for (int n = 0; n < SWEEPS; n++) {
    double v_then[3], omega_then[3], dv[3], domega[3];
    vector_copy(v, v_then);
    vector_copy(omega, omega_then);
    for (Support &s : supports)
      solve_one(s, radius, v, omega);
    if (supports.size() == 1)
      return true;
    vector_subtract(v, v_then, dv);
    vector_subtract(omega, omega_then, domega);
    const double change = vector_length(dv) + radius * vector_length(domega);
    if (n == 0)
      first = change;
    if (!(change > CONVERGED * first))
      break;
  }
  for (const Support &s : supports) {
    double u[3];
    slip(s, radius, v, omega, u);
    left = std::max(left, -vector_dot(u, s.n));
  }
  return !(left > DIVERGED * first);
}

} // namespace

bool asperity::solve_supports(std::vector<Support> &supports, double radius, double v[3],
                              double omega[3]) {
  double v_free[3], omega_free[3];
  vector_copy(v, v_free);
  vector_copy(omega, omega_free);
  if (sweep(supports, radius, v, omega))
    return true;
  /* Sweeps with friction may go round in a circle. */
  for (Support &s : supports)
    s.friction = 0;
  vector_copy(v_free, v);
  vector_copy(omega_free, omega);
  if (sweep(supports, radius, v, omega))
    return true;
  const double share = 1.0 / static_cast<double>(supports.size());
  double mean[3] = {0, 0, 0};
  for (const Support &s : supports)
    vector_add_scaled(mean, share, s.w, mean);
  for (Support &s : supports) {
    vector_subtract(mean, v_free, s.p);
    vector_scale(share, s.p);
  }
  vector_copy(mean, v);
  vector_copy(omega_free, omega);
  return false;
}

double asperity::slide_work(const Support &support, double radius, const double v[3],
                            const double omega[3]) {
  double u[3];
  slip(support, radius, v, omega, u);
  vector_add_scaled(u, -vector_dot(u, support.n), support.n, u);
  return std::max(0.0, -vector_dot(support.p, u));
}
