/* The rows of a ledger as its files have them: lines of CSV, or records of an array in NumPy's
 * format.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_LEDGER_FORMAT_H
#define ASPERITY_DEM_LEDGER_FORMAT_H

#include <stdint.h>
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

/* True if a file of that name is an array. */
bool is_ledger_array(const std::string &path);

/* columns: how many of them a file has, N_COLUMNS or N_FULL; here and below. */
void append_line(const LedgerRow &row, int columns, std::vector<char> &bytes);
void append_record(const LedgerRow &row, int columns, std::vector<char> &bytes);
int64_t bytes_of_record(int columns);

/* The names of the columns, as the second line of CSV has them, without an end of line. */
std::string ledger_names(int columns);

/* An array's header has this length, whatever its heading. */
enum { LEDGER_HEADER = 2048 };

/* The dictionary of an array's header, up to the number of its rows, and the header with it. */
std::string begin_array(const std::string &heading, int columns);
std::string array_header(const std::string &begin, int64_t rows);

/* Finds the text of begin_array() in the header of a file with these columns; empty for other
 * files. */
std::string find_begin(const std::string &header, int columns);

} // namespace asperity

#endif
