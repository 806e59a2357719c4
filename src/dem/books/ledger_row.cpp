/* The row of an impact in a ledger; see ledger_row.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/books/ledger_row.h"

#include <algorithm>
#include <tuple>

using namespace asperity;

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
  row[L::COR_T_DEFINED] = c.cor_t_defined;
  for (int k = 0; k < 3; k++) {
    row[L::NX + k] = n[k];
    row[L::V1X + k] = v1[k];
    row[L::V2X + k] = impact.v2[k];
    row[L::OMEGA2X + k] = impact.omega[k];
  }
  return row;
}

static bool is_before(const LedgerRow &a, const LedgerRow &b) {
  typedef LedgerColumn L;
  return std::tie(a[L::STEP], a[L::TIME], a[L::TAG], a[L::IMPACT]) <
         std::tie(b[L::STEP], b[L::TIME], b[L::TAG], b[L::IMPACT]);
}

std::string asperity::commit_rows(std::vector<LedgerRow> &rows, int columns, LedgerFile &file) {
  std::vector<char> bytes;
  std::sort(rows.begin(), rows.end(), is_before);
  for (const LedgerRow &row : rows)
    (file.is_array() ? append_record : append_line)(row, columns, bytes);
  file.append(bytes.data(), bytes.size());
  return file.commit(static_cast<int64_t>(rows.size()));
}
