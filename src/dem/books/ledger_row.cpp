/* The rows of a ledger; see ledger_row.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/books/ledger_row.h"

#include <algorithm>
#include <cmath>

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

LedgerRow asperity::impact_row(const double v1[3], const double n[3], const asp_impact &impact) {
  typedef LedgerColumn L;
  const double degrees = 180 / ASP_PI;
  const asp_coefficients c = asp_impact_coefficients(v1, n, &impact);
  LedgerRow row = {};
  row[L::V1] = c.v1;
  row[L::ALPHA1] = c.alpha1 * degrees;
  row[L::DELTA_ALPHA] = impact.delta_alpha * degrees;
  row[L::TILT_OUT] = impact.tilt_out * degrees;
  row[L::HITS] = impact.hits;
  row[L::V2] = c.v2;
  row[L::ALPHA2] = c.alpha2 * degrees;
  row[L::COR_N] = c.cor_n;
  row[L::COR_T] = c.cor_t;
  for (int k = 0; k < 3; k++) {
    row[L::NX + k] = n[k];
    row[L::V1X + k] = v1[k];
    row[L::V2X + k] = impact.v2[k];
    row[L::OMEGA2X + k] = impact.omega[k];
  }
  return row;
}

void PrintedRows::add(const LedgerRow &row, int columns) {
  typedef LedgerColumn L;
  const size_t before = bytes.size();
  append_line(row, columns, bytes);
  for (int column : {L::STEP, L::TIME, L::TAG, L::IMPACT})
    keys.push_back(row[column]);
  keys.push_back(static_cast<double>(bytes.size() - before));
}

std::string PrintedRows::commit(LedgerFile &file) const {
  struct Place {
    const double *key;
    const char *row;
    bool operator<(const Place &other) const {
      return std::lexicographical_compare(key, key + KEY - 1, other.key, other.key + KEY - 1);
    }
  };
  std::vector<Place> order;
  order.reserve(size());
  const char *row = bytes.data();
  for (const double *key = keys.data(); order.size() < size(); key += KEY) {
    order.push_back(Place{key, row});
    row += static_cast<size_t>(key[KEY - 1]);
  }
  std::sort(order.begin(), order.end());
  for (const Place &place : order)
    file.append(place.row, static_cast<size_t>(place.key[KEY - 1]));
  return file.commit(static_cast<int64_t>(order.size()));
}
