/* Contacts of a body at several points; see body_solve.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/body_solve.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

/* Sweeps, at most, and the change of the impulses in one at which they end: over their sum, and
 * over the momentum of the body, whose rounding it cannot pass. */
static const int SWEEPS = 300;
static const double CONVERGED = 1e-11, ROUNDED = 1e-14;

void asperity::multiply(const double m[6], const double a[3], double out[3]) {
  const double x = a[0], y = a[1], z = a[2];
  out[0] = m[0] * x + m[3] * y + m[4] * z;
  out[1] = m[3] * x + m[1] * y + m[5] * z;
  out[2] = m[4] * x + m[5] * y + m[2] * z;
}

/* Adds an impulse at a point to the velocity and the spin. */
static void push(const asp_body &body, const double arm[3], const double impulse[3], double v[3],
                 double omega[3]) {
  double couple[3], turn[3];
  aspi_add_scaled(v, body.inverse_mass, impulse, v);
  aspi_cross(arm, impulse, couple);
  multiply(body.inverse_inertia, couple, turn);
  aspi_add_scaled(omega, 1, turn, omega);
}

/* K of a point: row d is the velocity of the point by the impulse e_d there. */
static void inverse_mass(const asp_body &body, const double arm[3], double k[3][3]) {
  for (int d = 0; d < 3; d++) {
    double impulse[3] = {0, 0, 0}, v[3] = {0, 0, 0}, omega[3] = {0, 0, 0}, turned[3];
    impulse[d] = 1;
    push(body, arm, impulse, v, omega);
    aspi_cross(omega, arm, turned);
    aspi_add_scaled(v, 1, turned, k[d]);
  }
}

/* The impulse that takes the velocity u of a point: K^-1 u, K symmetric. */
static void stop(const double k[3][3], const double u[3], double impulse[3]) {
  double c[3][3];
  for (int d = 0; d < 3; d++)
    aspi_cross(k[(d + 1) % 3], k[(d + 2) % 3], c[d]);
  const double det = aspi_dot(k[0], c[0]);
  for (int d = 0; d < 3; d++)
    impulse[d] = -aspi_dot(c[d], u) / det;
}

/* The impulse of a point that slides or parts: its approach is taken, then its friction cut. */
static void slide(const double k[3][3], const double u[3], const BodyPoint &at, double p[3]) {
  double along[3], n_k[3] = {0, 0, 0};
  for (int d = 0; d < 3; d++)
    aspi_add_scaled(n_k, at.n[d], k[d], n_k);
  const double k_n = aspi_dot(n_k, at.n), across = k[0][0] + k[1][1] + k[2][2] - k_n;
  const double u_n = aspi_dot(u, at.n), before = aspi_dot(at.p, at.n);
  const double normal = std::max(0.0, before - u_n / k_n), most = at.friction * normal;
  aspi_add_scaled(u, -u_n, at.n, along);
  aspi_add_scaled(at.p, -before, at.n, p);
  aspi_add_scaled(p, -1 / across, along, p);
  const double length = aspi_length(p);
  if (length > most)
    aspi_scale(most / length, p);
  aspi_add_scaled(p, normal, at.n, p);
}

/* Solves one point for the present impulses of the others; returns the change of its impulse. */
static double solve_one(const asp_body &body, const double k[3][3], BodyPoint &at, double v[3],
                        double omega[3]) {
  double u[3], turned[3], p[3], change[3], along[3];
  aspi_cross(omega, at.arm, turned);
  aspi_subtract(v, at.w, u);
  aspi_add_scaled(u, 1, turned, u);
  stop(k, u, p);
  aspi_add_scaled(at.p, 1, p, p);
  const double normal = aspi_dot(p, at.n);
  aspi_add_scaled(p, -normal, at.n, along);
  if (!(normal >= 0 && aspi_length(along) <= at.friction * normal))
    slide(k, u, at, p);
  aspi_subtract(p, at.p, change);
  push(body, at.arm, change, v, omega);
  aspi_copy(p, at.p);
  return aspi_length(change);
}

void asperity::solve_body(const asp_body &body, const double v[3], const double omega[3],
                          std::vector<BodyPoint> &points) {
  double now[3], spin[3];
  aspi_copy(v, now);
  aspi_copy(omega, spin);
  double speed = 0;
  std::vector<double> rows(9 * points.size());
  double(*const k)[3][3] = reinterpret_cast<double(*)[3][3]>(rows.data());
  for (size_t i = 0; i < points.size(); i++) {
    points[i].p[0] = points[i].p[1] = points[i].p[2] = 0;
    inverse_mass(body, points[i].arm, k[i]);
    speed = std::max(speed, aspi_length(v) + aspi_length(points[i].w) +
                                aspi_length(omega) * aspi_length(points[i].arm));
  }
  const double least = ROUNDED * speed / body.inverse_mass;
  for (int i = 0; i < SWEEPS; i++) {
    double change = 0, sum = 0;
    for (size_t j = 0; j < points.size(); j++) {
      change = std::max(change, solve_one(body, k[j], points[j], now, spin));
      sum += aspi_length(points[j].p);
    }
    if (!(change > CONVERGED * sum + least))
      return;
  }
}
