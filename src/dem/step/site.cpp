/* A contact of a mover, and an impact there; its faces are in faces.cpp.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include "asperity_engine.h"
#include "contact/vector.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

Site::Site(Flight &of, Touch &at, const double v[3])
    : flight(of), mover(of.mover), touch(at), wall(*at.wall), contact(at.contact),
      one(mover.sphere[at.sphere]), memory(mover.at(wall)), press(0), face(NULL), is_new(true),
      moved(false) {
  mover.arm(at.sphere, arm);
  aspi_subtract(v, contact.v_wall, v1);
}

const asp_wall *Site::law() const {
  const asp_wall *of = wall.setup.model.wall();
  if (!of)
    throw Error(text("particle %lld came to be after the run began, and the wall's tables need the "
                     "diameters beforehand; make particles before 'run', or by a fix insert",
                     static_cast<long long>(one.tag)));
  return of;
}

void Site::sphere_velocity(double u[3]) const {
  double across[3];
  aspi_copy(v1, u);
  if (mover.is_ball)
    return;
  aspi_cross(flight.spin, arm, across);
  aspi_add_scaled(u, 1, across, u);
}

double Site::approach() const {
  double u[3];
  sphere_velocity(u);
  return -aspi_dot(u, contact.n);
}

/* The sphere as it is here. lay: room for the wall's lay. */
asp_particle Site::particle(double lay[3]) {
  const Setup &setup = wall.setup;
  const Member &member = setup.shapes[touch.shape];
  asp_particle particle = {};
  particle.d_p = 2 * one.radius;
  particle.density = mover.mass / (ASP_PI / 6 * particle.d_p * particle.d_p * particle.d_p);
  particle.pair = setup.model.pair(one.type, member.wall_type);
  aspi_copy(flight.spin, particle.omega);
  if (!mover.is_ball) {
    core_ = mover.core_body(arm);
    particle.body = &core_;
  }
  lay[0] = lay[1] = 0;
  lay[2] = 1;
  if (setup.engine.dimension() == 2) /* at normal impact, too, the tilt is in the plane */
    particle.lay = lay;
  else if (setup.model.lay().kind != ASP_LAY_NONE) {
    member.shape->lay(setup.model.lay(), touch.before, contact, lay);
    particle.lay = lay;
  }
  return particle;
}

/* An impact here that is to be counted, without its result. */
Event Site::event(double hits) const {
  Event event = Event();
  event.wall = &wall;
  event.shape = touch.shape;
  event.contact = contact;
  aspi_copy(v1, event.v1);
  aspi_copy(flight.spin, event.omega1);
  event.elapsed = flight.elapsed();
  event.time = wall.setup.time(static_cast<double>(flight.step)) - flight.path.left;
  event.key.seed = wall.setup.model.seed();
  event.key.wall = wall.setup.key;
  event.key.tag = static_cast<uint64_t>(one.tag);
  event.key.impact = static_cast<uint32_t>(memory.impacts() + hits);
  event.mass = mover.mass;
  event.d_p = 2 * one.radius;
  event.step = flight.step;
  event.body = mover.body ? mover.body->tag + 1 : 0;
  aspi_copy(arm, event.lever);
  return event;
}

/* The load of an impact with its result. */
void Site::finish(Event &event) const {
  const asp_impact &result = event.result;
  double change[3], turned[3];
  aspi_subtract(result.v2, event.v1, change);
  aspi_subtract(result.omega, event.omega1, turned);
  event.load =
      mover.load(touch.sphere, contact.piece, contact.x, contact.n, flight.path.x, change, turned);
  event.load.dissipated =
      mover.mass * (mover.energy(event.v1, event.omega1) - mover.energy(result.v2, result.omega));
  event.load.eroded = mover.mass * result.eroded;
}
