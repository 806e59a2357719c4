/* The check of a LAMMPS library; see library_check.h. ASPERITY_LAMMPS_VERSION is the version of the
 * headers, as a number such as 20210929.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "library_check.h"

#include <malloc.h>

#include "lammps.h"
#include "atom.h"
#include "domain.h"
#include "error.h"
#include "library.h"
#include "modify.h"
#include "update.h"

using namespace LAMMPS_NS;

std::string LAMMPS_NS::library_mismatch(const std::string &what, const std::string &found,
                                        const std::string &expected) {
  return what + " is " + found + ", but it was built for " + expected +
         "; build asperity again against this LAMMPS";
}

/* The library allocated the object with its own idea of the class; ours must fit in, and not leave
 * more over than the allocator rounds up to. */
template <class T> static std::string check_layout(const char *name, T *object) {
  const size_t room = malloc_usable_size(object);
  if (sizeof(T) <= room && room < sizeof(T) + 32)
    return "";
  return library_mismatch(name, std::to_string(room) + " bytes",
                          std::to_string(sizeof(T)) + " bytes");
}

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
  const std::string checks[] = {check_integers("tagint", sizeof(tagint)),
                                check_integers("bigint", sizeof(bigint)),
                                check_integers("imageint", sizeof(imageint)),
                                check_layout("the class LAMMPS", lammps),
                                check_layout("the class Atom", lammps->atom),
                                check_layout("the class Domain", lammps->domain),
                                check_layout("the class Error", lammps->error),
                                check_layout("the class Modify", lammps->modify),
                                check_layout("the class Update", lammps->update)};
  for (const std::string &wrong : checks)
    if (!wrong.empty())
      return wrong;
  return "";
}
