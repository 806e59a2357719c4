/* The faces of a rough wall that a sphere meets one after another, and the valleys between them.
 *
 * A sphere that has met a face meets the next one after its contact point has moved by the length
 * of a face along the wall (asp_wall_face_length), whether it flies there, hops, slides or rolls;
 * until then it meets the mean wall. Where it rests at the wall and comes to a face, it hits that
 * at grazing incidence.
 *
 * Where it rests and its energy along the wall is less than the next crest costs, it lies in a
 * valley (asp_wall_valley), an arc of a sine with the steepest slope q and the height h. With what
 * presses it, P = f - a.n (per mass; f, a as in meet.cpp), and what pushes it along, a_t, the crest
 * ahead costs
 *
 *   E_t < P h (sqrt(1 - s^2) - s acos s),     s = |a_t|/(q P)
 *
 * and nothing where s >= 1; E_t is the energy of the mover along the wall, per mass. A mover that
 * has fallen to the wall is anywhere in its first valley, and has the energy of that place, too. On
 * the next ones E_t is what it has over the mean wall. The valley acts on the center of the sphere
 * as friction of the coefficient q (held.h); one that bounces in it loses its motion along the
 * wall. A bounce on the mean wall that is lower than h is none: the sphere rests. A law that takes
 * no energy has no valleys.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>
#include <algorithm>

#include "asperity_engine.h"
#include "contact/vector.h"

using namespace asperity;

/* How high an arc of a sine is over its bottom, over P h: at the crest ahead, and at a share of the
 * way from there to the crest behind. */
static double crest(double steep) {
  return sqrt(1 - steep * steep) - steep * acos(steep);
}
static double rise_at(double share, double steep) {
  const double bottom = asin(steep), at = ASP_PI - bottom - 2 * ASP_PI * share;
  return 0.5 * (sqrt(1 - steep * steep) - cos(at) - steep * (at - bottom));
}

/* True if a mover with this energy along the wall, per mass, cannot leave the valley behind its
 * face, where `push` presses it to the wall and `a` acts on it. The other walls at which it rests
 * take what pushes it into them. */
static bool lies_in_valley(const std::vector<FacePlace> &faces, const FacePlace &face,
                           double energy, double push, const double a[3]) {
  double along[3], m[3];
  aspi_copy(a, along);
  aspi_add_scaled(along, -aspi_dot(a, face.normal), face.normal, along);
  for (const FacePlace &other : faces) {
    if (!(other.start > 0) || other.time < face.time ||
        !(aspi_dot(other.normal, face.normal) <= SAME_WALL))
      continue;
    aspi_copy(other.normal, m);
    aspi_add_scaled(m, -aspi_dot(m, face.normal), face.normal, m);
    const double into = -aspi_dot(along, m), square = aspi_dot(m, m);
    if (into > 0 && square > 0)
      aspi_add_scaled(along, into / square, m, along);
  }
  const double steep = aspi_length(along) / (face.start * push);
  if (!(push > 0 && steep < 1))
    return false;
  if (face.place > AT_BOTTOM)
    energy += push * (face.height * rise_at(face.place, steep) + face.rise);
  const double most = push * face.height; /* the crest is convex: its tangent at 0 is lower */
  return energy < most * (1 - 0.5 * ASP_PI * steep) || energy < most * crest(steep);
}

/* stays: the sphere was at the wall in the step before, and may have passed the beginning of the
 * face since. */
void ContactPoint::find_face(bool stays) {
  if (!wall.is_rough)
    return;
  const asp_wall *of = wall.setup.model.wall();
  const double time = wall.setup.time(static_cast<double>(now.step)) - now.left;
  double lay[3], point[3], along[3], u[3], passed = 0;
  bool fell = false;
  aspi_copy(touch.x, point);
  aspi_add_scaled(point, -one.radius, touch.n, point);
  face = memory.face_of(one.tag, touch.n);
  if (face) {
    aspi_add_scaled(face->at, time - face->time, touch.v_wall, face->at);
    wall.setup.box.bring_near(point, face->at);
    aspi_subtract(point, face->at, along);
    aspi_add_scaled(along, -aspi_dot(along, touch.n), touch.n, along);
    double length = face->length;
    if (wall.has_lay) {
      const asp_particle here = particle(lay);
      length = asp_wall_face_length(of, &here, along, touch.n);
    }
    const double way = aspi_length(along);
    is_new = moved = way >= length;
    if (stays && moved) {
      sphere_velocity(u);
      passed = std::min(way - length, aspi_length(u) * now.dt) / way;
    }
  } else {
    const asp_particle here = particle(lay);
    const double length = asp_wall_face_length(of, &here, NONE, touch.n);
    if (!(length > 0))
      return;
    face = &memory.new_face();
    face->length = length;
    fell = !stays;
  }
  if (is_new) {
    face->sphere = static_cast<double>(one.tag);
    aspi_copy(point, face->at);
    if (passed > 0)
      aspi_add_scaled(face->at, -passed, along, face->at);
    face->start = face->height = face->rise = 0;
    face->place = fell ? TO_DRAW : AT_BOTTOM;
  }
  aspi_copy(touch.n, face->normal);
  face->time = time;
}

