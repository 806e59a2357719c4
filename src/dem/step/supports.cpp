/* Contacts that last; see supports.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/supports.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

namespace {

/* Sweeps over several contacts. They end when a sweep changes the impulses by less than CONVERGED
 * of all of them, or TINY of the velocity: of a ball, and of a body, whose impacts are solved so,
 * too. They have found no solution if more than DIVERGED of the first approach is left; the points
 * of a body are often more than its freedom, and sweeps over them are slow. */
const int SWEEPS = 100, SWEEPS_OF_BODY = 300;
const double CONVERGED = 1e-6, CONVERGED_OF_BODY = 1e-11, TINY = 1e-15;
const double DIVERGED = 1e-3, DIVERGED_OF_BODY = 0.1;

/* The factor by which changes shrink, at most. */
const double SHRINKS = 0.98;

/* Dimensionless determinants below this count as 0: then two contacts are solved by sweeps. */
const double REGULAR = 1e-6;

/* Adds an impulse per mass at a contact. */
inline void push(const Mover &mover, const Support &s, const double p[3], double v[3],
                 double omega[3]) {
  double turned[3];
  aspi_add_scaled(v, 1, p, v);
  if (!mover.is_ball) {
    mover.twist(s.arm, p, turned);
    aspi_add_scaled(omega, 1, turned, omega);
  } else if (!(s.hold > 0)) {
    aspi_cross(s.n, p, turned);
    aspi_add_scaled(omega, -2.5 / mover.sphere->radius, turned, omega);
  }
}

/* The velocity of the sphere's surface at a contact, or of its center in a valley, relative to the
 * wall. */
inline void slip(const Mover &mover, const Support &s, const double v[3], const double omega[3],
                 double u[3]) {
  double across[3];
  aspi_subtract(v, s.w, u);
  if (!mover.is_ball) {
    aspi_cross(omega, s.arm, across);
    aspi_add_scaled(u, 1, across, u);
  } else if (!(s.hold > 0)) {
    aspi_cross(omega, s.n, across);
    aspi_add_scaled(u, -mover.sphere->radius, across, u);
  }
}

/* The impulse that one contact of a ball needs where its surface has the velocity u without it. */
inline void impulse(const Support &s, const double u[3], double p[3]) {
  const double normal = aspi_dot(u, s.n), p_n = std::max(0.0, -normal);
  const double most = (s.hold > 0 ? s.hold : s.friction) * p_n, stops = s.hold > 0 ? 1 : 2.0 / 7;
  double along[3];
  aspi_add_scaled(u, -normal, s.n, along);
  const double square = aspi_dot(along, along);
  const double share = stops * stops * square > most * most ? most / sqrt(square) : stops;
  for (int d = 0; d < 3; d++)
    p[d] = p_n * s.n[d] - share * along[d];
}

/* ---- contacts one after another ---------------------------------------------------------------
 */

void find_response(const Mover &mover, Support &s) {
  for (int d = 0; d < 3; d++) {
    double p[3] = {0, 0, 0}, turned[3], across[3];
    p[d] = 1;
    mover.twist(s.arm, p, turned);
    aspi_cross(turned, s.arm, across);
    aspi_add_scaled(p, 1, across, s.k[d]);
  }
}

/* The impulse that takes the velocity u of a point: -K^-1 u, K symmetric. */
void stop(const double k[3][3], const double u[3], double p[3]) {
  double c[3][3];
  for (int d = 0; d < 3; d++)
    aspi_cross(k[(d + 1) % 3], k[(d + 2) % 3], c[d]);
  const double det = aspi_dot(k[0], c[0]);
  for (int d = 0; d < 3; d++)
    p[d] = -aspi_dot(c[d], u) / det;
}

/* The impulse of a point of a body that has the velocity u with the present one: the point stops,
 * or where friction cannot hold it or it parts, its approach is taken, then its friction cut. */
