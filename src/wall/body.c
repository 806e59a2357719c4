/* The impact of a body at one point, by Routh's incremental impulse (Routh 1905; Keller 1986; Bhatt
 * & Koechling 1995) with Stronge's energetic restitution (Stronge 1990; all by secondary sources).
 * The normal impulse p grows from 0; meanwhile the point slides, with friction against its
 * velocity, or sticks, where less friction than Coulomb's suffices, or begins to slide again:
 *
 *   du/dp = K (m - mu u_t/|u_t|)
 *
 * until the work of the normal impulse has come back from its least value, that of compression, to
 * 1 - e^2 times it. Newton's restitution with Coulomb's friction gains energy for some bodies (Kane
 * & Levinson 1985); here the normal impulse and friction can only take it, in the sums below too:
 * a stretch has a constant direction, that of the sliding at its middle, so that its work is exact
 * and not positive. In a plane, and of a sphere, the path has no more than three stretches, and
 * there is no other error than rounding.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/body.h"

/* Most that the sliding may turn in one stretch (rad), and the share of its speed that it may lose.
 */
#define TURN_MOST 0.02
#define LOSS 0.2

/* Sliding keeps its direction if its turn over its change of speed is less than this. It has
 * stopped at this share of its first speed. */
#define STRAIGHT 1e-7
#define STOPPED 1e-9

/* Stretches after which the direction is kept. */
enum { STRETCHES = 2000, HALVINGS = 60 };

/* K in the frame (a, b, m), a and b along the face so that it has no coupling there. */
typedef struct inverse_mass {
  double a, b, m, am, bm;
} inverse_mass;

typedef struct lever_path {
  inverse_mass k;
  double friction, e2;
  double u_a, u_b, u_m; /* velocity of the point */
  double j_a, j_b, p;   /* impulse so far */
  double work, least;   /* work of the normal impulse so far, and its least value */
} lever_path;

vec aspi_body_turn(const asp_body *body, vec arm, vec impulse) {
  const double *i = body->inverse_inertia;
  vec l = cross(arm, impulse);
  return (vec){i[0] * l.x + i[3] * l.y + i[4] * l.z, i[3] * l.x + i[1] * l.y + i[5] * l.z,
               i[4] * l.x + i[5] * l.y + i[2] * l.z};
}

vec aspi_body_kick(const asp_body *body, vec arm, vec impulse) {
  return plus(scaled(impulse, body->inverse_mass), 1,
              cross(aspi_body_turn(body, arm, impulse), arm));
}

/* The normal impulse from here to the end of restitution, at the rate du_m/dp; INFINITY if it never
 * ends. */
static double to_end(const lever_path *at, double rate) {
  double before = 0, u = at->u_m, work = at->work, least = at->least;
  if (u < 0) {
    if (!(rate > 0))
      return INFINITY;
    before = -u / rate;
    work += 0.5 * u * before;
    least = fmin(least, work);
    u = 0;
  }
  double due = fmax(0, (least - work) - at->e2 * least), square = u * u + 2 * rate * due;
  if (!(due > 0))
    return before;
  return square > 0 ? before + 2 * due / (u + sqrt(square)) : INFINITY;
}

/* One stretch with friction against (s_a, s_b), of the normal impulse dp or less; true at the end
 * of restitution. */
static bool stretch(lever_path *at, double s_a, double s_b, double dp) {
  const inverse_mass *k = &at->k;
  double f_a = -at->friction * s_a, f_b = -at->friction * s_b;
  double rate = k->m + k->am * f_a + k->bm * f_b, end = to_end(at, rate), u_m = at->u_m;
  bool ended = end <= dp;
  dp = ended ? end : dp;
  at->p += dp;
  at->j_a += f_a * dp;
  at->j_b += f_b * dp;
  at->u_a += (k->am + k->a * f_a) * dp;
  at->u_b += (k->bm + k->b * f_b) * dp;
  at->u_m += rate * dp;
  if (u_m < 0 && at->u_m > 0)
    at->least = fmin(at->least, at->work - 0.5 * u_m * u_m / rate);
  at->work += 0.5 * (u_m + at->u_m) * dp;
  at->least = fmin(at->least, at->work);
  return ended;
}

