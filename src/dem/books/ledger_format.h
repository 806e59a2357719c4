/* The rows of a ledger as its files have them, lines of CSV.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_LEDGER_FORMAT_H
#define ASPERITY_DEM_LEDGER_FORMAT_H

#include <array>
#include <string>
#include <vector>

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
void append_line(const LedgerRow &row, int columns, std::vector<char> &bytes);

/* The names of the columns, as the second line of CSV has them, without an end of line. */
std::string ledger_names(int columns);

} // namespace asperity

#endif
