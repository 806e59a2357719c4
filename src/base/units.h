/* Units of length in the header of a text file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_BASE_UNITS_H
#define ASP_BASE_UNITS_H

/* The units of length in a line of a header, in metres: how many there are, and the first two. A
 * number before a unit makes it a value, not the unit of a column. A line with `unit` in it states
 * one for both. */
int asp_header_units(const char *line, double units[2]);

#endif