/* Sliding until it stops; true at the end of restitution. */
static bool slide(lever_path *at) {
  const inverse_mass *k = &at->k;
  double mu = at->friction, first = hypot(at->u_a, at->u_b);
  double most = hypot(k->am, k->bm) + mu * fabs(k->a - k->b); /* of the turn */
  for (int i = 0;; i++) {
    double speed = hypot(at->u_a, at->u_b);
    if (!(speed > STOPPED * first))
      return false;
    double s_a = at->u_a / speed, s_b = at->u_b / speed;
    double g_a = k->am - mu * k->a * s_a, g_b = k->bm - mu * k->b * s_b;
    double along = s_a * g_a + s_b * g_b, turn = fabs(s_a * g_b - s_b * g_a);
    if (turn <= STRAIGHT * (fabs(along) + most) || i == STRETCHES) {
      bool ended = stretch(at, s_a, s_b, along < 0 ? speed / -along : INFINITY);
      at->u_a = ended ? at->u_a : 0;
      at->u_b = ended ? at->u_b : 0;
      return ended;
    }
    double dp = speed * fmin(TURN_MOST / fmax(turn, 0.5 * most), LOSS / fabs(along));
    for (int j = 0; j < 3; j++) {
      double m_a = at->u_a + 0.5 * dp * (k->am - mu * k->a * s_a);
      double m_b = at->u_b + 0.5 * dp * (k->bm - mu * k->b * s_b), length = hypot(m_a, m_b);
      s_a = m_a / length;
      s_b = m_b / length;
    }
    if (stretch(at, s_a, s_b, dp))
      return true;
  }
}

/* The rest of the impulse at a point that has stopped: it sticks, or slides off in the one
 * direction that stays constant, (mu K_t + lambda) s = K_tm. */
static void stick(lever_path *at) {
  const inverse_mass *k = &at->k;
  double mu = at->friction, lambda = 0, most = hypot(k->am, k->bm);
  if (hypot(k->am / k->a, k->bm / k->b) > mu) {
    double low = 0;
    for (int i = 0; i < HALVINGS; i++) {
      lambda = 0.5 * (low + most);
      if (hypot(k->am / (lambda + mu * k->a), k->bm / (lambda + mu * k->b)) > 1)
        low = lambda;
      else
        most = lambda;
    }
  }
  stretch(at, k->am / (lambda + mu * k->a), k->bm / (lambda + mu * k->b), INFINITY);
}

/* Directions along the face in which K has no coupling between them. */
static void principal(const asp_body *body, vec arm, vec m, vec *a, vec *b) {
  vec first = across(m), second = cross(m, first);
  vec k1 = aspi_body_kick(body, arm, first), k2 = aspi_body_kick(body, arm, second);
  double angle = 0.5 * atan2(2 * dot(second, k1), dot(first, k1) - dot(second, k2));
  *a = plus(scaled(first, cos(angle)), sin(angle), second);
  *b = cross(m, *a);
}

vec aspi_body_impulse(const asp_body *body, vec arm, vec m, vec u, double e, double friction) {
  vec a, b;
  principal(body, arm, m, &a, &b);
  vec k = aspi_body_kick(body, arm, m);
  lever_path at = {.k = {.a = dot(a, aspi_body_kick(body, arm, a)),
                         .b = dot(b, aspi_body_kick(body, arm, b)),
                         .m = dot(m, k),
                         .am = dot(a, k),
                         .bm = dot(b, k)},
                   .friction = friction,
                   .e2 = e * e,
                   .u_a = dot(u, a),
                   .u_b = dot(u, b),
                   .u_m = dot(u, m)};
  if (!(friction > 0))
    stretch(&at, 0, 0, INFINITY);
  else if (!slide(&at))
    stick(&at);
  return plus(plus(scaled(m, at.p), at.j_a, a), at.j_b, b);
}
