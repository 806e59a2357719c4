/* Numbers as `%.10g` of the C library prints them, to the last character, in a third of its time:
 * most of what a ledger costs is the printing of its rows.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_WALL_NUMBER_H
#define ASPERITY_WALL_NUMBER_H

namespace asperity {

/* Room that print_number() and print_count() may take. */
enum { NUMBER_MOST = 32 };

/* Both write to `to`, without a NUL, and return the end of what they wrote. */
char *print_number(double value, char *to);
char *print_count(long long value, char *to);

/* Reads the text up to `end` as C's strtod does with a decimal point, in a fifth of its time. False
 * where that is no number; `value` is left alone where it is too small or too large for one. */
bool read_number(const char *from, const char *end, double &value);

} // namespace asperity

#endif
