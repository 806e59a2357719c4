/* wallreboundplugin.so: the fix style wall/rebound as a plugin, for a LAMMPS with the package
 * PLUGIN. A script loads it by `plugin load wallreboundplugin.so`; LAMMPS finds it by itself in the
 * folders of LAMMPS_PLUGIN_PATH. It refers to no symbol of LAMMPS, so that every version loads it
 * and gets a message if it is not the right one. The fix is in wallreboundstyle.so beside it.
 *
 * ASPERITY_LAMMPS_VERSION is the version that this was built for, as a number such as 20210929.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <dlfcn.h>
#include <stdio.h>
#include <string>

namespace {

/* Functions of LAMMPS's library interface. */
typedef int (*Version)(void *lammps);
typedef int (*Setting)(void *lammps, const char *name);
typedef int (*HasMpi)();
typedef void (*Report)(void *lammps, int kind, const char *text);
const int ERROR_ON_ALL_RANKS = 2;

typedef void (*Register)(void *lammps, void *handle, void *register_function);

const char NAME[] = "wallreboundplugin.so", STYLE[] = "wallreboundstyle.so";

/* Bytes of LAMMPS's integers. */
struct Integer {
  const char *name;
  int bytes;
};
#if defined(LAMMPS_BIGBIG)
const Integer INTEGERS[] = {{"tagint", 8}, {"bigint", 8}, {"imageint", 8}};
#elif defined(LAMMPS_SMALLSMALL)
const Integer INTEGERS[] = {{"tagint", 4}, {"bigint", 4}, {"imageint", 4}};
#else
const Integer INTEGERS[] = {{"tagint", 4}, {"bigint", 8}, {"imageint", 4}};
#endif

template <class Function> Function find(const char *name, void *from = RTLD_DEFAULT) {
  return reinterpret_cast<Function>(dlsym(from, name));
}

std::string mismatch(const std::string &what, int theirs, int ours) {
  return what + " is " + std::to_string(theirs) + ", but it was built for " + std::to_string(ours) +
         "; build asperity again against this LAMMPS";
}

/* Reason why this LAMMPS cannot have the style; empty if there is none. */
std::string check(void *lammps) {
  const Version version = find<Version>("lammps_version");
  const Setting setting = find<Setting>("lammps_extract_setting");
  if (!version || !setting)
    return "this program has no library interface of LAMMPS";
  if (version(lammps) != ASPERITY_LAMMPS_VERSION)
    return mismatch("the version of LAMMPS", version(lammps), ASPERITY_LAMMPS_VERSION);
  for (const Integer &integer : INTEGERS)
    if (setting(lammps, integer.name) != integer.bytes)
      return mismatch(std::string("the size of ") + integer.name, setting(lammps, integer.name),
                      integer.bytes);
  const HasMpi has_mpi = find<HasMpi>("lammps_config_has_mpi_support");
  if (has_mpi && !has_mpi())
    return "this LAMMPS was built without MPI; build it with -DBUILD_MPI=on";
  return "";
}

/* The function of the file beside this one; NULL where there is none, and then why. */
Register load_style(std::string &wrong) {
  Dl_info self;
  dladdr(NAME, &self);
  const std::string path = self.dli_fname;
  const size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "./" : path.substr(0, slash + 1);
  void *style = dlopen((folder + STYLE).c_str(), RTLD_NOW);
  const Register function = style ? find<Register>("aspi_register_style", style) : NULL;
  if (!function)
    wrong = dlerror();
  return function;
}

/* Reports an error of LAMMPS, which a Python session survives; LAMMPS before November 2022 has no
 * function for it. */
void report(void *lammps, const std::string &wrong) {
  const std::string message = std::string(NAME) + ": " + wrong;
  const Report error = find<Report>("lammps_error");
  const Setting setting = find<Setting>("lammps_extract_setting");
  if (error)
    error(lammps, ERROR_ON_ALL_RANKS, message.c_str());
  else if (!setting || setting(lammps, "world_rank") == 0)
    fprintf(stderr, "ERROR: %s\n", message.c_str());
}

} // namespace

extern "C" void lammpsplugin_init(void *lammps, void *handle, void *register_function) {
  std::string wrong = check(lammps);
  const Register function = wrong.empty() ? load_style(wrong) : NULL;
  if (function)
    function(lammps, handle, register_function);
  else
    report(lammps, wrong);
}
