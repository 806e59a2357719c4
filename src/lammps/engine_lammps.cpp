/* LAMMPS as the wall asks it; see engine_lammps.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "engine_lammps.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

std::string EngineOfLammps::known_units() const {
  return "si, cgs, micro or nano";
}

double EngineOfLammps::time() const {
  const Update *update = program_->update;
  return update->atime + static_cast<double>(update->ntimestep - update->atimestep) * update->dt;
}

void EngineOfLammps::warn(const std::string &what) const {
  if (program_->comm->me == 0)
    program_->error->warning(FLERR, "Fix wall/rebound (id " + id() + "): " + what);
}

void EngineOfLammps::print(const std::string &what) const {
  if (program_->comm->me == 0)
    utils::logmesg(program_, what + "\n");
}

/* The largest radius of a type that fixes pour or deposit will make, as pair styles ask for it; 0:
 * none. */
double EngineOfLammps::radius_to_come(int type) const {
  double most = 0;
  for (int i = 0; i < program_->modify->nfix; i++) {
    Fix *fix = program_->modify->fix[i];
    if (strncmp(fix->style, "pour", 4) != 0 && strncmp(fix->style, "deposit", 7) != 0)
      continue;
    int asked = type;
    const double *radius = static_cast<const double *>(fix->extract("radius", asked));
    if (radius)
      most = std::max(most, *radius);
  }
  return most;
}

/* For particles still to come, LAMMPS gives only the largest diameter of each type. */
void EngineOfLammps::diameters(double &least, double &most) const {
  double mine[2] = {-HUGE_VAL, 0}, all[2];
  const Atom *atom = program_->atom;
  for (int i = 0; i < atom->nlocal; i++) {
    mine[0] = std::max(mine[0], -2 * atom->radius[i]);
    mine[1] = std::max(mine[1], 2 * atom->radius[i]);
  }
  for (int type = 1; type <= atom->ntypes; type++) {
    const double radius = radius_to_come(type);
    if (radius > 0) {
      mine[0] = std::max(mine[0], -2 * radius);
      mine[1] = std::max(mine[1], 2 * radius);
    }
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_MAX, program_->world);
  least = all[1] > 0 ? -all[0] : 0;
  most = all[1];
}

std::vector<asperity::Engine::Kind> EngineOfLammps::kinds() const {
  std::vector<double> present;
  for (int type = 1; type <= types(); type++)
    present.push_back(radius_to_come(type));
  return asperity::kinds_of(EngineOf::spheres(), fix_->groupbit, present, program_->world);
}
