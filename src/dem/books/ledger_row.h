/* The row of an impact in a ledger.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_LEDGER_ROW_H
#define ASPERITY_DEM_LEDGER_ROW_H

#include "asperity.h"
#include "dem/books/ledger_file.h"
#include "dem/books/ledger_format.h"

namespace asperity {

/* The columns that follow from an impact and the velocity before it, relative to the wall; all
 * others are 0. */
LedgerRow impact_row(const double v1[3], const double n[3], const asp_impact &impact);

/* Sorts the rows as a ledger has them, and adds them to its file. Returns an empty string, or why
 * they are not there. */
std::string commit_rows(std::vector<LedgerRow> &rows, int columns, LedgerFile &file);

} // namespace asperity

#endif
