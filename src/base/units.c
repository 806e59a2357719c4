/* Units of length by the names that people and instruments give them, and where the header of a
 * text file states them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/units.h"
#include "base/text.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>
#include <strings.h>

static const struct {
  const char *name;
  double metres;
} units[] = {
    {"m", 1},
    {"meter", 1},
    {"meters", 1},
    {"metre", 1},
    {"metres", 1},
    {"cm", 1e-2},
    {"mm", 1e-3},
    {"millimeter", 1e-3},
    {"millimeters", 1e-3},
    {"millimetre", 1e-3},
    {"millimetres", 1e-3},
    {"millimetro", 1e-3},
    {"\xE3\x8E\x9C", 1e-3}, /* one character, as in Japan and China */
    {"um", 1e-6},
    {"micrometer", 1e-6},
    {"micrometers", 1e-6},
    {"micrometre", 1e-6},
    {"micrometres", 1e-6},
    {"micron", 1e-6},
    {"microns", 1e-6},
    {"\xB5m", 1e-6},        /* micro sign, Latin-1 */
    {"\xC2\xB5m", 1e-6},    /* micro sign, UTF-8 */
    {"\xCE\xBCm", 1e-6},    /* Greek mu, UTF-8 */
    {"\x83\xCAm", 1e-6},    /* Greek mu, Shift JIS */
    {"\xE3\x8E\x9B", 1e-6}, /* one character */
    {"mikrometer", 1e-6},
    {"micrometro", 1e-6},
    {"nm", 1e-9},
    {"nanometer", 1e-9},
    {"nanometers", 1e-9},
    {"nanometre", 1e-9},
    {"nanometres", 1e-9},
    {"\xE3\x8E\x9A", 1e-9}, /* one character */
    {"in", 25.4e-3},
    {"inch", 25.4e-3},
    {"inches", 25.4e-3},
    {"mil", 25.4e-6},
    {"mils", 25.4e-6},
    {"thou", 25.4e-6},
    {"uin", 25.4e-9},
    {"\xB5in", 25.4e-9},
    {"\xC2\xB5in", 25.4e-9},
    {"\xCE\xBCin", 25.4e-9},
    {"uinch", 25.4e-9},
    {"microinch", 25.4e-9},
    {"microinches", 25.4e-9},
    {"A", 1e-10},
    {"Angstrom", 1e-10},
    {"Angstroms", 1e-10},
    {"\xC5", 1e-10},         /* Latin-1 */
    {"\xC3\x85", 1e-10},     /* UTF-8 */
    {"\xE2\x84\xAB", 1e-10}, /* the sign of its own, UTF-8 */
};

double aspi_unit_metres(const char *name, size_t length) {
  for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
    const char *known = units[i].name;
    if (strlen(known) != length)
      continue;
    if (length == 1 ? *known == *name : strncasecmp(known, name, length) == 0)
      return units[i].metres;
  }
  return 0;
}

static bool is_letter(char c) {
  return isalpha((unsigned char)c) || (unsigned char)c >= 0x80;
}

/* A unit in brackets, behind an underscore or a slash is one for certain; a word of its own is one
 * unless a number comes before it, or it is a single letter, or the word `in`. */
static bool states_unit(const char *line, const char *word, size_t length, bool named) {
  const char *before = word;
  while (before > line && before[-1] == ' ')
    before--;
  char c = before > line ? before[-1] : '\0';
  if ((c && strchr("([{_/", c)) ||
      (before - line >= 3 && strncmp(before - 3, "\xEF\xBC\x88", 3) == 0)) /* a wide bracket */
    return true;
  if (isdigit((unsigned char)c) || c == '.')
    return false;
  bool preposition = length == 2 && strncasecmp(word, "in", 2) == 0;
  return !preposition && (length > 1 || named);
}

int aspi_units_in(const char *line, double found[2]) {
  bool named = aspi_text_holds(line, "unit");
  int count = 0;
  for (const char *c = line; *c;) {
    size_t length = 0;
    while (is_letter(c[length]))
      length++;
    double metres = length ? aspi_unit_metres(c, length) : 0;
    if (metres > 0 && states_unit(line, c, length, named)) {
      if (count < 2)
        found[count] = metres;
      count++;
    }
    c += length ? length : 1;
  }
  return count;
}

int aspi_header_units(const char *line, double found[2]) {
  int count = aspi_units_in(line, found);
  if (count == 1 && aspi_text_holds(line, "unit")) {
    found[1] = found[0];
    count = 2;
  }
  return count;
}
