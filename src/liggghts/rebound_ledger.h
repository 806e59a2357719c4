/* The ledger of a rough wall: one row an impact. Rows live from one multiple of N to the next, for
 * `dump local`; with a file, the same rows go to one CSV, gathered from all ranks and sorted by
 * step, time, particle and impact, so that the file does not depend on the number of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_REBOUND_LEDGER_H
#define LMP_REBOUND_LEDGER_H

#include <mpi.h>
#include <stdio.h>
#include <array>
#include <string>
#include <vector>

#include "lmptype.h"

namespace LAMMPS_NS {

class ReboundLedger {
public:
  enum {
    TAG,
    IMPACT,
    TIME,
    MESH,
    TRIANGLE,
    X,
    Y,
    Z,
    D_P,
    V1,
    ALPHA1,
    DELTA_ALPHA,
    TILT_OUT,
    HITS,
    V2,
    ALPHA2,
    COR_N,
    COR_T,
    OUTCOME,
    N_COLUMNS, /* those that users see */
    STEP = N_COLUMNS,
    COR_T_DEFINED,
    N_FIELDS
  };
  typedef std::array<double, N_FIELDS> Row;

  ReboundLedger(MPI_Comm world, bigint every, const std::string &path);
  ~ReboundLedger();

  /* Opens the file, on rank 0, with a comment line and the names of the columns; appends to what an
   * earlier part of a restarted run left. Collective. Returns an empty string, or why it cannot be
   * written. */
  std::string open(bool append, const std::string &heading);

  void add(const Row &row);

  /* At the beginning of a step: forgets the rows of the window that has ended. */
  void begin_step(bigint step);

  /* At the end of a step, and of a run: rows to the file when a window ends. Collective. */
  void end_step(bigint step);
  std::string flush();

  bigint every() const {
    return every_;
  }
  int size() const {
    return static_cast<int>(rows_.size());
  }
  double **rows();
  double memory_usage() const;

private:
  /* A row as text, and where it belongs. */
  struct Line {
    double step, time, tag, impact;
    size_t length;
  };

  void write(const std::vector<Line> &lines, const std::vector<char> &text);

  MPI_Comm world_;
  int rank_;
  bigint every_;
  std::string path_;
  FILE *file_;
  bool failed_;
  std::vector<Row> rows_;
  std::vector<double *> pointers_;
  size_t written_; /* how many of rows_ are in the file */
};

} // namespace LAMMPS_NS

#endif
