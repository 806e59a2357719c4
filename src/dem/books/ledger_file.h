/* The rows of a ledger as lines of CSV, and their file, on the one rank that writes it. A run
 * begins it; a restart continues it. Rows are added many at once, those of some steps. If a write
 * fails, the file is cut back to the last row before them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <array>
#include <string>
#include <vector>

#include "asperity_engine.h"
#include "base/ledger_columns.h"

namespace asperity {

/* Places in a row: the columns that users see, and what goes with them. */
struct LedgerColumn {
#define LEDGER_PLACE(ID, name, type, text) ID,
  enum {
    LEDGER_COLUMNS(LEDGER_PLACE) N_COLUMNS,
    LAST = N_COLUMNS - 1,
    LEDGER_MORE_COLUMNS(LEDGER_PLACE) N_FULL,
    STEP = N_FULL,
    N_FIELDS
  };
#undef LEDGER_PLACE
};
typedef std::array<double, LedgerColumn::N_FIELDS> LedgerRow;

/* columns: how many of them a file has, N_COLUMNS or N_FULL; here and below. */
void append_line(const double *row, int columns, std::vector<char> &bytes);

/* The names of the columns, as the second line of CSV has them, without an end of line. */
std::string ledger_names(int columns);

/* FNV-1a: changes with every byte. */
uint32_t checksum(const void *bytes, size_t length);

/* State of a ledger's file in a restart file: enough to recognize the file and cut it back. */
struct LedgerState {
  std::string path; /* as the script has it; empty: there is nothing to continue */
  int64_t rows, bytes;
  uint32_t tail; /* checksum of the last rows */
};

class LedgerFile {
public:
  LedgerFile(const std::string &path, int columns);
  ~LedgerFile();
  LedgerFile(const LedgerFile &) = delete;
  LedgerFile &operator=(const LedgerFile &) = delete;

  /* Continues the file if `saved`, of a restart file, describes it; begins it anew otherwise.
   * Throws an Error if it is not a regular file, cannot be written or continued, or is locked by
   * another wall or run. Returns a note for the user, or an empty string. */
  std::string open(const LedgerState &saved, const std::string &heading);

  /* Adds that many rows, as the file has them: they are all in the file, or none.
   * Returns an empty string, or why they are not. */
  std::string commit(const std::vector<char> &bytes, int64_t rows);

  /* Waits until the disk has all of it. Returns an empty string, or why it has not. */
  std::string sync();

  LedgerState state() const;

private:
  bool open_or_create(const LedgerState &saved);
  void lock();
  void begin(const std::string &heading);
  std::string begin_or_continue(bool is_new, const LedgerState &saved, const std::string &heading);
  std::string continue_at(const LedgerState &state);
  void check_columns();
  bool holds(const LedgerState &state) const;
  uint32_t tail_at(int64_t bytes) const;
  int64_t size() const;
  int64_t count_rows(int64_t from, bool &torn) const;

  std::string write(const char *bytes, size_t length);
  std::string take_back();
  std::string damage() const;

  std::string path_;
  int columns_;
  int fd_;
  int64_t rows_, bytes_; /* that were added */
  bool torn_;            /* there may be more than bytes_ in the file */
};

/* The columns that follow from an impact and the velocity before it, relative to the wall; all
 * others are 0. */
LedgerRow impact_row(const double v1[3], const double n[3], const asp_impact &impact);

/* Rows as a file has them, of one rank or of all, in any order. */
struct PrintedRows {
  enum { KEY = 5 };
  std::vector<double> keys; /* of each row: step, time, tag, impact, and its length in bytes */
  std::vector<char> bytes;

  size_t size() const {
    return keys.size() / KEY;
  }
  void add(const double *row, int columns, double step);

  /* Adds the rows to a file, in order of their keys. Returns an empty string, or why they are not
   * there. */
  std::string commit(LedgerFile &file) const;
};

} // namespace asperity
