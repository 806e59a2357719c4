/* Numbers in text.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* C's vsnprintf in the "C" locale. */
int aspi_print_list(char *text, size_t size, const char *format, va_list list);

/* C's strtod in the "C" locale: a decimal point, whatever locale the program has set. */
double aspi_number(const char *text, char **end);

/* Reads plain decimals whose digits and power of ten are both exact doubles, so that one operation
 * rounds like strtod (Clinger 1990). False if the text has anything else, or the number needs
 * aspi_number. The decimal point may also be `other_point`. */
bool aspi_number_read(const char *text, char other_point, double *value);

/* The shortest text that aspi_number reads back as the same number, with at least 15 digits if 15
 * are needed; at most 32 characters with the NUL. */
void aspi_number_print(double value, char text[32]);

/* Room for aspi_number_format. */
enum { ASPI_NUMBER_MOST = 40 };

/* Writes a number exactly like printf's `%.*g` in the "C" locale, three times as fast for up to 15
 * digits: printing numbers is most of the cost of a file of results. No NUL; returns the end. */
char *aspi_number_format(double value, int digits, char to[ASPI_NUMBER_MOST]);

/* The same of a whole number from 0 to 2^53, with all of its digits. */
char *aspi_count_format(double value, char to[ASPI_NUMBER_MOST]);

#ifdef __cplusplus
}
#endif