void impulse_of_body(const Support &s, const double u[3], double p[3]) {
  const double friction = s.hold > 0 ? s.hold : s.friction;
  double along[3], n_k[3] = {0, 0, 0};
  stop(s.k, u, p);
  aspi_add_scaled(s.p, 1, p, p);
  const double p_n = aspi_dot(p, s.n);
  aspi_add_scaled(p, -p_n, s.n, along);
  if (p_n >= 0 && aspi_length(along) <= friction * p_n)
    return;
  for (int d = 0; d < 3; d++)
    aspi_add_scaled(n_k, s.n[d], s.k[d], n_k);
  const double k_n = aspi_dot(n_k, s.n), across = s.k[0][0] + s.k[1][1] + s.k[2][2] - k_n;
  const double u_n = aspi_dot(u, s.n), before = aspi_dot(s.p, s.n);
  const double normal = std::max(0.0, before - u_n / k_n), most = friction * normal;
  aspi_add_scaled(u, -u_n, s.n, along);
  aspi_add_scaled(s.p, -before, s.n, p);
  aspi_add_scaled(p, -1 / across, along, p);
  const double length = aspi_length(p);
  if (length > most)
    aspi_scale(most / length, p);
  aspi_add_scaled(p, normal, s.n, p);
}

/* Solves one contact for the present impulses of the others. */
inline void solve_one(const Mover &mover, Support &s, double v[3], double omega[3]) {
  double u[3], p[3], change[3];
  slip(mover, s, v, omega, u);
  if (mover.is_ball) {
    /* Its own impulse moves its surface 7/2 times as much along the wall. */
    const double more = s.hold > 0 ? 0 : 2.5;
    aspi_add_scaled(u, -1 - more, s.p, u);
    aspi_add_scaled(u, more * aspi_dot(s.p, s.n), s.n, u);
    impulse(s, u, p);
  } else
    impulse_of_body(s, u, p);
  aspi_subtract(p, s.p, change);
  push(mover, s, change, v, omega);
  aspi_copy(p, s.p);
}

/* Gauss-Seidel sweeps over the supports. The changes soon shrink by one factor from sweep to sweep:
 * every third sweep, the impulses jump by the sum of the remaining series (Aitken). False if an
 * approach is left. */
bool sweep(const Mover &mover, const Supports &supports, double v[3], double omega[3]) {
  const int most = mover.is_ball ? SWEEPS : SWEEPS_OF_BODY;
  const double converged = mover.is_ball ? CONVERGED : CONVERGED_OF_BODY;
  double first = 0, left = 0, speed = aspi_length(v), u[3];
  for (Support &s : supports) {
    s.change[0] = s.change[1] = s.change[2] = 0;
    slip(mover, s, v, omega, u);
    first = std::max(first, -aspi_dot(u, s.n));
    speed = std::max(speed, aspi_length(s.w));
  }
  for (Support &s : supports)
    push(mover, s, s.p, v, omega);
  for (int n = 0; n < most; n++) {
    double before = 0, product = 0, now = 0, all = 0;
    for (Support &s : supports) {
      double then[3], last[3];
      aspi_copy(s.p, then);
      aspi_copy(s.change, last);
      solve_one(mover, s, v, omega);
      aspi_subtract(s.p, then, s.change);
      before += aspi_dot(last, last);
      product += aspi_dot(s.change, last);
      now += aspi_dot(s.change, s.change);
      all += aspi_dot(s.p, s.p);
    }
    if (!(sqrt(now) > converged * sqrt(all) + TINY * speed))
      break;
    if (n % 3 != 2 || !(product > 0 && product < SHRINKS * before))
      continue;
    for (Support &s : supports) {
      aspi_scale(product / (before - product), s.change);
      aspi_add_scaled(s.p, 1, s.change, s.p);
      push(mover, s, s.change, v, omega);
    }
  }
  for (Support &s : supports) {
    slip(mover, s, v, omega, u);
    left = std::max(left, -aspi_dot(u, s.n));
  }
  return !(left > (mover.is_ball ? DIVERGED : DIVERGED_OF_BODY) * first + TINY * speed);
}

/* ---- two contacts -----------------------------------------------------------------------------
 */

/* One contact as if it were alone. False if the other one would be approached then. */
bool solve_alone(const Mover &mover, Support &s, Support &other, double v[3], double omega[3]) {
  double u[3], v_after[3], omega_after[3];
  slip(mover, s, v, omega, u);
  impulse(s, u, s.p);
  aspi_copy(v, v_after);
  aspi_copy(omega, omega_after);
  push(mover, s, s.p, v_after, omega_after);
  aspi_subtract(v_after, other.w, u);
  if (-aspi_dot(u, other.n) > CONVERGED * aspi_length(s.p))
    return false;
  aspi_copy(v_after, v);
  aspi_copy(omega_after, omega);
  other.p[0] = other.p[1] = other.p[2] = 0;
  return true;
}

