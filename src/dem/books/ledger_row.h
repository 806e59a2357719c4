/* The row of an impact in a ledger, and rows on their way to its file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_LEDGER_ROW_H
#define ASPERITY_DEM_LEDGER_ROW_H

#include "asperity_internal.h"
#include "dem/books/ledger_file.h"
#include "dem/books/ledger_format.h"

namespace asperity {

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
