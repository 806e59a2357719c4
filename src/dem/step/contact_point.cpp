/* A contact of a mover, and an impact there; its faces are in faces.cpp.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include "asperity_engine.h"
#include "contact/vector.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

ContactPoint::ContactPoint(const Mover &of, const Moment &then, Touch &at)
    : mover(of), now(then), touch(at), wall(*at.wall), one(mover.sphere[at.sphere]),
      memory(mover.at(wall)), press(0), face(NULL), is_new(true), moved(false) {
  mover.arm(at.sphere, arm);
  aspi_subtract(now.v, touch.v_wall, v1);
  aspi_copy(now.spin, spin);
}

const asp_wall *ContactPoint::law() const {
  const asp_wall *of = wall.setup.model.wall();
  if (!of)
    throw Error(text("particle %lld came to be after the run began, and the wall's tables need the "
                     "diameters beforehand; make particles before 'run', or by a fix insert",
                     static_cast<long long>(one.tag)));
  return of;
}

void ContactPoint::sphere_velocity(double u[3]) const {
  double across[3];
  aspi_copy(v1, u);
  if (mover.is_ball)
    return;
  aspi_cross(spin, arm, across);
  aspi_add_scaled(u, 1, across, u);
}

double ContactPoint::approach() const {
  double u[3];
  sphere_velocity(u);
  return -aspi_dot(u, touch.n);
}

asp_particle ContactPoint::particle(double lay[3]) {
  const Setup &setup = wall.setup;
  const Member &member = setup.shapes[touch.shape];
  asp_particle particle = {};
  particle.d_p = 2 * one.radius;
  particle.density = mover.mass / ASP_SPHERE_VOLUME(particle.d_p);
  particle.pair = setup.model.pair(one.type, member.wall_type);
  if (setup.temperatures) {
    asp_error wrong = {ASP_OK, "it must be more than 0", {}};
    const double own = particle.temperature = setup.temperature(mover.i);
    if (!(own > 0) || asp_wall_sticking(law(), own, NULL, &wrong))
      throw Error(text("the temperature of particle %lld, by '%s', is %g K: %s",
                       static_cast<long long>(one.tag), setup.temperature_of.c_str(), own,
                       wrong.text));
  }
  aspi_copy(spin, particle.omega);
  if (!mover.is_ball) {
    core_ = mover.core_body(arm);
    particle.body = &core_;
  }
  lay[0] = lay[1] = 0;
  lay[2] = 1;
  if (!wall.has_lay)
    return particle;
  particle.lay = lay;
  if (setup.engine.dimension() == 3)
    member.shape->lay(setup.model.lay(), touch.before, touch, lay);
  return particle;
}

Impact ContactPoint::impact(double nth) const {
  Impact made = Impact();
  made.wall = &wall;
  made.shape = touch.shape;
  made.contact = touch;
  aspi_copy(v1, made.v1);
  aspi_copy(spin, made.omega1);
  made.elapsed = now.dt - now.left;
  made.time = wall.setup.time(static_cast<double>(now.step)) - now.left;
  made.key.seed = wall.setup.model.seed();
  made.key.wall = wall.setup.key;
  made.key.tag = static_cast<uint64_t>(one.tag);
  made.key.impact = static_cast<uint32_t>(memory.impacts() + nth);
  made.mass = mover.mass;
  made.d_p = 2 * one.radius;
  made.temperature = wall.setup.temperature(mover.i);
  made.step = now.step;
  made.body = mover.body ? mover.body->tag + 1 : 0;
  aspi_copy(arm, made.lever);
  return made;
}

void ContactPoint::finish(Impact &impact) const {
  const asp_impact &result = impact.result;
  double change[3], turned[3];
  aspi_subtract(result.v2, impact.v1, change);
  aspi_subtract(result.omega, impact.omega1, turned);
  impact.load = mover.load(touch.sphere, touch.piece, touch.x, touch.n, now.x, change, turned);
  impact.load.dissipated =
      mover.mass * (mover.energy(impact.v1, impact.omega1) - mover.energy(result.v2, result.omega));
  impact.load.eroded = mover.mass * result.eroded;
  ++memory.impacts();
}
