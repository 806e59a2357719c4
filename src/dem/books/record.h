/* A wall's part of a restart file: a head with a magic number, a version, the length, and
 * checksums, then the state. Numbers are in the machine's own form, as in the engines' restart
 * files.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <string>
#include <utility>
#include <vector>

#include "dem/books/ledger_file.h"

namespace asperity {

/* Settings of the wall in the script: names and values. */
typedef std::vector<std::pair<std::string, std::string>> Settings;

/* Settings with the clauses of the description in its place, each by its first word. */
Settings clauses(const Settings &settings);

/* "name NEW, was OLD; ...", of those that differ; empty where all are the same. */
std::string describe_changes(const Settings &now, const Settings &saved);

struct MeshState {
  std::string id;
  int64_t triangles;
  std::vector<double> totals; /* of the mesh; impacts first */
  std::vector<double> map;    /* of its triangles, by their ids */
  std::vector<double> motion; /* of a mesh that has moved, as MeshShape has it; empty otherwise */
};

struct WallState {
  Settings settings;
  std::vector<double> counters;
  std::vector<double> totals; /* of a primitive wall; empty for one of meshes */
  std::vector<MeshState> meshes;
  std::vector<double> bodies; /* what they remember of the wall, packed */
  double d_range[2];          /* diameters that tables span */
  double clock[3]; /* time, step and length of a step from which the ledger's time counts */
  LedgerState ledger;
};

/* Does not change the state. */
std::vector<char> pack(WallState &state);

/* Throws an Error for a record of more bytes than the engines' restart files can hold: they state
 * its length as an int. */
void check_record_size(uint64_t bytes);

/* Reads a record from at most `available` bytes. An engine that does not know this number leaves it
 * out; then the length in the head counts, which has its own checksum. Throws an Error if bytes are
 * damaged, cut short, or of another version. */
WallState unpack(const char *bytes, size_t available = SIZE_MAX);

} // namespace asperity
