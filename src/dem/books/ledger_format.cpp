/* The rows of a ledger as its files have them; see ledger_format.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/books/ledger_format.h"

#include <cmath>
#include <algorithm>

#include "base/number.h"

using namespace asperity;

/* Whole numbers (i) are printed as such in CSV. */
#define LEDGER_NAMED(ID, name, type, text) {name, type},
static const struct {
  const char *name, *type;
} COLUMNS[] = {LEDGER_COLUMNS(LEDGER_NAMED) LEDGER_MORE_COLUMNS(LEDGER_NAMED)};
#undef LEDGER_NAMED

std::string asperity::ledger_names(int columns) {
  std::string names;
  for (int i = 0; i < columns; i++)
    names += (i > 0 ? "," : "") + std::string(COLUMNS[i].name);
  return names;
}

void asperity::append_line(const LedgerRow &row, int columns, std::vector<char> &bytes) {
  char line[(ASPI_NUMBER_MOST + 1) * LedgerColumn::N_FULL], *end = line;
  for (int i = 0; i < columns; i++) {
    if (i > 0)
      *end++ = ',';
    if (std::isnan(row[i])) /* a coefficient that there is not */
      continue;
    if (COLUMNS[i].type[0] != 'i')
      end = aspi_number_format(row[i], 10, end);
    else {
      const std::string count = std::to_string(static_cast<long long>(row[i]));
      end = std::copy(count.begin(), count.end(), end);
    }
  }
  *end++ = '\n';
  bytes.insert(bytes.end(), line, end);
}
