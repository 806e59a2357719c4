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

/* Characters of a number, of the buffer at first, and of a line. */
enum { WORD_MOST = 64, ROOM_FIRST = 1 << 16, LINE_MOST = 1 << 26 };

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

aspi_text aspi_text_create(FILE *stream, const char *path) {
  return (aspi_text){.stream = stream, .path = path};
}

void aspi_text_close(aspi_text *text) {
  free(text->buffer);
}

asp_code aspi_text_rewind(aspi_text *text, asp_error *error) {
  if (fseek(text->stream, 0, SEEK_SET) != 0)
    return aspi_fail(error, ASP_EFILE, "%s: cannot be read twice: %s", text->path, strerror(errno));
  text->line = text->from = text->to = 0;
  text->rest = NULL;
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

/* Reads more of the stream behind what is in the buffer; *more is false at its end. */
static asp_code fill(aspi_text *t, bool *more, asp_error *error) {
  t->to -= t->from;
  if (t->from > 0)
    memmove(t->buffer, t->buffer + t->from, t->to);
  t->from = 0;
  if (t->to == t->room) {
    size_t room = t->room ? 2 * t->room : ROOM_FIRST;
    if (room > LINE_MOST)
      return aspi_text_fail(t, t->line, error, "a line of %zu characters or more", t->room);
    char *grown = realloc(t->buffer, room + 1); /* and the end of the last line */
    if (!grown)
      return aspi_fail(error, ASP_ENOMEM, "%.200s:%zu: out of memory for a line", t->path, t->line);
    t->buffer = grown;
    t->room = room;
  }
  size_t got = fread(t->buffer + t->to, 1, t->room - t->to, t->stream);
  t->to += got;
  *more = got > 0;
  if (ferror(t->stream))
    return aspi_fail(error, ASP_EFILE, "%s: cannot be read: %s", t->path, strerror(errno));
  return ASP_OK;
}

size_t aspi_text_bytes(aspi_text *t, void *to, size_t size) {
  size_t have = t->to - t->from < size ? t->to - t->from : size;
  if (have > 0)
    memcpy(to, t->buffer + t->from, have);
  t->from += have;
  return have + fread((char *)to + have, 1, size - have, t->stream);
}

asp_code aspi_text_line(aspi_text *t, bool *found, asp_error *error) {
  static const char mark[] = "\xEF\xBB\xBF";
  char *end = NULL;
  bool more = true;
  t->line++;
  for (size_t seen = 0; !end && more;) {
    size_t have = t->to - t->from;
    if (have > seen && !(end = memchr(t->buffer + t->from + seen, '\n', have - seen)) && have > 1)
      end = memchr(t->buffer + t->from + seen, '\r', have - seen - 1);
    seen = have > 0 ? have - 1 : 0;
    asp_code code = end ? ASP_OK : fill(t, &more, error);
    if (code)
      return code;
  }
  char *start = t->text = t->buffer + t->from;
  *found = t->from < t->to;
  end = end ? end : t->buffer + t->to;
  char *other = end > start ? memchr(start, '\r', (size_t)(end - start)) : NULL;
  end = other ? other : end;
  t->from = (size_t)(end - t->buffer) + (end < t->buffer + t->to);
  if (other && t->from < t->to && t->buffer[t->from] == '\n')
    t->from++;
  if (t->line == 1 && end - start >= 3 && memcmp(start, mark, 3) == 0)
    t->text += 3;
  t->length = (size_t)(end - t->text);
  *end = '\0';
  t->rest = t->text;
  if (memchr(t->text, '\0', t->length))
    return aspi_text_fail(t, t->line, error,
                          "a NUL byte: not a text file, or one in UTF-16 without a byte order mark "
                          "(save it as plain text)");
  return ASP_OK;
}

asp_code aspi_text_word(aspi_text *t, char **word, asp_error *error) {
  bool found = true;
  while (found && (!t->rest || !(*word = aspi_text_field(&t->rest, ' ')))) {
    asp_code code = aspi_text_line(t, &found, error);
    if (code)
      return code;
  }
  *word = found ? *word : NULL;
  return ASP_OK;
}

char *aspi_text_trim(char *text) {
  while (isspace((unsigned char)*text))
    text++;
  size_t length = strlen(text);
  while (length > 0 && isspace((unsigned char)text[length - 1]))
    length--;
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

bool aspi_text_blank(const char *line) {
  return line[strspn(line, " \t\v\f")] == '\0';
}

static bool is_missing(const char *text, size_t length) {
  static const char marks[] = "bad na n/a null #n/a #num! #value! #div/0! void missing - -- --- * "
                              "*** ? none invalid";
  size_t stars = strspn(text, "*"); /* overflow marks of Fortran */
  return length == 0 || stars == length || aspi_word_index(marks, text, length, false) >= 0;
}

/* Takes the commas out that stand between groups of three digits; false where they do not. */
static bool join_thousands(char *text) {
  size_t first = strspn(text += *text == '-' || *text == '+', "0123456789");
  bool good = first > 0 && first <= 3;
  for (char *comma = text + first; good && *comma == ',';) {
    good = strspn(comma + 1, "0123456789") == 3;
    memmove(comma, comma + 1, strlen(comma));
    comma += good ? 3 : 0;
  }
  return good && !strchr(text, ',');
}

/* Converts a number to C's form: an ASCII minus, a decimal point, an exponent with E. */
static bool normalize(char *text, bool thousands) {
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
  if (!mark || thousands)
    return !mark || join_thousands(text);
  *mark = '.';
  return strchr(text, '.') == mark && !strpbrk(mark + 1, ".,");
}

aspi_word aspi_text_number(const char *text, bool thousands, double *value) {
  if (aspi_number_read(text, thousands ? '.' : ',', value))
    return ASP_WORD_NUMBER;
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
  if (!normalize(copy, thousands))
    return ASP_WORD_OTHER;
  double read = aspi_number(copy, &end);
  if (end == copy || *end)
    return ASP_WORD_OTHER;
  if (!isfinite(read))
    return ASP_WORD_MISSING;
  *value = read;
  return ASP_WORD_NUMBER;
}
