/* Files that are read, and the lines, words and numbers of a text; see text.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"
#include "base/error.h"
#include "base/number.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { WORD_MOST = 64 };

static FILE *refuse(const char *path, int reason, asp_error *error) {
  aspi_fail(error, reason == ENOMEM ? ASP_ENOMEM : ASP_EFILE, "cannot open '%.200s': %s", path,
            strerror(reason));
  return NULL;
}

/* Byte order of UTF-16. */
typedef enum order { BYTES, LITTLE, BIG } order;

/* Writes the next character of UTF-16 as UTF-8, half of a surrogate pair as a question mark; false
 * at the end. */
static bool copy_character(FILE *from, FILE *to, order of) {
  int first = getc_unlocked(from), second = getc_unlocked(from);
  if (second == EOF)
    return false;
  int unit = of == LITTLE ? first | second << 8 : first << 8 | second;
  if (unit >= 0xD800 && unit < 0xE000)
    unit = '?';
  if (unit >= 0x800)
    putc(0xE0 | unit >> 12, to);
  if (unit >= 0x80)
    putc(unit < 0x800 ? 0xC0 | unit >> 6 : 0x80 | (unit >> 6 & 0x3F), to);
  putc(unit < 0x80 ? unit : 0x80 | (unit & 0x3F), to);
  return true;
}

/* What is in a pipe, or in UTF-16, as bytes in a temporary file. */
static FILE *copy_of(FILE *from, const char *path, order of, asp_error *error) {
  FILE *copy = tmpfile();
  char block[4096];
  size_t size;
  while (copy && of == BYTES && (size = fread(block, 1, sizeof block, from)) > 0)
    if (fwrite(block, 1, size, copy) != size)
      break;
  while (copy && of != BYTES && copy_character(from, copy, of))
    ;
  if (!copy || ferror(from) || ferror(copy) || fseek(copy, 0, SEEK_SET) != 0) {
    refuse(path, errno, error);
    if (copy)
      fclose(copy);
    copy = NULL;
  }
  fclose(from);
  return copy;
}

FILE *aspi_file_open(const char *path, asp_error *error) {
  struct stat found;
  FILE *stream = strcmp(path, "-") == 0 ? fdopen(dup(STDIN_FILENO), "rb") : fopen(path, "rbe");
  int reason = !stream || fstat(fileno(stream), &found) != 0 ? errno
               : S_ISDIR(found.st_mode)                      ? EISDIR
                                                             : 0;
  if (reason && stream)
    fclose(stream);
  if (reason)
    return refuse(path, reason, error);
  stream = S_ISREG(found.st_mode) ? stream : copy_of(stream, path, BYTES, error);
  if (!stream)
    return NULL;
  char mark[2] = "";
  size_t size = fread(mark, 1, 2, stream);
  order of = size == 2 && memcmp(mark, "\xFF\xFE", 2) == 0   ? LITTLE
             : size == 2 && memcmp(mark, "\xFE\xFF", 2) == 0 ? BIG
                                                             : BYTES;
  rewind(stream);
  return of == BYTES ? stream : copy_of(stream, path, of, error);
}

/* The byte-order mark of UTF-8, which is no text. */
static void skip_mark(FILE *stream) {
  char mark[3];
  if (fread(mark, 1, 3, stream) != 3 || memcmp(mark, "\xEF\xBB\xBF", 3) != 0)
    rewind(stream);
}

aspi_text aspi_text_create(FILE *stream, const char *path) {
  skip_mark(stream);
  return (aspi_text){.stream = stream, .path = path, .line = 0, .next = 1};
}

asp_code aspi_text_rewind(aspi_text *text, asp_error *error) {
  if (fseek(text->stream, 0, SEEK_SET) != 0)
    return aspi_fail(error, ASP_EFILE, "%s: cannot be read twice, as its unequal spacing needs: %s",
                     text->path, strerror(errno));
  skip_mark(text->stream);
  text->line = 0;
  text->next = 1;
  return ASP_OK;
}

asp_code aspi_text_fail(const aspi_text *text, size_t line, asp_error *error, const char *format,
                        ...) {
  char message[320];
  va_list args;
  va_start(args, format);
  aspi_print_list(message, sizeof message, format, args);
  va_end(args);
  return aspi_fail(error, ASP_EDATA, "%.200s:%zu: %s", text->path, line, message);
}

