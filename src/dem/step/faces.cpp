/* The faces of a rough wall that a particle meets one after another, and the valleys between them.
 *
 * A particle that has met a face meets the next one after its contact point has moved by the length
 * of a face along the wall (asp_wall_face_length), whether it flies there, hops, slides or rolls;
 * until then it meets the mean wall. Where it stays at the wall and comes to a face, it hits that
 * at grazing incidence.
 *
 * Where it stays and its energy along the wall is less than the next crest costs, it lies in a
 * valley (asp_wall_valley), an arc of a sine with the steepest slope q and the height h. With what
 * presses it, P = f - a.n (per mass; f, a as in step.cpp), and what pushes it along, a_t, the crest
 * ahead costs
 *
 *   v_t^2/2 + r^2 omega_t^2/5 < P h (sqrt(1 - s^2) - s acos s),     s = |a_t|/(q P)
 *
 * and nothing where s >= 1. The valley acts on the center as friction of the coefficient q
 * (sustained.h); a particle that bounces in it loses its motion along the wall. A bounce on the
 * mean wall that is lower than h is none: the particle stays. A law that takes no energy has no
 * valleys.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>

#include "asperity_front.h"
#include "contact/vector.h"

using namespace asperity;

namespace {

/* Energy of a sphere, per mass; and that of its motion along the wall. */
double energy(const double v[3], const double spin[3], double radius) {
  return 0.5 * aspi_dot(v, v) + 0.2 * radius * radius * aspi_dot(spin, spin);
}

double energy_along(const double n[3], const double v[3], const double spin[3], double radius) {
  const double v_n = aspi_dot(v, n), w_n = radius * aspi_dot(spin, n);
  return energy(v, spin, radius) - 0.5 * v_n * v_n - 0.2 * w_n * w_n;
}

FacePlace *face_of(FaceMemory &memory, const double n[3]) {
  for (FacePlace &face : memory.face)
    if (aspi_dot(face.normal, n) > SAME_WALL)
      return &face;
  return NULL;
}

/* True if a particle with this energy along the wall lies in the valley behind its face. */
bool lies(const FaceMemory &memory, const FacePlace &face, double energy, double push,
          const double a[3]) {
  const FacePlace *others[FaceMemory::FACES];
  size_t n = 0;
  for (const FacePlace &other : memory.face)
    if (&other != &face)
      others[n++] = &other;
  return lies_in_valley(face, others, n, energy, push, a);
}

/* The place of another wall's face: the one that was met longer ago, or none yet. */
FacePlace *oldest(FaceMemory &memory) {
  FacePlace *first = memory.face;
  for (FacePlace &face : memory.face)
    if (!(aspi_dot(face.normal, face.normal) > 0) ||
        (aspi_dot(first->normal, first->normal) > 0 && face.time < first->time))
      first = &face;
  return first;
}

} // namespace

bool asperity::lies_in_valley(const FacePlace &face, const FacePlace *const others[], size_t count,
                              double energy, double push, const double a[3]) {
  double along[3], m[3];
  aspi_copy(a, along);
  aspi_add_scaled(along, -aspi_dot(a, face.normal), face.normal, along);
  for (size_t k = 0; k < count; k++) {
    const FacePlace &other = *others[k];
    if (!(other.start > 0) || other.time < face.time)
      continue;
    aspi_copy(other.normal, m);
    aspi_add_scaled(m, -aspi_dot(m, face.normal), face.normal, m);
    const double into = -aspi_dot(along, m), square = aspi_dot(m, m);
    if (into > 0 && square > 0)
      aspi_add_scaled(along, into / square, m, along);
  }
  const double steep = aspi_length(along) / (face.start * push);
  return push > 0 && steep < 1 &&
         energy < push * face.height * (sqrt(1 - steep * steep) - steep * acos(steep));
}

void Site::find_face() {
  const asp_wall *law = wall.setup.model.wall();
  if (!law || !asp_wall_surface(law))
    return;
  const double forward[3] = {0, 0, 0};
  double lay[3], point[3], way[3];
  const asp_particle here = particle(lay);
  double length = asp_wall_face_length(law, &here, forward, contact.n);
  if (!(length > 0))
    return;
  FaceMemory &memory = wall.rows.place[flight.i].faces;
  const double now = wall.setup.time(static_cast<double>(flight.spheres.step)) - flight.path.left;
  aspi_copy(contact.x, point);
  aspi_add_scaled(point, -flight.radius, contact.n, point);
  face = face_of(memory, contact.n);
  if (face) {
    aspi_add_scaled(face->at, now - face->time, contact.v_wall, face->at);
    wall.setup.box.bring_near(point, face->at);
    aspi_subtract(point, face->at, way);
    aspi_add_scaled(way, -aspi_dot(way, contact.n), contact.n, way);
    if (here.lay)
      length = asp_wall_face_length(law, &here, way, contact.n);
    is_new = moved = aspi_dot(way, way) >= length * length;
  } else
    face = oldest(memory);
  if (is_new) {
    aspi_copy(point, face->at);
    face->start = face->height = 0;
  }
  aspi_copy(contact.n, face->normal);
  face->time = now;
}

