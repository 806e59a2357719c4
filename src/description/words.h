/* The words of a description, read and written one after the other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "base/error.h"
#include "description/description.h"

#include <string.h>

/* The words that the parser looks for behind the last one, for the shell's completion. */
typedef struct aspi_completions {
  char list[2000]; /* with blanks between; FILE stands for the name of a file */
  bool at_end;     /* the parser has looked behind the last word */
} aspi_completions;

/* The words of a clause, of which `next` comes next, and the description that they go into. */
typedef struct aspi_words {
  asp_description *d;
  const char *const *words;
  int count, next;
  const char *others; /* words of the caller that end a list of names */
  asp_error *error;
} aspi_words;

/* True if the next word is this one, or begins with a number. accept: also goes past it. */
bool aspi_words_next_is(const aspi_words *words, const char *word);
bool aspi_words_accept(aspi_words *words, const char *word);
bool aspi_words_number_next(const aspi_words *words);

/* Offers the words of a list, `freeze | delete | off`, if they would come behind the last word. */
void aspi_words_offer(const aspi_words *words, const char *list);

/* Takes the next word. Returns NULL and reports that `name` needs a value at the end of the words.
 */
const char *aspi_words_word(aspi_words *words, const char *name);

/* Takes the name of a file into *file, from malloc. `-`, which cannot be read again, is refused. */
asp_code aspi_words_file(aspi_words *words, const char *name, char **file);

/* Takes a number, with its unit if it has one, or `fit` where it may be that. */
asp_code aspi_words_number(aspi_words *words, const aspi_keyword *keyword, double *value);

/* Takes one of the keyword's values, as "freeze | delete | off": its number, from 0. */
asp_code aspi_words_choice(aspi_words *words, const aspi_keyword *keyword, int *index);

/* True, with a message, if a word belongs elsewhere: behind another keyword, or to a law or model.
 */
bool aspi_words_misplaced(const aspi_words *words, const char *name);

/* ASP_EARG if two keywords of a list are given. */
asp_code aspi_words_check_one(const aspi_words *words, const char *list);

/* ASP_EARG if the caller's units are not known. */
asp_code aspi_words_check_units(const aspi_words *words, const char *name);

enum { ASPI_LIST_MOST = 1000 }; /* characters of all words that may stand at one place */

/* True if a list of words with blanks between has the word. */
static inline bool aspi_words_in_list(const char *word, const char *list) {
  return aspi_word_index(list, word, strlen(word), true) >= 0;
}

/* A copy from malloc; NULL and a message when out of memory. */
char *aspi_words_copy(const char *text, asp_error *error);

/* The text so far. Characters that do not fit are only counted. */
typedef struct aspi_line {
  char *text;
  size_t size, length;
} aspi_line;

/* The quote that ends a name in quotes; NULL: it has none. A quote within them is doubled. */
const char *aspi_quote_end(const char *begin);

/* Adds a word; a name, in quotes where it would not be one word; the word of that number in a list;
 * a number as it is; a number of some kind, or `fit=START` of an unknown one. */
void aspi_line_word(aspi_line *line, const char *word);
void aspi_line_name(aspi_line *line, const char *name);
void aspi_line_word_of(aspi_line *line, const char *list, int number);
void aspi_line_number(aspi_line *line, double value);
void aspi_line_value(aspi_line *line, const asp_description *d, const char *name, const char *kind,
                     double value);

/* ---- values that are more than a number or a word ---- */

/* How such a value is read and written; NULL: as that of any other keyword. */
typedef struct aspi_form {
  const char *name; /* of the keyword */
  asp_code (*read)(aspi_words *words, const aspi_keyword *keyword);
  void (*write)(aspi_line *line, const asp_description *d, const aspi_keyword *keyword);
  asp_code (*finish)(aspi_words *words); /* after all words within the keyword */
  /* Takes the next parameter of a law, which is no word of the table; false: there is none. */
  bool (*parameter)(aspi_words *words, const aspi_keyword *keyword, asp_code *code);
} aspi_form;

/* The form of a keyword's value. */
const aspi_form *aspi_form_of(const aspi_keyword *keyword);

/* parse.c: lists the words that may follow. The given words need not be complete. True if they may
 * end here, or are not a description. */
bool aspi_description_complete(aspi_completions *completions, int count, const char *const *words);

/* surface.c */
asp_code aspi_lambda_c_read(aspi_words *words, const aspi_keyword *keyword);
void aspi_lambda_c_write(aspi_line *line, const asp_description *d, const aspi_keyword *keyword);
asp_code aspi_lay_read(aspi_words *words, const aspi_keyword *keyword);
void aspi_lay_write(aspi_line *line, const asp_description *d, const aspi_keyword *keyword);
asp_code aspi_slope_read(aspi_words *words, const aspi_keyword *keyword);
asp_code aspi_surface_finish(aspi_words *words);

/* laws.c: a model or a law by name, and the parameters of a law */
asp_code aspi_spread_read(aspi_words *words, const aspi_keyword *keyword);
asp_code aspi_spread_finish(aspi_words *words);
void aspi_spread_write(aspi_line *line, const asp_description *d, const aspi_keyword *keyword);
asp_code aspi_law_read(aspi_words *words, const aspi_keyword *keyword);
bool aspi_law_parameter(aspi_words *words, const aspi_keyword *keyword, asp_code *code);
void aspi_law_write(aspi_line *line, const asp_description *d, const aspi_keyword *keyword);
asp_code aspi_erosion_finish(aspi_words *words);

/* heat.c: the form of a curve, and its numbers or its file */
bool aspi_curve_take(aspi_words *words, const aspi_keyword *keyword, asp_code *code);
void aspi_curve_write(aspi_line *line, const asp_description *d, const aspi_keyword *keyword);

/* materials.c */
asp_code aspi_names_read(aspi_words *words, const aspi_keyword *keyword);
asp_code aspi_names_finish(aspi_words *words);
void aspi_names_write(aspi_line *line, const asp_description *d, const aspi_keyword *keyword);
