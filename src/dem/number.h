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

} // namespace asperity

#endif
