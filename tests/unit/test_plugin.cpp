/* The plugin in programs that have LAMMPS's library interface, of its own version and of others: a
 * message for LAMMPS to report, and the program goes on. Usage: test_plugin PLUGIN
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <dlfcn.h>
#include <string>

#include "check.h"

namespace {

const char *plugin;
int version, tag_bytes, has_mpi = 1;
std::string message;

/* Loads the plugin as LAMMPS does. */
std::string load() {
  message.clear();
  void *handle = dlopen(plugin, RTLD_NOW | RTLD_GLOBAL);
  assert_non_null(handle);
  typedef void (*Init)(void *, void *, void *);
  reinterpret_cast<Init>(dlsym(handle, "lammpsplugin_init"))(&version, handle, NULL);
  dlclose(handle);
  return message;
}

void says(const std::string &text, const char *part) {
  if (text.find(part) == std::string::npos)
    fail_msg("'%s' is not in '%s'", part, text.c_str());
}

TEST(another_version) {
  version = 20200101;
  tag_bytes = 4;
  says(load(), "wallreboundplugin.so: the version of LAMMPS is 20200101, but it was built for "
               "20260704; build asperity again");
}

TEST(other_integers) {
  version = 20260704;
  tag_bytes = 8;
  says(load(), "the size of tagint is 8, but it was built for 4");
}

TEST(no_mpi) {
  version = 20260704;
  tag_bytes = 4;
  has_mpi = 0;
  says(load(), "wallreboundplugin.so: this LAMMPS was built without MPI; build it with");
  has_mpi = 1;
}

/* Where all is well, the fix's own file comes next. */
TEST(no_style) {
  version = 20260704;
  tag_bytes = 4;
  says(load(), "wallreboundstyle.so: cannot open shared object file");
}

} // namespace

extern "C" {
int lammps_version(void *lammps);
int lammps_extract_setting(void *lammps, const char *name);
int lammps_config_has_mpi_support();
void lammps_error(void *lammps, int kind, const char *text);

int lammps_version(void *lammps) {
  return *static_cast<int *>(lammps);
}

int lammps_extract_setting(void *, const char *name) {
  return strcmp(name, "bigint") == 0 ? 8 : strcmp(name, "tagint") == 0 ? tag_bytes : 4;
}

int lammps_config_has_mpi_support() {
  return has_mpi;
}

void lammps_error(void *, int kind, const char *text) {
  assert_int_equal(kind, 2);
  message = text;
}
}

int main(int, char **argv) {
  plugin = argv[1];
  return run_listed_tests(NULL, NULL);
}
