/* A text file read as a stream: a line or a word at a time. And the numbers in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity.h"

#include <stdio.h>

/* Opens a file that can be read from its beginning again and again. A pipe is copied to a temporary
 * file first, and so is UTF-16 with a byte-order mark, which becomes UTF-8. `-` is standard input.
 * NULL on error: ASP_EFILE, ASP_ENOMEM. */
FILE *aspi_file_open(const char *path, asp_error *error);

typedef struct aspi_text {
  FILE *stream;
  const char *path; /* for messages */
  size_t line;      /* of the line or word at hand, from 1 */
  char *text;       /* the current line, without its end; in the buffer, for the caller to cut */
  size_t length;
  char *rest; /* of the line: behind the words that were read */
  /* The text read so far: the next line is from `next` (NULL: none) to `end`. */
  char *buffer, *next, *end;
  size_t room;
} aspi_text;

/* A text at the beginning of a stream, to be closed (the stream stays open). */
aspi_text aspi_text_create(FILE *stream, const char *path);
void aspi_text_close(aspi_text *text);

/* Back to the beginning; ASP_EFILE if the stream cannot. */
asp_code aspi_text_rewind(aspi_text *text, asp_error *error);

/* Reads the next line (its end is LF, CR LF or CR; the byte-order mark of UTF-8 is left out);
 * *found is false at the end of the file. ASP_EDATA for a NUL byte. */
asp_code aspi_text_line(aspi_text *text, bool *found, asp_error *error);

/* The next word (between white space), NULL at the end of the file. */
asp_code aspi_text_word(aspi_text *text, char **word, asp_error *error);

/* True if there is nothing but white space. */
bool aspi_text_blank(const char *line);

/* Cuts the next field off a line, in place, without blanks and one pair of quotes around it; NULL
 * at the end. The separator ' ' is any white space, '\\0' none. Quotes hold a field together, and a
 * quote in quotes is written twice. */
char *aspi_text_field(char **next, char separator);

/* Kind of a word: a number, a mark for a missing one (empty, nan, inf, bad, ---, ...), or other
 * text. */
typedef enum aspi_word { ASP_WORD_NUMBER, ASP_WORD_MISSING, ASP_WORD_OTHER } aspi_word;

/* Reads all of a text, blanks around it left out. A comma is a decimal point, or with `thousands`
 * one between groups of three digits; an exponent may begin with D (Fortran). */
aspi_word aspi_text_number(const char *text, bool thousands, double *value);
