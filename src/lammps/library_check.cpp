/* The check of a LAMMPS library; see engine_lammps.h. ASPERITY_LAMMPS_VERSION is the version of the
 * headers, as a number such as 20210929.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "engine_lammps.h"

#include "lammps.h"
#include "atom.h"
#include "domain.h"
#include "error.h"
#include "library.h"
#include "modify.h"
#include "update.h"

#include "dem/launcher.h"

using namespace LAMMPS_NS;
using asperity::check_layout;
using asperity::library_mismatch;

static std::string check_integers(const char *name, size_t size) {
  const int theirs = lammps_extract_setting(NULL, name);
  if (theirs == static_cast<int>(size))
    return "";
  return library_mismatch(std::string("the type ") + name, std::to_string(theirs) + " bytes",
                          std::to_string(size) + " bytes");
}

std::string LAMMPS_NS::check_library(LAMMPS *lammps) {
  const int version = lammps_version(lammps);
  if (version != ASPERITY_LAMMPS_VERSION)
    return library_mismatch("the version of LAMMPS", std::to_string(version),
                            std::to_string(ASPERITY_LAMMPS_VERSION));
  const bool is_kokkos = lammps->kokkos; /* then some classes are derived ones */
  const std::string checks[] = {check_integers("tagint", sizeof(tagint)),
                                check_integers("bigint", sizeof(bigint)),
                                check_integers("imageint", sizeof(imageint)),
                                check_layout("LAMMPS", lammps),
                                check_layout("Atom", lammps->atom, is_kokkos),
                                check_layout("Domain", lammps->domain, is_kokkos),
                                check_layout("Error", lammps->error),
                                check_layout("Modify", lammps->modify, is_kokkos),
                                check_layout("Update", lammps->update)};
  for (const std::string &wrong : checks)
    if (!wrong.empty())
      return wrong;
  return "";
}