/* Two contacts without friction. */
bool solve_smooth(Support &a, Support &b, double v[3]) {
  double u[3];
  const double cosine = aspi_dot(a.n, b.n), det = 1 - cosine * cosine;
  aspi_subtract(v, a.w, u);
  const double approach_a = -aspi_dot(u, a.n);
  aspi_subtract(v, b.w, u);
  const double approach_b = -aspi_dot(u, b.n);
  const double p_a = approach_a - cosine * approach_b, p_b = approach_b - cosine * approach_a;
  if (a.friction > 0 || b.friction > 0 || a.hold > 0 || b.hold > 0 || !(det > REGULAR) || p_a < 0 ||
      p_b < 0)
    return false;
  for (int d = 0; d < 3; d++) {
    a.p[d] = p_a / det * a.n[d];
    b.p[d] = p_b / det * b.n[d];
    v[d] += a.p[d] + b.p[d];
  }
  return true;
}

/* Narrows the numbers lo to hi to those for which the impulse p + number * by at this contact is
 * within the cone of friction. by.n must be positive. */
bool narrow(const Support &s, const double p[3], const double by[3], double &lo, double &hi) {
  const double p_n = aspi_dot(p, s.n), by_n = aspi_dot(by, s.n);
  const double factor = 1 + s.friction * s.friction;
  const double a = aspi_dot(by, by) - factor * by_n * by_n,
               b = aspi_dot(p, by) - factor * p_n * by_n, c = aspi_dot(p, p) - factor * p_n * p_n;
  const double square = b * b - a * c;
  if (!(square > 0) || !(fabs(a) > REGULAR))
    return false;
  const double root = sqrt(square), one = (-b - root) / a, two = (-b + root) / a;
  if (a < 0) /* beyond the larger root, where the normal impulse is positive */
    lo = std::max(lo, std::max(one, two));
  else {
    if (p_n + 0.5 * (one + two) * by_n < 0)
      return false;
    lo = std::max(lo, one);
    hi = std::min(hi, two);
  }
  return lo <= hi;
}

/* Two contacts where the sphere slides at neither. Its surface has the wall's velocity at both, so
 * that it can only turn about the line through them. Of impulses that push both contacts apart
 * along that line there may be any number: the least that friction allows are taken. With s = r
 * omega, m and h half the sum and half the difference of the normals, P the sum of the impulses and
 * D half their difference, the two conditions on the surface and the balances are
 *
 *   v' = (w1 + w2)/2 + s' x m,   h x s' = (w1 - w2)/2,   P = v' - v,   s' - s = -5/2 (m x P + 2 h x
 * D)
 */
bool solve_sticking(const Mover &mover, Support &a, Support &b, double v[3], double omega[3]) {
  const double radius = mover.sphere->radius;
  double m[3], h[3], w[3], dw[3], s[3], e[3], after[3], p[3], turn[3], across[3], apart[3];
  for (int d = 0; d < 3; d++) {
    m[d] = 0.5 * (a.n[d] + b.n[d]);
    h[d] = 0.5 * (a.n[d] - b.n[d]);
    w[d] = 0.5 * (a.w[d] + b.w[d]);
    dw[d] = 0.5 * (a.w[d] - b.w[d]);
  }
  const double square = aspi_dot(h, h), half = sqrt(square);
  if (!(square > REGULAR) || a.hold > 0 || b.hold > 0)
    return false;
  aspi_cross(dw, h, s);
  aspi_scale(1 / square, s); /* across h; the part along it, by the balance along h: */
  aspi_cross(h, m, e);
  aspi_scale(1 / half, e);
  aspi_cross(s, m, after);
  aspi_add_scaled(after, 1, w, after);
  aspi_subtract(after, v, p);
  const double spin =
      (radius * aspi_dot(omega, h) / half - 2.5 * aspi_dot(e, p)) / (1 + 2.5 * aspi_dot(m, m));
  aspi_add_scaled(s, spin / half, h, s);
  aspi_add_scaled(p, spin, e, p);
  aspi_add_scaled(s, -radius, omega, turn);
  aspi_cross(m, p, across);
  aspi_add_scaled(across, 0.4, turn, across);
  aspi_cross(across, h, apart);
  aspi_scale(-0.5 / square, apart);
  double p_a[3], p_b[3], back[3], lo = -HUGE_VAL, hi = HUGE_VAL;
  for (int d = 0; d < 3; d++) {
    p_a[d] = 0.5 * p[d] + apart[d];
    p_b[d] = 0.5 * p[d] - apart[d];
    back[d] = -h[d];
  }
  if (!narrow(a, p_a, h, lo, hi) || !narrow(b, p_b, back, lo, hi))
    return false;
  aspi_add_scaled(p_a, lo, h, a.p);
  aspi_add_scaled(p_b, lo, back, b.p);
  /* Walls that part or close along the line, too, leave no such solution. */
  double u_a[3], u_b[3], v_after[3], omega_after[3];
  aspi_add_scaled(v, 1, p, v_after);
  aspi_copy(s, omega_after);
  aspi_scale(1 / radius, omega_after);
  slip(mover, a, v_after, omega_after, u_a);
  slip(mover, b, v_after, omega_after, u_b);
  if (aspi_dot(u_a, u_a) + aspi_dot(u_b, u_b) > CONVERGED * CONVERGED * aspi_dot(p, p))
    return false;
  aspi_copy(v_after, v);
  aspi_copy(omega_after, omega);
  return true;
}