int aspi_text_character(aspi_text *text) {
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

/* Appends a character, or the end (EOF), to a buffer that grows up to `most`. */
static asp_code append(aspi_text *text, char **buffer, size_t *room, size_t most, size_t *length,
                       int c, asp_error *error) {
  size_t need = *length + (c == EOF ? 1 : 2);
  if (c == '\0')
    return aspi_text_fail(text, text->line, error,
                          "a NUL byte: not a text file, or one in UTF-16 without a byte order mark "
                          "(save it as plain text)");
  if (need > most)
    return aspi_text_fail(text, text->line, error, "a %s of %zu characters or more",
                          most == WORD_MOST ? "word" : "line", most);
  if (need > *room) {
    size_t larger = 2 * need < most ? 2 * need : most;
    char *grown = realloc(*buffer, larger);
    if (!grown)
      return aspi_fail(error, ASP_ENOMEM, "%.200s:%zu: out of memory for a line", text->path,
                       text->line);
    *buffer = grown;
    *room = larger;
  }
  (*buffer)[*length] = (char)(c == EOF ? '\0' : c);
  *length += c != EOF;
  if (c == EOF && ferror(text->stream))
    return aspi_fail(error, ASP_EFILE, "%s: cannot be read: %s", text->path, strerror(errno));
  return ASP_OK;
}

asp_code aspi_text_long_line(aspi_text *text, char **line, size_t *room, size_t most, bool *found,
                             asp_error *error) {
  size_t length = 0;
  text->line = text->next;
  int c = aspi_text_character(text);
  *found = c != EOF;
  for (; c != EOF && c != '\n'; c = aspi_text_character(text)) {
    asp_code code = append(text, line, room, most, &length, c, error);
    if (code)
      return code;
  }
  return append(text, line, room, most, &length, EOF, error);
}

asp_code aspi_text_line(aspi_text *text, bool *found, asp_error *error) {
  char *line = text->text;
  size_t room = sizeof text->text;
  return aspi_text_long_line(text, &line, &room, room, found, error);
}

asp_code aspi_text_word(aspi_text *text, bool *found, asp_error *error) {
  char *word = text->text;
  size_t length = 0, room = WORD_MOST;
  int c;
  do {
    text->line = text->next;
    c = aspi_text_character(text);
  } while (c != EOF && isspace(c));
  for (; c != EOF && !isspace(c); c = aspi_text_character(text)) {
    asp_code code = append(text, &word, &room, WORD_MOST, &length, c, error);
    if (code)
      return code;
  }
  *found = length > 0;
  return append(text, &word, &room, WORD_MOST, &length, EOF, error);
}

size_t aspi_text_inside(const char **text) {
  while (isspace((unsigned char)**text))
    ++*text;
  size_t length = strlen(*text);
  while (length > 0 && isspace((unsigned char)(*text)[length - 1]))
    length--;
  return length;
}

char *aspi_text_trim(char *text) {
  const char *first = text;
  size_t length = aspi_text_inside(&first);
  text += first - text;
  text[length] = '\0';
  return text;
}

/* Strips one pair of quotes off a field and halves doubled quotes, in place. */
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

char *aspi_text_field(char **next, char separator) {
  char *field = *next;
  if (field && separator == ' ')
    field += strspn(field, " \t\v\f\r");
  if (!field || (separator == ' ' && !*field))
    return NULL;
  char *end = end_of(field, separator);
  *next = *end ? end + 1 : NULL;
  *end = '\0';
  return unquote(aspi_text_trim(field));
}

int aspi_text_split(char *line, char separator, char *fields[], int most) {
  int count = 0;
  while (count < most && (fields[count] = aspi_text_field(&line, separator)) != NULL)
    count++;
  return count;
}

int aspi_text_names(char *line, char separator, char *names[], int most) {
  while (*line && *line != separator && strchr("#%; \t", *line))
    line++;
  int count = aspi_text_split(line, separator, names, most), kept = 0;
  for (int i = 0; i < count; i++) {
    if (separator == ' ' && kept > 0 && strchr("([{", *names[i])) {
      char *end = names[kept - 1] + strlen(names[kept - 1]);
      memset(end, ' ', (size_t)(names[i] - end));
    } else {
      names[kept++] = names[i];
    }
  }
  return kept;
}

char aspi_text_separator(const char *line) {
  const char *first = strpbrk(line, ";");
  first = first ? first : strpbrk(line, "\t");
  first = first ? first : strpbrk(line, ",");
  return first ? *first : ' ';
}

bool aspi_text_blank(const char *line) {
  return line[strspn(line, " \t\v\f")] == '\0';
}

static bool is_missing(const char *text, size_t length) {
  static const char marks[] = "bad na n/a null #n/a #num! #value! #div/0! void missing - -- --- * "
                              "*** ? none invalid";
  size_t stars = strspn(text, "*"); /* overflow marks of Fortran */
  return length == 0 || stars == length || aspi_word_index(marks, text, length, false) >= 0;
}

/* Converts a number to C's form: an ASCII minus, a decimal point, an exponent with E. */
static bool normalize(char *text) {
  static const char minus[] = "\xE2\x88\x92";
  for (char *at; (at = strstr(text, minus)) != NULL;) {
    *at = '-';
    memmove(at + 1, at + strlen(minus), strlen(at + strlen(minus)) + 1);
  }
  for (char *c = text; *c; c++)
    if ((*c == 'd' || *c == 'D') && c > text && (isdigit((unsigned char)c[-1]) || c[-1] == '.') &&
        (isdigit((unsigned char)c[1]) || c[1] == '+' || c[1] == '-'))
      *c = 'e';
  char *mark = strchr(text, ',');
  if (!mark)
    return true;
  *mark = '.';
  return strchr(text, '.') == mark && !strpbrk(mark + 1, ".,");
}

aspi_word aspi_text_number(const char *text, double *value) {
  size_t length = aspi_text_inside(&text);
  char copy[WORD_MOST], *end;
  *value = NAN;
  if (is_missing(text, length))
    return ASP_WORD_MISSING;
  if (length >= sizeof copy)
    return ASP_WORD_OTHER;
  memcpy(copy, text, length);
  copy[length] = '\0';
  if (!normalize(copy))
    return ASP_WORD_OTHER;
  double read = aspi_number(copy, &end);
  if (end == copy || *end)
    return ASP_WORD_OTHER;
  if (!isfinite(read))
    return ASP_WORD_MISSING;
  *value = read;
  return ASP_WORD_NUMBER;
}
