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

#ifdef __cplusplus
}
#endif

#endif
