/* The sums of a mesh's triangles as a file that ParaView and its like read: VTK's XML format
 * (.vtp), with the time, so that the maps of a run are a time series.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <mpi.h>
#include <cstdint>
#include <string>
#include <vector>

#include "contact/tree.h"
#include "dem/shapes/motion.h"
#include "dem/text.h"

namespace asperity {

class MapFile {
public:
  MapFile() : every_(0) {}

  /* Reads `N FILE`: a map every N steps; a `*` in FILE becomes the step, without one each map takes
   * the place of that before. Throws an Error. */
  void parse(Words &words);

  bool is_due(int64_t step) const {
    return every_ > 0 && step % every_ == 0;
  }

  /* Writes the mesh where it is now, with the sums of each triangle by its number, Books::N_SUMS
   * each, and the depth of erosion: eroded mass over worn_density, that of the wall, and the
   * triangle's area; with worn_density 0 the wall has no erosion, and the map no depth. Collective;
   * rank 0 writes, and all throw an Error where it cannot. */
  void write(MPI_Comm world, int64_t step, double time, const ContactTree *triangles,
             const Frame &frame, const std::vector<double> &sums, double worn_density) const;

private:
  int64_t every_;
  std::string path_;
};

} // namespace asperity
