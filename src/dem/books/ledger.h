/* The ledger of a rough wall: one row an impact. Rows live from one multiple of N to the next, for
 * `dump local`; with a file, the same rows go to it, gathered from all ranks and sorted by step,
 * time, particle and impact, so that the file does not depend on the number of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <mpi.h>
#include <stdint.h>
#include <memory>
#include <string>
#include <vector>

#include "dem/books/ledger_file.h"

namespace asperity {

class Ledger : public LedgerColumn {
public:
  /* Reaction of the engine if rows cannot be written. */
  enum OnError { STOP, GO_ON };

  /* Without a path there is no file. columns: N_COLUMNS or N_FULL. */
  Ledger(MPI_Comm world, int64_t every, const std::string &path, OnError on_error, int columns);
  ~Ledger();

  /* Takes the file's state from a restart file; before open(). */
  void restore(const LedgerState &saved);

  /* Opens the file, on rank 0, with a heading; once, whenever a run begins. Collective. Throws an
   * Error on all ranks where it cannot be written or continued. Returns a note for the user, or an
   * empty string. */
  std::string open(const std::string &heading);

  void add_row(const LedgerRow &row);

  /* At the beginning of a step: forgets the rows of the window that has ended. */
  void begin_step(int64_t step);

  /* At the end of a step, and of a run: rows to the file, at the end of a step when a window ends,
   * or when there are many. Collective. Returns an empty string, or, on all ranks, why rows are
   * lost, and how many. */
  std::string end_step(int64_t step);
  std::string flush();

  /* Flushes before a restart file is written; rank 0 gets what the file must carry. */
  std::string save(LedgerState &state);

  OnError on_error() const {
    return on_error_;
  }
  int64_t every() const {
    return every_;
  }
  int columns() const {
    return n_columns_;
  }
  int size() const {
    return static_cast<int>(numbers_.size() / static_cast<size_t>(n_columns_));
  }
  /* The columns of all rows, one block of memory as LAMMPS and its Python interface expect it.
   * Valid until the next row is added. */
  double **rows();
  size_t bytes() const;

private:
  std::string commit(const PrintedRows &rows);

  MPI_Comm world_;
  int rank_;
  int64_t every_;
  std::string path_;
  OnError on_error_;
  int n_columns_;
  LedgerState saved_;
  std::unique_ptr<LedgerFile> file_; /* on rank 0 */
  bool is_open_;
  int64_t lost_;                 /* rows, in all */
  int64_t steps_most_, n_steps_; /* after which rows are written, and those since they were */
  std::vector<double> numbers_;  /* n_columns_ of each row */
  std::vector<double> steps_;    /* of the last ones, which are not in the file yet */
  std::vector<double *> pointers_;
};

} // namespace asperity
