/* Checks for commands that a script must not have; see engine_lammps.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "engine_lammps.h"

#include "atom.h"
#include "domain.h"
#include "fix.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

#include "dem/text.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using asperity::text;

std::string LAMMPS_NS::particles_error(LAMMPS *lmp) {
  const Atom *atom = lmp->atom;
  if (!atom->radius_flag || !atom->rmass_flag || atom->ellipsoid_flag || atom->line_flag ||
      atom->tri_flag || atom->body_flag)
    return text("the atom style is '%s'; particles must be spheres with a radius and a density, by "
                "'atom_style sphere'",
                atom->atom_style);
  if (!atom->tag_enable)
    return "particles have no tags, which the draws depend on; use 'atom_modify id yes'";
  if (lmp->kokkos)
    return "the package KOKKOS is on, with which this fix was never tried; it must be off";
  return "";
}

std::string LAMMPS_NS::units_error(const EngineOfLammps &engine) {
  const std::string units = engine.units(), known = engine.known_units();
  if (units != "si" && units != "cgs" && units != "micro" && units != "nano" && units != "lj")
    return "units are '" + units + "'; they must be " + known + ", or lj without materials";
  return "";
}

std::string LAMMPS_NS::box_error(LAMMPS *lmp) {
  const Domain *domain = lmp->domain;
  if (domain->triclinic && (domain->xperiodic || domain->yperiodic || domain->zperiodic))
    return "the box is triclinic and periodic; a periodic box must be orthogonal";
  return "";
}

/* One particle of mass, radius and torque 1, in the place of all others. */
struct OneParticle {
  double rows[4][3], *v, *f, *omega, *torque, **vs, **fs, **omegas, **torques, radius, mass;
  double *radii, *masses;
  int mask, *masks, n, first;
  explicit OneParticle(int groupbit)
      : rows(), v(rows[0]), f(rows[1]), omega(rows[2]), torque(rows[3]), vs(&v), fs(&f),
        omegas(&omega), torques(&torque), radius(1), mass(1), radii(&radius), masses(&mass),
        mask(groupbit), masks(&mask), n(1), first(1) {
    torque[2] = 1;
  }
  void swap(Atom *atom) {
    std::swap(vs, atom->v);
    std::swap(fs, atom->f);
    std::swap(omegas, atom->omega);
    std::swap(torques, atom->torque);
    std::swap(radii, atom->radius);
    std::swap(masses, atom->rmass);
    std::swap(masks, atom->mask);
    std::swap(n, atom->nlocal);
    std::swap(first, atom->nfirst);
  }
};

/* No fix tells with which moment of inertia it turns particles, so the integrator gets one for half
 * a step. 2/5 m r^2 is that of a sphere, 1/2 that of a disc. */
std::string LAMMPS_NS::discs_error(LAMMPS *lmp) {
  for (int i = 0; i < lmp->modify->nfix && lmp->domain->dimension == 2; i++) {
    Fix *fix = lmp->modify->fix[i];
    if (strncmp(fix->style, "nve/sphere", 10) != 0)
      continue;
    OneParticle particle(fix->groupbit);
    particle.swap(lmp->atom);
    fix->final_integrate();
    particle.swap(lmp->atom);
    if (0.5 * lmp->update->dt * lmp->force->ftm2v > 0.45 * particle.omega[2])
      return text("fix %s (id %s) turns particles as discs, and this wall has spheres only: a disc "
                  "that slides would end with another speed; leave out 'disc'",
                  fix->style, fix->id);
  }
  return "";
}
