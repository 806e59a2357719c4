/* Contacts that last; see held.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/held.h"

#include <math.h>

#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

namespace {

/* Sweeps over several contacts. They end when a sweep changes the impulses by less than CONVERGED
 * of all of them, and of a ball of the approach, which is less in a narrow groove, or TINY of the
 * velocity. CONVERGED_OF_BODY: impacts of bodies are solved so, too. Where normals are nearly
 * parallel, changes shrink slowly, by the same share in each: with each JUMP of them a ball goes on
 * to their limit, if each is less than LAST of the one before. After SLOW of them all normal
 * impulses are solved at once in each. They have found no solution if more than DIVERGED of the
 * first approach is left. */
const int JUMP = 4, SLOW = 80, SWEEPS = 120, SWEEPS_OF_BODY = 300;
const double LAST = 0.999;
const double CONVERGED = 1e-6, CONVERGED_OF_BODY = 1e-11, TINY = 1e-15;
const double DIVERGED = 1e-3, DIVERGED_OF_BODY = 0.1;

/* Softness of each contact: of the many solutions for points that are more than a body's freedom it
 * makes one. */
const double SOFT = 1e-11;

/* The change of the spin by an impulse per mass at a contact. */
inline void turn_of(const Mover &mover, const Held &s, const double p[3], double turn[3]) {
  if (!mover.is_ball)
    mover.twist(s.arm, p, turn);
  else if (s.hold > 0)
    aspi_copy(NONE, turn);
  else {
    aspi_cross(s.n, p, turn);
    aspi_scale(-2.5 / mover.sphere->radius, turn);
  }
}

/* Adds an impulse per mass at a contact. */
inline void push(const Mover &mover, const Held &s, const double p[3], double v[3],
                 double omega[3]) {
  double turn[3];
  aspi_add_scaled(v, 1, p, v);
  turn_of(mover, s, p, turn);
  aspi_add_scaled(omega, 1, turn, omega);
}

/* The velocity of the sphere's surface at a contact, or of its center in a valley, relative to the
 * wall. */
