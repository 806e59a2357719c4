/* The first pass over a table: separator, decimal mark and number of columns, by all of its rows;
 * see table.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/table.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

size_t aspi_table_sign(const char *text) {
  static const char *const signs[] = {"(", "\xC2\xB1", "\xB1", "+-", "+/-"};
  for (size_t i = 0; i < sizeof signs / sizeof *signs; i++)
    if (strncmp(text, signs[i], strlen(signs[i])) == 0)
      return strlen(signs[i]);
  return 0;
}

static const char separators[] = ";\t, ";
enum { SEMICOLON, TAB, COMMA, BLANK, SEPARATORS };

/* Lines of one kind. For each separator: lines that have it between other text, and the most common
 * number of fields, by majority vote (Boyer & Moore 1981). `gaps`: lines with blanks between
 * numbers. Then numbers with one point, with one comma that cannot separate groups of three digits,
 * and with zeros behind it (0,05). */
typedef struct tally {
  size_t lines, gaps, points, decimals, zeros, with[SEPARATORS];
  int fields[SEPARATORS];
  long votes[SEPARATORS];
} tally;

/* A run of digits, points and commas. */
typedef struct run {
  int points, commas, head, tail;
  bool zero; /* the tail begins with one */
} run;

static void end_run(tally *t, run *r, bool quoted) {
  if (r->commas == 1 && r->points == 0 && r->head > 0 && r->tail > 0) {
    t->decimals += r->tail != 3 || r->head > 3;
    t->zeros += r->zero && r->tail > 1 && !quoted;
  }
  t->points += r->points == 1;
  *r = (run){0};
}

static void take_character(run *r, char c) {
  if (c == ',' || c == '.') {
    *(c == ',' ? &r->commas : &r->points) += 1;
    r->head += r->tail;
    r->tail = 0;
  } else {
    r->zero = r->tail == 0 ? c == '0' : r->zero;
    r->tail++;
  }
}

/* Adds a line to those of its kind. */
static void vote(tally *t, const tally *line) {
  t->lines++;
  t->gaps += line->gaps > 0;
  t->points += line->points;
  t->decimals += line->decimals;
  t->zeros += line->zeros;
  for (int k = 0; k < SEPARATORS; k++) {
    t->with[k] += line->with[k] > 0;
    if (t->votes[k] == 0)
      t->fields[k] = line->fields[k];
    t->votes[k] += t->fields[k] == line->fields[k] ? 1 : -1;
  }
}

/* Looks at a line of numbers alone, or of other text with digits in it. */
static void look(tally *numbers, tally *others, const char *c, const char *end) {
  tally line = {.fields = {1, 1, 1, 0}};
  int indent = (int)strspn(c, "\t");
  bool quoted = false, words = false, digits = false, blank = true, joins = false;
  char last = ' ';
  run r = {0};
  for (; c < end; c++) {
    bool is_digit = *c >= '0' && *c <= '9';
    if (is_digit && r.tail > 0) { /* most characters */
      r.tail++;
      continue;
    }
    bool in_run = is_digit || *c == '.' || *c == ',';
    if (in_run)
      take_character(&r, *c);
    if (in_run && !blank && !quoted) {
      line.fields[COMMA] += *c == ',';
      digits = digits || is_digit;
      last = *c;
      continue;
    }
    if (!in_run && r.head + r.tail + r.commas + r.points > 0)
      end_run(&line, &r, quoted);
    quoted ^= *c == '"';
    if (*c == ',' && !quoted)
      line.fields[COMMA]++;
    if (*c == ' ' || *c == '\t' || *c == ';') {
      blank = blank || (*c != ';' && !quoted);
      line.fields[*c == ';' ? SEMICOLON : TAB] += !quoted && *c != ' ';
      continue;
    }
    if (blank) {
      size_t sign = line.fields[BLANK] > 0 ? aspi_table_sign(c) : 0;
      line.fields[BLANK] += sign == 0 && !joins;
      joins = sign > 0 && c[sign] == ' ';
      line.gaps += isdigit((unsigned char)last) && (is_digit || *c == '-' || *c == '.');
    }
    blank = false;
    digits = digits || is_digit;
    if (isalpha((unsigned char)*c) || (unsigned char)*c >= 0x80)
      words = words || !strchr("eEdD", *c) || (!isdigit((unsigned char)last) && last != '.');
    last = *c;
  }
  end_run(&line, &r, quoted);
  for (int k = 0; k < BLANK; k++)
    line.with[k] = (size_t)(line.fields[k] - 1 - (k == TAB ? indent : 0));
  if (digits)
    vote(words ? others : numbers, &line);
}

static void choose(aspi_table *t, const tally *of) {
  int k = 0;
  while (k < BLANK && (2 * of->with[k] < of->lines || of->lines == 0))
    k++;
  bool decimal = of->fields[COMMA] == 2 && of->points == 0 && of->zeros > 0;
  if (k == COMMA && (2 * of->gaps >= of->lines || decimal))
    k = BLANK;
  t->separator = separators[k];
  t->width = 2 * of->votes[k] >= (long)of->lines ? of->fields[k] : 0;
  t->thousands = of->points > 0 && of->decimals == 0;
}

asp_code aspi_table_survey(aspi_table *t, asp_error *error) {
  tally numbers = {.lines = 0}, others = {.lines = 0};
  char forced = '\0'; /* `sep=;`, as spreadsheets understand it */
  bool found = true;
  asp_code code = ASP_OK;
  while (!(code = aspi_text_line(&t->text, &found, error)) && found) {
    const char *c = t->text.text, *end = c + t->text.length;
    const char *first = c + strspn(c, " \t"), *tag = *first == '<' ? strchr(first, '>') : NULL;
    t->tagged = t->tagged || (tag && t->text.line == 1);
    if (t->text.line == 1 && strncasecmp(c, "sep=", 4) == 0)
      forced = c[4];
    if (*first != '#')
      look(&numbers, &others, tag ? tag + 1 : c, end);
  }
  choose(t, numbers.lines >= others.lines ? &numbers : &others);
  if (forced) {
    t->separator = forced;
    t->width = 0;
  }
  return code ? code : aspi_text_rewind(&t->text, error);
}
