/* A text file read as a stream: one line or one word at a time, never more of it in memory.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_BASE_TEXT_H
#define ASP_BASE_TEXT_H

#include "asperity.h"

#include <stdio.h>

enum { ASP_TEXT_MOST = 4096 };

/* Opens a file to be read, from its beginning and as often as is wanted: what a pipe holds, or
 * UTF-16 with a byte-order mark, which becomes UTF-8, is copied to a temporary file first. `-` is
 * standard input. NULL on error: ASP_EFILE, ASP_ENOMEM. */
FILE *aspi_file_open(const char *path, asp_error *error);

typedef struct aspi_text {
  FILE *stream;
  const char *path;         /* for messages */
  size_t line;              /* of the line or word in `text`, from 1 */
  size_t next;              /* of the next character */
  char text[ASP_TEXT_MOST]; /* without its end */
} aspi_text;

aspi_text aspi_text_create(FILE *stream, const char *path);

/* Back to the beginning; ASP_EFILE where the stream cannot. */
asp_code aspi_text_rewind(aspi_text *text, asp_error *error);

/* The next character, or EOF; every end of a line is LF. */
int aspi_text_character(aspi_text *text);

/* Reads the next line (its end is LF, CR LF or CR; the byte-order mark of UTF-8 is left out) or
 * word (between white space). *found is false at the end of the file. ASP_EDATA for a NUL byte, a
 * line of 4096 characters or more, or a word of 64 or more. */
asp_code aspi_text_line(aspi_text *text, bool *found, asp_error *error);
asp_code aspi_text_word(aspi_text *text, bool *found, asp_error *error);

/* Like aspi_text_line, into a buffer of *room characters that grows up to `most` by realloc. */
asp_code aspi_text_long_line(aspi_text *text, char **line, size_t *room, size_t most, bool *found,
                             asp_error *error);

/* True if there is nothing but white space. */
bool aspi_text_blank(const char *line);

/* Moves past the blanks before a text; its length without those behind it. */
size_t aspi_text_inside(const char **text);

/* A text without the blanks at both ends; in place. */
char *aspi_text_trim(char *text);

/* The separator of a line's fields: the first of ; tab , in this order that it has, or a blank for
 * runs of white space. */
char aspi_text_separator(const char *line);

/* Cuts the next field off a line, in place, without blanks and one pair of quotes around it; NULL
 * at the end. Quotes hold a field together, and a quote in quotes is written twice. */
char *aspi_text_field(char **next, char separator);

/* Cuts a line into at most `most` fields; the number of fields. */
int aspi_text_split(char *line, char separator, char *fields[], int most);

/* Splits a line of names, without the marks of a comment before it. Where blanks separate
 * them, a unit in brackets belongs to the name before it. */
int aspi_text_names(char *line, char separator, char *names[], int most);

/* ASP_EDATA and "<path>:<line>: <message>". */
#if defined(__GNUC__)
__attribute__((format(printf, 4, 5)))
#endif
asp_code
aspi_text_fail(const aspi_text *text, size_t line, asp_error *error, const char *format, ...);

/* Kind of a word: a number, a mark for a missing one (empty, nan, inf, bad, ---, ...), or other
 * text. */
typedef enum aspi_word { ASP_WORD_NUMBER, ASP_WORD_MISSING, ASP_WORD_OTHER } aspi_word;

/* Reads all of a text, blanks around it left out. A comma is a decimal point; an exponent may begin
 * with D (Fortran). */
aspi_word aspi_text_number(const char *text, double *value);

#endif
