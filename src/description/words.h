/* The words of a description, one after the other, and the numbers among them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_DESCRIPTION_WORDS_H
#define ASP_DESCRIPTION_WORDS_H

#include "base/error.h"
#include "description/description.h"

#include <string.h>

/* The words of a clause, of which `next` comes next, and the description that they go into. */
typedef struct aspi_words {
  asp_description *d;
  const char *const *words;
  int count, next;
  const char *others; /* words of the caller that end a list of names */
  asp_error *error;
  const char *of; /* behind the name of a word that is missing */
} aspi_words;

/* True if the next word is this one, or begins with a number; take: and goes past it. */
bool aspi_words_next_is(const aspi_words *words, const char *word);
bool aspi_words_take(aspi_words *words, const char *word);
bool aspi_words_number_next(const aspi_words *words);

/* True if the next word is this keyword, which is taken and noted as given; *code is ASP_EARG, with
 * a message, where it was given before. */
bool aspi_words_take_once(aspi_words *words, const char *name, asp_code *code);

/* True, with a message where it belongs, if a word is a keyword within another one. */
bool aspi_words_misplaced(const aspi_words *words, const char *name);

/* Takes the next word; NULL and a message that names `what` where there is none. */
const char *aspi_words_word(aspi_words *words, const char *what);

/* Takes the name of a file into *name, from malloc. `-`, which cannot be read again, is refused. */
asp_code aspi_words_file(aspi_words *words, const char *what, char **name);

/* Takes the number of a keyword, with its unit if it has one, or `fit` where it may be that. */
asp_code aspi_words_number(aspi_words *words, const char *within, const char *name, double *value);

/* Takes the value of a keyword, a number or a flag, to its place; of all that come next within
 * another one, `any` if there were some. */
asp_code aspi_words_value(aspi_words *words, const asp_keyword *keyword);
asp_code aspi_words_values(aspi_words *words, const char *within, bool *any);

/* True if the word given is `fit` or `fit=START` and unknown numbers are allowed; *start is the
 * text of the number: START, NULL for none, else the word. add_unknown: notes the number of that
 * name as unknown. */
bool aspi_words_unknown(const aspi_words *words, const char *given, const char **start);
asp_code aspi_words_add_unknown(aspi_words *words, const char *name);

/* ASP_EARG if the caller's units are not known: "<what> in SI units, which cannot be ...". */
asp_code aspi_words_check_units(const aspi_words *words, const char *what);

/* The clauses `surface` and `materials` (surface.c, materials.c). */
asp_code aspi_words_surface(aspi_words *words);
asp_code aspi_words_materials(aspi_words *words);

enum { ASPI_LIST_MOST = 1000 }; /* characters of all words that may stand at one place */

/* True if a list of words with blanks between has the word. */
static inline bool aspi_words_in_list(const char *word, const char *list) {
  return aspi_word_index(list, word, strlen(word), true) >= 0;
}

/* A copy from malloc; NULL and a message when out of memory. */
char *aspi_words_copy(const char *text, asp_error *error);

#endif