inline void slip(const Mover &mover, const Held &s, const double v[3], const double omega[3],
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

/* The impulse that one contact of a ball needs where its surface has the velocity u without it, and
 * the work of friction. False: it is along n. */
inline bool impulse(Held &s, const double u[3], double p[3]) {
  const double normal = aspi_dot(u, s.n), p_n = std::max(0.0, -normal);
  double along[3];
  aspi_add_scaled(u, -normal, s.n, along);
  const double square = aspi_dot(along, along);
  aspi_copy(s.n, p);
  aspi_scale(p_n, p);
  s.work = 0;
  if (!(square > 0))
    return false;
  const double most = (s.hold > 0 ? s.hold : s.friction) * p_n, stops = s.hold > 0 ? 1 : 2.0 / 7;
  if (stops * stops * square > most * most) {
    const double share = most / sqrt(square);
    s.work = share * (1 - share / stops) * square;
    aspi_add_scaled(p, -share, along, p);
  } else
    aspi_add_scaled(p, -stops, along, p);
  return true;
}

/* ---- contacts one after another ---- */

void find_response(const Mover &mover, Held &s) {
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
void impulse_of_body(const Held &s, const double u[3], double p[3]) {
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
inline void solve_one(const Mover &mover, Held &s, double v[3], double omega[3]) {
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

/* Solves a x = b by Gauss's elimination with the largest pivots; x in the place of b. */
void eliminate(std::vector<double> &a, std::vector<double> &b) {
  const size_t n = b.size();
  for (size_t c = 0; c < n; c++) {
    size_t top = c;
    for (size_t r = c + 1; r < n; r++)
      if (fabs(a[r * n + c]) > fabs(a[top * n + c]))
        top = r;
    std::swap_ranges(&a[c * n], &a[c * n] + n, &a[top * n]);
    std::swap(b[c], b[top]);
    for (size_t r = c + 1; r < n; r++) {
      const double by = a[r * n + c] / a[c * n + c];
      for (size_t k = c; k < n; k++)
        a[r * n + k] -= by * a[c * n + k];
      b[r] -= by * b[c];
    }
  }
  for (size_t c = n; c-- > 0;) {
    for (size_t k = c + 1; k < n; k++)
      b[c] -= a[c * n + k] * b[k];
    b[c] /= a[c * n + c];
  }
}

/* The normal impulses of all contacts at once, for the friction that there is. */
class Normals {
public:
  Normals(const Mover &mover, HeldList all, const double v[3], const double omega[3]);
  /* Closes what approaches, and opens what would pull, until there is none. */
  void solve(double tiny);
  double operator[](size_t k) const {
    return p_[k];
  }

private:
  /* The normal velocity of a contact. */
  double velocity(size_t r) const {
    double u = free_[r];
    for (size_t c = 0; c < n_; c++)
      u += w_[r * n_ + c] * p_[c];
    return u;
  }
  void solve_closed();

  const size_t n_;
  std::vector<double> w_, free_, p_; /* row r: velocity of a contact by each impulse, and by none */
  std::vector<size_t> closed_;
};

Normals::Normals(const Mover &mover, HeldList all, const double v[3], const double omega[3])
    : n_(all.count), w_(n_ * n_), free_(n_), p_(n_) {
  double u[3];
  for (size_t c = 0; c < n_; c++) {
    double by[3] = {0, 0, 0}, turn[3] = {0, 0, 0};
    const Held &s = all.first[c];
    push(mover, s, s.n, by, turn);
    for (size_t r = 0; r < n_; r++) {
      const Held &at = all.first[r];
      slip(mover, at, by, turn, u);
      w_[r * n_ + c] = aspi_dot(u, at.n) + aspi_dot(at.w, at.n);
    }
    p_[c] = aspi_dot(s.p, s.n);
  }
  for (size_t r = 0; r < n_; r++) {
    slip(mover, all.first[r], v, omega, u);
    free_[r] = aspi_dot(u, all.first[r].n) - velocity(r);
    if (p_[r] > 0 || free_[r] < 0)
      closed_.push_back(r);
  }
}

void Normals::solve_closed() {
  const size_t size = closed_.size();
  std::vector<double> a(size * size), b(size);
  for (size_t r = 0; r < size; r++) {
    b[r] = -free_[closed_[r]];
    for (size_t c = 0; c < size; c++)
      a[r * size + c] = w_[closed_[r] * n_ + closed_[c]] + (r == c ? SOFT : 0);
  }
  eliminate(a, b);
  p_.assign(n_, 0.);
  for (size_t r = 0; r < size; r++)
    p_[closed_[r]] = b[r];
}

void Normals::solve(double tiny) {
  for (size_t round = 0; round < 5 * n_; round++) {
    solve_closed();
    const auto least = std::min_element(p_.begin(), p_.end());
    if (*least < 0) {
      const size_t pulls = static_cast<size_t>(least - p_.begin());
      closed_.erase(std::find(closed_.begin(), closed_.end(), pulls));
      continue;
    }
    const size_t size = closed_.size();
    for (size_t r = 0; r < n_; r++)
      if (velocity(r) < -tiny && std::find(closed_.begin(), closed_.end(), r) == closed_.end())
        closed_.push_back(r);
    if (closed_.size() == size)
      return;
  }
}

void solve_normals(const Mover &mover, HeldList all, double tiny, double v[3], double omega[3]) {
  Normals normals(mover, all, v, omega);
  normals.solve(tiny);
  for (size_t k = 0; k < all.count; k++) {
    Held &s = all.first[k];
    double change[3];
    aspi_copy(s.n, change);
    aspi_scale(normals[k] - aspi_dot(s.p, s.n), change);
    aspi_add_scaled(s.p, 1, change, s.p);
    push(mover, s, change, v, omega);
  }
}

/* Gauss-Seidel sweeps over the contacts, which after some become slow where normals are nearly
 * opposite, or more than a body's freedom: then all normal impulses are solved at once in each.
 * False if an approach is left. */
bool sweep(const Mover &mover, HeldList all, double v[3], double omega[3]) {
  const double converged = mover.is_ball ? CONVERGED : CONVERGED_OF_BODY;
  double first = 0, left = 0, before = 0, speed = aspi_length(v), u[3];
  for (Held &s : all) {
    slip(mover, s, v, omega, u);
    first = std::max(first, -aspi_dot(u, s.n));
    speed = std::max(speed, aspi_length(s.w));
  }
  for (Held &s : all) {
    push(mover, s, s.p, v, omega);
    aspi_copy(NONE, s.change);
  }
  const int most = mover.is_ball ? SWEEPS : SWEEPS_OF_BODY;
  for (int n = 0; n < most; n++) {
    double now = 0, sum = 0, along = 0;
    for (Held &s : all) {
      double change[3];
      aspi_copy(s.p, change);
      solve_one(mover, s, v, omega);
      aspi_subtract(s.p, change, change);
      now += aspi_dot(change, change);
      along += aspi_dot(change, s.change);
      aspi_copy(change, s.change);
      sum += aspi_dot(s.p, s.p);
    }
    const double scale = mover.is_ball ? std::min(first, sqrt(sum)) : sqrt(sum);
    if (!(sqrt(now) > converged * scale + TINY * speed))
      break;
    if (n >= SLOW)
      solve_normals(mover, all, ROUNDING * first, v, omega);
    else if (mover.is_ball && n % JUMP == JUMP - 1 && along > 0 && along < LAST * before)
      for (Held &s : all) { /* the changes to come, a geometric series */
        aspi_scale(along / (before - along), s.change);
        aspi_add_scaled(s.p, 1, s.change, s.p);
        push(mover, s, s.change, v, omega);
      }
    before = now;
  }
  for (Held &s : all) {
    slip(mover, s, v, omega, u);
    left = std::max(left, -aspi_dot(u, s.n));
  }
  return !(left > (mover.is_ball ? DIVERGED : DIVERGED_OF_BODY) * first + TINY * speed);
}

bool solve(const Mover &mover, HeldList all, double v[3], double omega[3]) {
  double v_free[3], omega_free[3];
  for (Held &s : all)
    if (!mover.is_ball)
      find_response(mover, s);
  aspi_copy(v, v_free);
  aspi_copy(omega, omega_free);
  if (sweep(mover, all, v, omega))
    return true;
  /* Sweeps with friction may go round in a circle. */
  for (Held &s : all)
    s.friction = s.hold = s.p[0] = s.p[1] = s.p[2] = 0;
  aspi_copy(v_free, v);
  aspi_copy(omega_free, omega);
  if (sweep(mover, all, v, omega))
    return true;
  const double share = 1.0 / static_cast<double>(all.count);
  double mean[3] = {0, 0, 0};
  for (Held &s : all)
    aspi_add_scaled(mean, share, s.w, mean);
  for (Held &s : all) {
    aspi_subtract(mean, v_free, s.p);
    aspi_scale(share, s.p);
  }
  aspi_copy(mean, v);
  aspi_copy(omega_free, omega);
  return false;
}

/* Where a valley holds a ball, that turns about the normal only. */
inline void stop_rolling(Held &s, double omega[3]) {
  if (!(s.hold > 0) || !(aspi_dot(s.p, s.n) > 0))
    return;
  aspi_add_scaled(s.turn, -1, omega, s.turn);
  aspi_add_scaled(s.turn, aspi_dot(omega, s.n), s.n, s.turn);
  aspi_add_scaled(omega, 1, s.turn, omega);
}

/* Impulse times sliding speed. */
double slide_work(const Mover &mover, const Held &s, const double v[3], const double omega[3]) {
  double u[3];
  slip(mover, s, v, omega, u);
  aspi_add_scaled(u, -aspi_dot(u, s.n), s.n, u);
  return std::max(0.0, -aspi_dot(s.p, u));
}

} // namespace

bool asperity::solve_held(const Mover &mover, HeldList all, double v[3], double omega[3]) {
  if (mover.is_ball && all.count == 1) {
    Held &only = all.first[0];
    double u[3];
    slip(mover, only, v, omega, u);
    aspi_copy(NONE, only.turn);
    if (impulse(only, u, only.p)) {
      turn_of(mover, only, only.p, only.turn);
      aspi_add_scaled(omega, 1, only.turn, omega);
    }
    aspi_add_scaled(v, 1, only.p, v);
    stop_rolling(only, omega);
    return true;
  }
  const bool solved = solve(mover, all, v, omega);
  for (Held &s : all) {
    turn_of(mover, s, s.p, s.turn);
    if (mover.is_ball)
      stop_rolling(s, omega);
    s.work = slide_work(mover, s, v, omega);
  }
  return solved;
}
