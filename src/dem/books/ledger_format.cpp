/* The rows of a ledger as its files have them; see ledger_format.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/books/ledger_format.h"

#include <cmath>
#include <string.h>
#include <algorithm>

#include "base/number.h"

using namespace asperity;

#if __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "arrays are written little-endian"
#endif

/* Whole numbers (i) are printed as such in CSV. */
#define LEDGER_NAMED(ID, name, type, text) {name, type},
static const struct {
  const char *name, *type;
} COLUMNS[] = {LEDGER_COLUMNS(LEDGER_NAMED) LEDGER_MORE_COLUMNS(LEDGER_NAMED)};
#undef LEDGER_NAMED

/* An array's header: magic, version, length, a Python dictionary. */
static const size_t PREAMBLE = 10, TITLE_MOST = 1000;
static const char SHAPE[] = "'shape': (";

bool asperity::is_ledger_array(const std::string &path) {
  const std::string end = ".npy";
  return path.size() >= end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0;
}

static int bytes_of(int column) {
  return COLUMNS[column].type[1] - '0';
}

int64_t asperity::bytes_of_record(int columns) {
  int64_t bytes = 0;
  for (int i = 0; i < columns; i++)
    bytes += bytes_of(i);
  return bytes;
}

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

void asperity::append_record(const LedgerRow &row, int columns, std::vector<char> &bytes) {
  char record[sizeof(int64_t) * LedgerColumn::N_FULL], *end = record;
  for (int i = 0; i < columns; i++) {
    const double value = row[i];
    if (COLUMNS[i].type[0] == 'i') {
      const int64_t whole = static_cast<int64_t>(value); /* its first bytes: the same in fewer */
      memcpy(end, &whole, sizeof whole);
    } else if (bytes_of(i) == 4) {
      const float single = static_cast<float>(value);
      memcpy(end, &single, sizeof single);
    } else
      memcpy(end, &value, sizeof value);
    end += bytes_of(i);
  }
  bytes.insert(bytes.end(), record, end);
}

/* The columns behind the first one, whose title is the heading: the one place that the format has
 * for a text. */
static std::string other_columns(int columns) {
  std::string text;
  for (int i = 1; i < columns; i++)
    text += std::string(", ('") + COLUMNS[i].name + "', '" + (bytes_of(i) > 1 ? "<" : "|") +
            COLUMNS[i].type + "')";
  return text + "], 'fortran_order': False, " + SHAPE;
}

std::string asperity::begin_array(const std::string &heading, int columns) {
  std::string title;
  for (char c : heading.substr(0, TITLE_MOST))
    title += c == '\'' || c == '\\' ? ' ' : c;
  return "{'descr': [(('" + title + "', '" + COLUMNS[0].name + "'), '<" + COLUMNS[0].type + "')" +
         other_columns(columns);
}

std::string asperity::array_header(const std::string &begin, int64_t rows) {
  const unsigned length = LEDGER_HEADER - PREAMBLE;
  const unsigned char preamble[PREAMBLE] = {0x93, 'N', 'U', 'M',           'P',
                                            'Y',  1,   0,   length & 0xff, length >> 8};
  std::string text(preamble, preamble + PREAMBLE);
  text += begin + std::to_string(rows) + ",), }";
  text.resize(LEDGER_HEADER - 1, ' ');
  return text + '\n';
}

std::string asperity::find_begin(const std::string &header, int columns) {
  const std::string others = other_columns(columns);
  const size_t at = header.find(others);
  if (header.size() != LEDGER_HEADER || at == std::string::npos || at < PREAMBLE)
    return "";
  return header.substr(PREAMBLE, at + others.size() - PREAMBLE);
}
