/* LAMMPS as the wall asks it; see engine_lammps.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "engine_lammps.h"

#include "library.h"
#include "lammps.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;

std::string EngineOfLammps::known_units() const {
  return "si, cgs, micro or nano";
}

/* A dynamic group may get any particle. */
int EngineOfLammps::group() const {
  return program_->group->dynamic[fix_->igroup] ? ~0 : fix_->groupbit;
}

/* The largest radius of a type that fixes pour or deposit will make for the wall's group, as pair
 * styles ask for it; 0: none. They put particles into `all` and into their own group. */
double EngineOfLammps::radius_to_come(int type) const {
  double most = 0;
  for (int i = 0; i < program_->modify->nfix; i++) {
    Fix *fix = program_->modify->fix[i];
    if ((strncmp(fix->style, "pour", 4) != 0 && strncmp(fix->style, "deposit", 7) != 0) ||
        !((1 | fix->groupbit) & group()))
      continue;
    int asked = type;
    const double *radius = static_cast<const double *>(fix->extract("radius", asked));
    if (radius)
      most = std::max(most, *radius);
  }
  return most;
}

/* A number of the atom style, one of fix property/atom (d_NAME), or of a fix (f_ID). */
const double *EngineOfLammps::numbers(const std::string &name) const {
  auto *modify = program_->modify;
  const int at = name.compare(0, 2, "f_") == 0 ? modify->find_fix(name.substr(2)) : -1;
  if (at >= 0 && modify->fix[at]->peratom_flag && modify->fix[at]->size_peratom_cols == 0)
    return modify->fix[at]->vector_atom;
  const bool is_double = program_->atom->extract_datatype(name.c_str()) == LAMMPS_DOUBLE;
  const void *values = is_double ? program_->atom->extract(name.c_str()) : NULL;
  if (!values)
    throw asperity::Error("the numbers '" + name +
                          "' do not exist; they must be temperature, where the atom style has it, "
                          "d_NAME of fix property/atom, or f_ID of a fix with one number");
  return static_cast<const double *>(values);
}

/* For particles still to come, LAMMPS gives only the largest diameter of each type. */
void EngineOfLammps::diameters(double &least, double &most) const {
  least = most = 0;
  for (int type = 1; type <= types(); type++) {
    const double d_p = 2 * radius_to_come(type);
    if (!(d_p > 0))
      continue;
    least = most > 0 ? std::min(least, d_p) : d_p;
    most = std::max(most, d_p);
  }
  asperity::add_diameters(EngineOf::spheres(), group(), world(), least, most);
}

std::vector<asperity::Engine::Kind> EngineOfLammps::kinds() const {
  std::vector<double> present;
  for (int type = 1; type <= types(); type++)
    present.push_back(radius_to_come(type));
  return asperity::kinds_of(EngineOf::spheres(), group(), present, world());
}