/* The key of the next draw of a sphere that rests at the wall, or bounces on it. */
asp_key ContactPoint::next_key() const {
  return asp_key{wall.setup.model.seed(), wall.setup.stay_key, static_cast<uint64_t>(one.tag),
                 static_cast<uint32_t>(++memory.own().draws), 0};
}

/* The valley behind the face of a contact, on its first use. */
const FacePlace &ContactPoint::valley() {
  if (face->start > 0)
    return *face;
  double lay[3], u[3];
  const asp_particle here = particle(lay);
  const asp_key key = next_key();
  sphere_velocity(u);
  const asp_valley drawn = asp_wall_valley(law(), &here, u, touch.n, &key);
  face->start = drawn.start;
  face->height = drawn.height;
  if (face->place > AT_BOTTOM) {
    face->place = drawn.place;
    face->rise = drawn.rise;
  }
  return *face;
}

/* True if a bounce on the mean wall is lower than the wall's own heights, by what the forces press:
 * a wall that accelerates may have turned back before the next bounce. */
bool ContactPoint::is_low() {
  const double push = -aspi_dot(now.free, touch.n);
  if (!face || is_new || !wall.setup.model.dissipates() || !(push > 0))
    return false;
  const double v_n = approach();
  return 0.5 * v_n * v_n < push * valley().height;
}

/* The energy of a bounce that is too low to be one. */
void ContactPoint::lose_bounce() const {
  const double none[3] = {0, 0, 0}, v_n = approach();
  ContactLoad load = mover.load(touch.sphere, touch.piece, touch.x, touch.n, now.x, none, NULL);
  load.dissipated = 0.5 * mover.mass * v_n * v_n / mover.response(arm, touch.n);
  wall.books.add_load(touch.shape, load);
}

/* The slope that the valley withstands in which the sphere lies; 0: it lies in none. */
double ContactPoint::hold(bool is_sustained) {
  if (!face || !wall.has_valleys)
    return 0;
  const FacePlace &at = valley();
  const double along = mover.energy_along(touch.n, v1, spin);
  const double push = is_sustained ? press : -aspi_dot(now.free, touch.n);
  return lies_in_valley(memory.own().faces, at, along, push, now.free) ? at.start : 0;
}

/* Changes v1 and the spin before an impact; the wall takes what is lost. */
void ContactPoint::brake(const double to[3], const double to_spin[3]) {
  double p[3], turned[3];
  aspi_subtract(to, v1, p);
  aspi_subtract(to_spin, spin, turned);
  ContactLoad load = mover.load(touch.sphere, touch.piece, touch.x, touch.n, now.x, p, turned);
  load.dissipated = mover.mass * (mover.energy(v1, spin) - mover.energy(to, to_spin));
  wall.books.add_load(touch.shape, load);
  aspi_copy(to, v1);
  aspi_copy(to_spin, spin);
}

/* The motion along the wall of a sphere about the center of mass that bounces in its valley is
 * lost. */
void ContactPoint::stop_along() {
  const double *n = touch.n;
  double straight[3], turning[3];
  if (!mover.is_central(touch.sphere))
    return;
  aspi_copy(n, straight);
  aspi_scale(aspi_dot(v1, n), straight);
  aspi_copy(n, turning);
  aspi_scale(aspi_dot(spin, n), turning);
  brake(straight, turning);
}

/* The impact on the next face of a sphere that rests: it comes along the wall, after the mean wall
 * has taken its approach. False where it meets none. */
bool ContactPoint::graze(Impact &made) {
  const double stops = approach() / mover.response(arm, touch.n);
  double along[3], turned[3], turning[3], lay[3];
  aspi_add_scaled(v1, stops, touch.n, along);
  aspi_copy(touch.n, turned);
  aspi_scale(stops, turned);
  mover.twist(arm, turned, turned);
  aspi_add_scaled(spin, 1, turned, turning);
  asp_particle here = particle(lay);
  aspi_copy(turning, here.omega);
  const asp_key key = next_key();
  asp_impact result;
  asp_wall_impact_grazing(law(), &here, along, touch.n, press, &key, &result);
  if (result.hits == 0)
    return false;
  brake(along, turning);
  made = impact();
  made.result = result;
  made.grazes = true;
  finish(made);
  return true;
}