/* Up to two contacts of a ball in closed form, where there is one. */
bool solve_few(const Mover &mover, const Supports &supports, double v[3], double omega[3]) {
  Support &a = supports.first[0];
  if (supports.count == 1) {
    double u[3];
    slip(mover, a, v, omega, u);
    impulse(a, u, a.p);
    push(mover, a, a.p, v, omega);
    return true;
  }
  if (supports.count > 2)
    return false;
  Support &b = supports.first[1];
  double p_a[3], p_b[3];
  aspi_copy(a.p, p_a);
  aspi_copy(b.p, p_b);
  if (solve_alone(mover, a, b, v, omega) || solve_alone(mover, b, a, v, omega) ||
      solve_smooth(a, b, v) || solve_sticking(mover, a, b, v, omega))
    return true;
  aspi_copy(p_a, a.p);
  aspi_copy(p_b, b.p);
  return false;
}

bool solve(const Mover &mover, const Supports &supports, double v[3], double omega[3]) {
  double v_free[3], omega_free[3];
  if (mover.is_ball && solve_few(mover, supports, v, omega))
    return true;
  for (Support &s : supports)
    if (!mover.is_ball)
      find_response(mover, s);
  aspi_copy(v, v_free);
  aspi_copy(omega, omega_free);
  if (sweep(mover, supports, v, omega))
    return true;
  /* Sweeps with friction may go round in a circle. */
  for (Support &s : supports)
    s.friction = s.hold = s.p[0] = s.p[1] = s.p[2] = 0;
  aspi_copy(v_free, v);
  aspi_copy(omega_free, omega);
  if (sweep(mover, supports, v, omega))
    return true;
  const double share = 1.0 / static_cast<double>(supports.count);
  double mean[3] = {0, 0, 0};
  for (Support &s : supports)
    aspi_add_scaled(mean, share, s.w, mean);
  for (Support &s : supports) {
    aspi_subtract(mean, v_free, s.p);
    aspi_scale(share, s.p);
  }
  aspi_copy(mean, v);
  aspi_copy(omega_free, omega);
  return false;
}

} // namespace

bool asperity::solve_supports(const Mover &mover, const Supports &supports, double v[3],
                              double omega[3]) {
  const bool solved = solve(mover, supports, v, omega);
  for (Support &s : supports) {
    s.turn[0] = s.turn[1] = s.turn[2] = 0;
    if (!mover.is_ball || !(s.hold > 0) || !(aspi_dot(s.p, s.n) > 0))
      continue;
    aspi_add_scaled(s.turn, -1, omega, s.turn); /* it turns about the normal only */
    aspi_add_scaled(s.turn, aspi_dot(omega, s.n), s.n, s.turn);
    aspi_add_scaled(omega, 1, s.turn, omega);
  }
  return solved;
}

double asperity::slide_work(const Mover &mover, const Support &support, const double v[3],
                            const double omega[3]) {
  double u[3];
  slip(mover, support, v, omega, u);
  aspi_add_scaled(u, -aspi_dot(u, support.n), support.n, u);
  return std::max(0.0, -aspi_dot(support.p, u));
}
