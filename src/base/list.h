/* Lists of numbers with units, as `1um,10um` or `5:90:5`, and log-normal laws.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_BASE_LIST_H
#define ASP_BASE_LIST_H

#include "asperity.h"

/* A list of values, or a truncated log-normal distribution if count is 0. */
typedef struct aspi_list {
  double *values;
  size_t count;
  double least, most; /* of the values, or where the law ends */
  double median;
} aspi_list;

/* Reads `a,b,c`, where each may be `from:to:step` with both ends included, or
 * `lognormal:min:max:median`. Each number is as aspi_quantity_read has it and lies from `least` to
 * `most`. ASP_EARG and a message that calls the list `name` and shows the forms. */
asp_code aspi_list_read(const char *name, const char *text, const char *kind,
                        const asp_units *units, double least, double most, aspi_list *list,
                        asp_error *error);
void aspi_list_free(aspi_list *list);

#endif
