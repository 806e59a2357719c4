/* Numbers in text.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_BASE_NUMBER_H
#define ASP_BASE_NUMBER_H

#ifdef __cplusplus
extern "C" {
#endif

/* As C's strtod in its "C" locale, with a decimal point, whatever locale the program has set. */
double aspi_number(const char *text, char **end);

/* The shortest text that aspi_number reads as the same number, of at least 15 digits where it needs
 * as many; at most 32 characters with the NUL. */
void aspi_number_print(double value, char text[32]);

#ifdef __cplusplus
}
#endif

#endif
