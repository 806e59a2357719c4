/* Checks for commands that a script must not have; see engine_checks.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "engine_checks.h"

#include "atom.h"
#include "domain.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

#include "dem/text.h"

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
    return "the package KOKKOS is on; it keeps particles where this fix cannot reach them, so it "
           "must be off";
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

/* True if a particle of any rank is in both groups. */
static bool share_particles(const Fix *wall, const Fix *fix, LAMMPS *lmp) {
  const Atom *atom = lmp->atom;
  int mine = 0, any;
  for (int i = 0; i < atom->nlocal; i++)
    mine |= (atom->mask[i] & fix->groupbit) && (atom->mask[i] & wall->groupbit);
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, lmp->world);
  return any;
}

/* Fixes that put particles where they want would carry them through the wall. They may get
 * particles during a run, so each neighbor build looks; all ranks call. */
std::string LAMMPS_NS::movers_error(const Fix *wall, int box_changes, LAMMPS *lmp) {
  Modify *modify = lmp->modify;
  if (modify->check_rigid_group_overlap(wall->groupbit))
    return "particles that are tied to bodies (fix rigid) cannot rebound one by one";
  for (int i = 0; i < modify->nfix; i++) {
    const Fix *fix = modify->fix[i];
    const std::string name = text("fix %s (id %s)", fix->style, fix->id);
    if (strcmp(fix->style, "move") == 0 && share_particles(wall, fix, lmp))
      return name + " moves particles of this wall's group, which cannot rebound; the groups must "
                    "have no particle in common";
    const bool is_deform = strncmp(fix->style, "deform", 6) == 0;
    if ((fix->box_change & box_changes) && !(is_deform && lmp->domain->deform_vremap))
      return name + " changes the box and moves particles with it, past the wall; " +
             (is_deform ? "it must be 'remap v', which leaves them where they are"
                        : "the box must keep its size");
  }
  return "";
}

/* True if a fix has changed the size of particles since the contacts of the step before. */
bool LAMMPS_NS::particles_grow(LAMMPS *lmp) {
  const Modify *modify = lmp->modify;
  for (int i = 0; i < modify->nfix; i++) {
    const Fix *fix = modify->fix[i];
    if (strncmp(fix->style, "adapt", 5) == 0 && fix->nevery > 0 &&
        (lmp->update->ntimestep - 1) % fix->nevery == 0)
      return true;
  }
  return false;
}