/* The key of the next draw of a particle that stays at the wall, or bounces on it. */
asp_key Site::next_key() const {
  return asp_key{wall.setup.model.seed(), wall.setup.stay_key,
                 static_cast<uint64_t>(flight.spheres.tag_of(flight.i)),
                 static_cast<uint32_t>(++wall.rows.place[flight.i].faces.draws)};
}

/* The valley behind the face of a contact, on its first use. */
const FacePlace &Site::valley() const {
  if (face->start > 0)
    return *face;
  double lay[3];
  const asp_particle here = particle(lay);
  const asp_key key = next_key();
  const asp_valley drawn = asp_wall_valley(wall.setup.model.wall(), &here, v1, contact.n, &key);
  face->start = drawn.start;
  face->height = drawn.height;
  return *face;
}

/* True if a bounce on the mean wall is lower than the wall's own heights, by what the forces press:
 * a wall that accelerates may have turned back before the next bounce. */
bool Site::is_low() const {
  const double push = -aspi_dot(flight.a0, contact.n);
  if (!face || is_new || !wall.setup.model.dissipates() || !(push > 0))
    return false;
  const double v_n = aspi_dot(v1, contact.n);
  return 0.5 * v_n * v_n < push * valley().height;
}

/* The energy of a bounce that is too low to be one. */
void Site::lose_bounce() const {
  const double none[3] = {0, 0, 0}, v_n = aspi_dot(v1, contact.n);
  ContactLoad load(flight.spheres, flight.i, contact.piece, contact.x, contact.n, none, v1);
  load.dissipated = 0.5 * flight.mass * v_n * v_n;
  wall.books.add_load(shape, load);
}

/* The slope that the valley withstands in which the particle lies; 0: it lies in none. */
double Site::hold(bool is_sustained) const {
  if (!face || !wall.setup.interlocks || !wall.setup.model.dissipates())
    return 0;
  const FacePlace &at = valley();
  const double along = energy_along(contact.n, v1, flight.spin, flight.radius);
  const double push = is_sustained ? press : -aspi_dot(flight.a0, contact.n);
  return lies(wall.rows.place[flight.i].faces, at, along, push, flight.a0) ? at.start : 0;
}

double asperity::hold_at_end(const Stepper &wall, const Spheres &s, int i, const Support &support,
                             const double spin[3]) {
  FaceMemory &memory = wall.rows.place[i].faces;
  const FacePlace *face = face_of(memory, support.n);
  if (!face || !(face->start > 0) || !wall.setup.interlocks)
    return 0;
  double u[3], a[3];
  aspi_subtract(s.v + 3 * static_cast<size_t>(i), support.w, u);
  aspi_copy(s.f + 3 * static_cast<size_t>(i), a);
  aspi_scale(1 / s.mass[i], a);
  const double along = energy_along(support.n, u, spin, s.radius[i]);
  return lies(memory, *face, along, -aspi_dot(a, support.n), a) ? face->start : 0;
}

/* Changes v1 and the spin before an impact; the wall takes what is lost. */
void Site::brake(const double to[3], const double spin[3]) {
  double p[3], turn[3];
  aspi_subtract(to, v1, p);
  aspi_subtract(spin, flight.spin, turn);
  ContactLoad load(flight.spheres, flight.i, contact.piece, contact.x, contact.n, p, v1);
  load.set_couple(flight.spheres, flight.i, contact.x, turn);
  load.dissipated =
      flight.mass * (energy(v1, flight.spin, flight.radius) - energy(to, spin, flight.radius));
  wall.books.add_load(shape, load);
  aspi_copy(to, v1);
  aspi_copy(spin, flight.spin);
}

/* The motion along the wall of a particle that bounces in its valley is lost. */
void Site::stop_along() {
  const double *n = contact.n;
  double straight[3], spin[3];
  aspi_copy(n, straight);
  aspi_scale(aspi_dot(v1, n), straight);
  aspi_copy(n, spin);
  aspi_scale(aspi_dot(flight.spin, n), spin);
  brake(straight, spin);
}

/* The impact on the next face of a particle that stays: it comes along the wall. False where it
 * meets none. */
bool Site::graze() {
  double along[3], lay[3];
  aspi_add_scaled(v1, -aspi_dot(v1, contact.n), contact.n, along);
  const asp_particle here = particle(lay);
  const asp_key key = next_key();
  asp_impact impact;
  if (!asp_wall_impact_grazing(wall.setup.model.wall(), &here, along, contact.n, press, &key,
                               &impact))
    return false;
  const double spin[3] = {flight.spin[0], flight.spin[1], flight.spin[2]};
  brake(along, spin);
  flight.events.push_back(event());
  flight.events.back().result = impact;
  flight.events.back().grazes = true;
  return true;
}
