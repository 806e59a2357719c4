/* Lines, words and numbers of a text file; see text.h. */
#include "base/text.h"
#include "base/error.h"
#include "base/number.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { WORD_MOST = 64 };

aspi_text aspi_text_create(FILE *stream, const char *path) {
  return (aspi_text){.stream = stream, .path = path, .line = 0, .next = 1};
}

asp_code aspi_text_rewind(aspi_text *text, asp_error *error) {
  if (fseek(text->stream, 0, SEEK_SET) != 0)
    return aspi_fail(error, ASP_EFILE, "%s: cannot be read twice, as its unequal spacing needs: %s",
                     text->path, strerror(errno));
  text->line = 0;
  text->next = 1;
  return ASP_OK;
}

asp_code aspi_text_fail(const aspi_text *text, size_t line, asp_error *error, const char *format,
                        ...) {
  char message[320];
  va_list args;
  va_start(args, format);
  vsnprintf(message, sizeof message, format, args);
  va_end(args);
  return aspi_fail(error, ASP_EDATA, "%.200s:%zu: %s", text->path, line, message);
}

/* The next character, or EOF. CR LF and CR come out as LF. */
static int next_character(aspi_text *text) {
  int c = getc_unlocked(text->stream);
  if (c == '\r') {
    int after = getc_unlocked(text->stream);
    if (after != '\n' && after != EOF)
      ungetc(after, text->stream);
    c = '\n';
  }
  if (c == '\n')
    text->next++;
  return c;
}

static asp_code append(aspi_text *text, size_t *length, size_t most, int c, asp_error *error) {
  if (c == '\0')
    return aspi_text_fail(text, text->line, error,
                          "a NUL byte: not a text file, or one in UTF-16 (save it as plain text)");
  if (*length + 1 >= most)
    return aspi_text_fail(text, text->line, error, "a %s of %zu characters or more",
                          most == WORD_MOST ? "word" : "line", most);
  text->text[(*length)++] = (char)c;
  return ASP_OK;
}

static asp_code finish(aspi_text *text, size_t length, bool found_any, bool *found,
                       asp_error *error) {
  text->text[length] = '\0';
  *found = found_any;
  if (ferror(text->stream))
    return aspi_fail(error, ASP_EFILE, "%s: cannot be read: %s", text->path, strerror(errno));
  return ASP_OK;
}

asp_code aspi_text_line(aspi_text *text, bool *found, asp_error *error) {
  size_t length = 0;
  text->line = text->next;
  int c = next_character(text);
  bool any = c != EOF;
  for (; c != EOF && c != '\n'; c = next_character(text)) {
    asp_code code = append(text, &length, ASP_TEXT_MOST, c, error);
    if (code)
      return code;
  }
  return finish(text, length, any, found, error);
}

asp_code aspi_text_word(aspi_text *text, bool *found, asp_error *error) {
  size_t length = 0;
  int c;
  do {
    text->line = text->next;
    c = next_character(text);
  } while (c != EOF && isspace(c));
  for (; c != EOF && !isspace(c); c = next_character(text)) {
    asp_code code = append(text, &length, WORD_MOST, c, error);
    if (code)
      return code;
  }
  return finish(text, length, length > 0, found, error);
}

char *aspi_text_trim(char *text) {
  while (isspace((unsigned char)*text))
    text++;
  size_t length = strlen(text);
  while (length > 0 && isspace((unsigned char)text[length - 1]))
    text[--length] = '\0';
  return text;
}

/* One pair of quotes off a field, and doubled quotes undoubled; in place. */
static char *unquote(char *field) {
  size_t length = strlen(field);
  if (length < 2 || field[0] != '"' || field[length - 1] != '"')
    return field;
  field[length - 1] = '\0';
  char *out = ++field;
  for (const char *in = field; *in; in++) {
    *out++ = *in;
    in += in[0] == '"' && in[1] == '"';
  }
  *out = '\0';
  return field;
}

/* The end of the field that begins here: a separator outside quotes, or the end of the line. */
static char *end_of(char *field, char separator) {
  bool quoted = false;
  for (; *field; field++) {
    quoted ^= *field == '"';
    if (!quoted && (separator == ' ' ? isspace((unsigned char)*field) : *field == separator))
      break;
  }
  return field;
}

int aspi_text_split(char *line, char separator, char *fields[], int most) {
  int count = 0;
  for (char *next = line; count < most;) {
    if (separator == ' ')
      next += strspn(next, " \t");
    if (separator == ' ' && !*next)
      break;
    char *end = end_of(next, separator);
    bool last = !*end;
    *end = '\0';
    fields[count++] = unquote(aspi_text_trim(next));
    if (last)
      break;
    next = end + 1;
  }
  return count;
}

static bool is_missing(const char *text, size_t length) {
  static const char *const marks[] = {"bad", "na",  "n/a", "null", "#n/a", "void", "missing", "-",
                                      "--",  "---", "*",   "***",  "?",    "none", "invalid"};
  for (size_t i = 0; i < sizeof marks / sizeof *marks; i++)
    if (strlen(marks[i]) == length && strncasecmp(text, marks[i], length) == 0)
      return true;
  return length == 0;
}

aspi_word aspi_text_number(const char *text, bool comma, double *value) {
  while (isspace((unsigned char)*text))
    text++;
  size_t length = strlen(text);
  while (length > 0 && isspace((unsigned char)text[length - 1]))
    length--;
  char copy[WORD_MOST], *end;
  *value = NAN;
  if (is_missing(text, length))
    return ASP_WORD_MISSING;
  if (length >= sizeof copy)
    return ASP_WORD_OTHER;
  memcpy(copy, text, length);
  copy[length] = '\0';
  for (char *c = copy; comma && (c = strchr(c, ',')) != NULL;)
    *c = '.';
  double read = aspi_number(copy, &end);
  if (end != copy + length)
    return ASP_WORD_OTHER;
  if (!isfinite(read))
    return ASP_WORD_MISSING;
  *value = read;
  return ASP_WORD_NUMBER;
}
