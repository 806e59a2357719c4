/* Error reports of the core: a code, and one line that names the thing, its value and what it must
 * be.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity.h"

#if defined(__GNUC__)
#define ASPI_FORMAT(text, first) __attribute__((format(printf, text, first)))
#else
#define ASPI_FORMAT(text, first)
#endif
ASPI_FORMAT(3, 4) asp_code aspi_fail(asp_error *error, asp_code code, const char *format, ...);

/* The same for functions that return a pointer: NULL. */
#define aspi_fail_null(...) (aspi_fail(__VA_ARGS__), NULL)

/* ASP_EDATA and "<path>:<line>: <message>"; line 0: there are none. */
ASPI_FORMAT(4, 5)
asp_code aspi_file_fail(const char *path, size_t line, asp_error *error, const char *format, ...);

/* ASP_OK when value is finite and least <= value <= most; otherwise ASP_EARG, and a message that
 * calls it `name` and its unit `unit` ("" for none). */
asp_code aspi_check_range(asp_error *error, const char *name, const char *unit, double value,
                          double least, double most);

/* ASP_EARG unless a length is from 1e-100 to 1e100 in any unit, so that ratios and squares do not
 * overflow. */
asp_code aspi_check_length(asp_error *error, const char *name, double value);

/* ASP_ENAME and "<what> 'name' is unknown; did you mean 'b'? there are: a b c", where `list` is the
 * names that there are, with blanks between. */
asp_code aspi_fail_unknown(asp_error *error, const char *what, const char *name, const char *list);

/* A caller's word; "" where it is NULL. */
static inline const char *aspi_word_or_empty(const char *word) {
  return word ? word : "";
}

/* Appends like printf to a text with room for `size` characters. */
ASPI_FORMAT(3, 4) void aspi_append(char *text, size_t size, const char *format, ...);

/* Index, from 0, of a word (its first `length` characters) in a list of words with blanks between;
 * case matters only if `exact`. -1: not in the list. */
int aspi_word_index(const char *list, const char *word, size_t length, bool exact);

/* Writes the most similar name of a list into `meant`; false if none is similar. */
bool aspi_nearest_name(const char *name, const char *list, char meant[64]);

/* Index of a name, in upper or lower case, among `count` records that begin with a name; -1 and the
 * message of aspi_fail_unknown if it is not there. */
int aspi_find_name(const char *what, const char *name, int count, const void *records,
                   asp_error *error);
