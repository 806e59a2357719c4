/* The ledger of a rough wall: one row an impact. Rows live from one multiple of N to the next, for
 * `dump local`; with a file, the same rows go to it, gathered from all ranks and sorted by step,
 * time, particle and impact, so that the file does not depend on the number of ranks. A file whose
 * name ends with .npy is a one-dimensional structured array in NumPy's format, version 1.0, any
 * other one is CSV. An array's header says how many rows there are and is written after them, so
 * that a run which dies leaves a whole file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_WALL_LEDGER_H
#define ASPERITY_WALL_LEDGER_H

#include <mpi.h>
#include <stdint.h>
#include <stdio.h>
#include <array>
#include <memory>
#include <string>
#include <vector>

namespace asperity {

class Ledger {
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

  Ledger(MPI_Comm world, int64_t every, const std::string &path);
  ~Ledger();

  /* Opens the file, on rank 0, with a heading and the names of the columns; appends to what an
   * earlier part of a restarted run left. Collective. Returns an empty string, or why it cannot be
   * written. */
  std::string open(bool append, const std::string &heading);

  void add(const Row &row);

  /* At the beginning of a step: forgets the rows of the window that has ended. */
  void begin_step(int64_t step);

  /* At the end of a step, and of a run: rows to the file when a window ends. Collective. */
  void end_step(int64_t step);
  std::string flush();

  int64_t every() const {
    return every_;
  }
  int size() const {
    return static_cast<int>(size_);
  }
  double **rows();
  double memory_usage() const;

private:
  /* Where a row belongs. */
  struct Key {
    double step, time, tag, impact;
    bool operator<(const Key &other) const;
  };

  /* Some rows of one rank, in order, as the file has them. */
  struct Piece {
    std::vector<Key> keys;
    std::vector<int> lengths;
    std::vector<char> bytes;
  };

  /* Rows are never moved: growing by copies would touch three times the memory. */
  static const size_t BLOCK = 256;
  Row &row(size_t i) {
    return blocks_[i / BLOCK][i % BLOCK];
  }
  const Row &row(size_t i) const {
    return blocks_[i / BLOCK][i % BLOCK];
  }

  class Source;

  std::string open_csv(bool append, const std::string &heading);
  std::string open_array(bool append, const std::string &heading);
  std::string continue_array();
  void write_header();
  std::vector<size_t> sorted() const;
  void print(const std::vector<size_t> &order, size_t from, Piece &piece) const;
  void send(const std::vector<size_t> &order) const;
  void merge(const std::vector<size_t> &order, const std::vector<long long> &counts);

  MPI_Comm world_;
  int rank_, ranks_;
  int64_t every_;
  std::string path_;
  bool is_array_;
  std::string header_; /* of an array, up to the number of its rows */
  long long in_file_;  /* rows */
  FILE *file_;
  std::vector<std::unique_ptr<Row[]>> blocks_;
  std::vector<double *> pointers_;
  size_t size_, written_; /* of the rows; how many of them are in the file */
};

} // namespace asperity

#endif
