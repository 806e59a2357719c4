/* Files that are read, and the lines, words and numbers of a text; see text.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"
#include "base/error.h"
#include "base/number.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Characters of a number. */
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

/* Copies a pipe, or UTF-16 as UTF-8, to a temporary file. */
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
  text->line = 0;
  text->next = text->rest = NULL;
  return ASP_OK;
}

/* Reads up to the next LF, to be cut at CR, too. */
static asp_code read_on(aspi_text *t, asp_error *error) {
  errno = 0;
  ssize_t size = getline(&t->buffer, &t->room, t->stream);
  if (size < 0 && errno == ENOMEM)
    return aspi_fail(error, ASP_ENOMEM, "%.200s:%zu: out of memory for a line", t->path, t->line);
  if (ferror(t->stream))
    return aspi_fail(error, ASP_EFILE, "%s: cannot be read: %s", t->path, strerror(errno));
  size -= size > 0 && t->buffer[size - 1] == '\n';
  t->next = size < 0 ? NULL : t->buffer;
  t->end = t->buffer + size;
  return ASP_OK;
}

asp_code aspi_text_line(aspi_text *t, bool *found, asp_error *error) {
  static const char mark[] = "\xEF\xBB\xBF";
  static char nothing[1];
  t->line++;
  asp_code code = t->next ? ASP_OK : read_on(t, error);
  *found = t->next;
  t->text = t->rest = t->next ? t->next : nothing;
  t->length = 0;
  if (code || !*found)
    return code;
  char *end = memchr(t->text, '\r', (size_t)(t->end - t->text));
  t->next = end && end + 1 < t->end ? end + 1 : NULL;
  end = end ? end : t->end;
  *end = '\0';
  if (t->line == 1 && strncmp(t->text, mark, 3) == 0)
    t->rest = t->text += 3;
  t->length = (size_t)(end - t->text);
  if (memchr(t->text, '\0', t->length))
    return aspi_file_fail(t->path, t->line, error,
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

char *aspi_text_field(char **next, char separator) {
  char *field = *next;
  bool quoted = false, quotes = false;
  while (field && isspace((unsigned char)*field) && (separator == ' ' || *field != separator))
    field++;
  if (!field || (separator == ' ' && !*field))
    return NULL;
  char *end = field;
  for (; *end; end++) {
    quoted ^= *end == '"';
    quotes = quotes || quoted;
    if (!quoted && (separator == ' ' ? isspace((unsigned char)*end) : *end == separator))
      break;
  }
  *next = *end ? end + 1 : NULL;
  while (end > field && isspace((unsigned char)end[-1]))
    end--;
  *end = '\0';
  return quotes ? unquote(field) : field;
}

bool aspi_text_blank(const char *line) {
  return line[strspn(line, " \t\v\f")] == '\0';
}

static bool is_missing(const char *text, size_t length) {
  static const char marks[] = "bad na n/a null #n/a #num! #value! #div/0! void missing - -- --- * "
                              "*** ? none invalid n.a. n.d. nd \xE2\x80\x93 \xE2\x80\x94";
  size_t stars = strspn(text, "*"); /* overflow marks of Fortran */
  return length == 0 || stars == length || aspi_word_index(marks, text, length, false) >= 0;
}

/* Takes the commas out that stand between groups of three digits; false if they do not. */
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
