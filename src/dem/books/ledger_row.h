/* The row of an impact in a ledger, and rows on their way to its file as lines of CSV.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_LEDGER_ROW_H
#define ASPERITY_DEM_LEDGER_ROW_H

#include <array>
#include <string>
#include <vector>

#include "asperity_internal.h"
#include "base/ledger_columns.h"
#include "dem/books/ledger_file.h"

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
void append_line(const LedgerRow &row, int columns, std::vector<char> &bytes);

/* The names of the columns, as the second line of CSV has them, without an end of line. */
std::string ledger_names(int columns);

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
  void add(const LedgerRow &row, int columns);

  /* Adds the rows to a file, in order of their keys. Returns an empty string, or why they are not
   * there. */
  std::string commit(LedgerFile &file) const;
};

} // namespace asperity

#endif
