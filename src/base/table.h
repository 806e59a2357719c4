/* Tables in text files of any kind: a header, rows of numbers and words, and more text. Separator
 * (semicolon, tab, comma, or any white space), decimal mark and number of columns are found from
 * all rows, in a first pass; a first line `sep=;` names the separator. Names are in the last line
 * above the rows, or with a line of units below it, in the last two. Quotes hold a field together,
 * lines that begin with # are comments, blank lines are skipped. A header may also have lines of
 * key and value. The file is read as a stream.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "base/text.h"

/* Plain names have fewer characters. */
enum { ASP_PLAIN_MOST = 80 };

typedef struct aspi_column {
  char name[ASP_PLAIN_MOST]; /* as the file has it */
  /* The name with its unit in small letters, signs and Greek letters written out, all others as
   * single underscores: `α_1 [°]` is alpha_1_deg. */
  char plain[ASP_PLAIN_MOST];
  bool bracketed;
  char unit[16]; /* behind the numbers of its cells, as in `2 um`; "": there is none */
} aspi_column;

typedef struct aspi_table {
  aspi_text text;
  bool owns_stream;
  char separator;
  bool thousands; /* commas stand between groups of digits */
  int width;      /* fields of most rows, 0 if they differ */
  int count, all; /* fields of the current line, without empty ones behind and with them */
  char **fields;
  int room;
  size_t start;  /* line number of the first row; 0: there is none */
  size_t rows;   /* for the caller, who counts the rows he took */
  char *header;  /* its lines, each with LF */
  bool tagged;   /* the first line begins with a tag, as in XML */
  bool nameless; /* the names are "" */
  bool has_row;  /* the current row is not yet taken */
  int columns;   /* names */
  aspi_column *column;
} aspi_table;

/* Opens a table from a stream, or if that is NULL from the file `path`, and reads up to its first
 * row: the first line that begins with `least` numbers (0: has a number anywhere). NULL on error;
 * the message names file and line. */
aspi_table *aspi_table_open(FILE *stream, const char *path, int least, asp_error *error);
void aspi_table_close(aspi_table *table);

/* Finds separator, width and thousands from all rows, and goes back to the beginning. */
asp_code aspi_table_survey(aspi_table *table, asp_error *error);

/* Cuts the next line that is neither blank nor a comment; *found is false at the end. */
asp_code aspi_table_line(aspi_table *table, bool *found, asp_error *error);

/* The same, and ASP_EDATA if the number of fields differs from the number of names. */
asp_code aspi_table_row(aspi_table *table, bool *found, asp_error *error);

/* Length of the sign, or bracket, of an error that belongs to the cell before it, as in `0.52 ±
 * 0.07` and `0.52 (0.07)`, also where blanks separate cells; 0: another text. */
size_t aspi_table_sign(const char *text);

/* ASP_EDATA and a message on the current line. */
#define aspi_table_fail(table, error, ...)                                                         \
  aspi_file_fail((table)->text.path, (table)->text.line, error, __VA_ARGS__)

/* Index of a column by its plain name, or -1; with a message that lists the columns there are. */
int aspi_table_find(const aspi_table *table, const char *name);
int aspi_table_need(const aspi_table *table, const char *name, asp_error *error);

/* The same by a number from 1 to `most`, or by a name as the file has it, or that without its unit.
 */
int aspi_table_asked(const aspi_table *table, const char *asked, int most);

/* Kind and number of a field of the line, which may carry the unit of its column. */
aspi_word aspi_table_field(const aspi_table *table, int column, double *value);

/* The number in a column of the row, least <= value <= most; *missing where it is empty or a mark
 * for a missing value. Column -1 is always missing. With `missing` NULL there must be a number. */
asp_code aspi_table_number(const aspi_table *table, int column, double least, double most,
                           double *value, bool *missing, asp_error *error);

/* The value behind one of the keys (with | between) in the header: `Width: 100 um`, `Teilung;0,5
 * um`, `<SPACING>0.25</SPACING>`; NULL if there is none. Up to the end of a line. */
const char *aspi_table_value(const aspi_table *table, const char *keys);

/* Names and signs as plain text. */
void aspi_plain(const char *name, char *to, size_t size);

/* ---- inside the room ---- */

/* Names from the last line above the first row, of which the fields are counted, or the last two,
 * of which the second has their units. */
asp_code aspi_table_parse_names(aspi_table *table, int least, asp_error *error);

/* The unit behind a number, as in `2 um`; "": there is none. */
const char *aspi_cell_unit(const char *field);

asp_code aspi_table_no_memory(const aspi_table *table, asp_error *error);
