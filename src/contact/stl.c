/* Reads STL files; see stl.h. A text and a binary file may both begin with the word `solid`: a file
 * is binary if its length fits its number of triangles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/stl.h"
#include "base/error.h"
#include "base/number.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/types.h>

enum { HEAD = 84, RECORD = 50, NORMAL = 12, MOST = INT_MAX / 2 };

typedef struct Stl {
  const char *path;
  FILE *file;
  aspi_stl_taker *take;
  void *to;
  asp_error *error;
  char *line; /* of a text, with one blank between words and none at its ends */
  size_t room, triangles;
  int number; /* of the line */
  ContactTriangle triangle;
} Stl;

static asp_code fail(const Stl *s, const char *must) {
  return aspi_fail(s->error, ASP_EDATA,
                   "STL file '%.200s', line %d: it says '%.80s'; it must be %s", s->path, s->number,
                   s->line, must);
}

static asp_code fail_to_read(const Stl *s) {
  return aspi_fail(s->error, ASP_EFILE, "STL file '%.200s' cannot be read: %s", s->path,
                   strerror(errno));
}

static asp_code give(Stl *s) {
  if (++s->triangles > MOST)
    return aspi_fail(s->error, ASP_EDATA,
                     "STL file '%.200s' has more than %d triangles; it must have fewer", s->path,
                     MOST);
  return s->take(s->to, &s->triangle)
             ? ASP_OK
             : aspi_fail(s->error, ASP_ENOMEM, "out of memory for the STL file '%.200s'", s->path);
}

/* Little-endian, whatever the machine is. */
static uint32_t number_at(const unsigned char *at) {
  return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static asp_code read_binary(Stl *s, size_t count) {
  unsigned char record[RECORD];
  asp_code code = ASP_OK;
  while (!code && s->triangles < count && fread(record, RECORD, 1, s->file) == 1) {
    for (int k = 0; k < 9; k++) {
      const uint32_t bits = number_at(record + NORMAL + 4 * k);
      float value;
      memcpy(&value, &bits, sizeof value);
      if (!isfinite(value))
        return aspi_fail(s->error, ASP_EDATA,
                         "STL file '%.200s', triangle %zu: a coordinate is %g; it must be finite",
                         s->path, s->triangles + 1, (double)value);
      s->triangle.node[k / 3][k % 3] = (double)value;
    }
    code = give(s);
  }
  return code;
}

/* ---- text ---- */

/* True if the line begins with these words, in small letters or large. */
static bool is(const Stl *s, const char *words) {
  const char *line = s->line;
  while (*words && tolower((unsigned char)*line) == *words)
    line++, words++;
  return !*words && (!*line || *line == ' ');
}

/* The next line that is neither blank nor a color; false at the end of the file. `end loop` becomes
 * `endloop`. */
static bool read_line(Stl *s) {
  while (getline(&s->line, &s->room, s->file) >= 0) {
    char *to = s->line;
    s->number++;
    for (const char *from = s->line; *from; from++)
      if (!isspace((unsigned char)*from))
        *to++ = *from;
      else if (to > s->line && to[-1] != ' ')
        *to++ = ' ';
    to -= to > s->line && to[-1] == ' ';
    *to = '\0';
    if (is(s, "end loop") || is(s, "end facet") || is(s, "end solid"))
      memmove(s->line + 3, s->line + 4, strlen(s->line + 3));
    if (*s->line && !is(s, "color"))
      return true;
  }
  return false;
}

/* The next line of a part of the text. */
static asp_code next(Stl *s, const char *part) {
  if (read_line(s))
    return ASP_OK;
  return ferror(s->file)
             ? fail_to_read(s)
             : aspi_fail(s->error, ASP_EDATA,
                         "STL file '%.200s' ends at line %d within a %s; it must end with "
                         "'endsolid'",
                         s->path, s->number, part);
}

static asp_code read_vertex(Stl *s, double node[3]) {
  const char *at = s->line + strlen("vertex");
  bool good = true;
  for (int d = 0; d < 3 && good; d++) {
    char *end;
    good = *at == ' ';
    if (!good)
      continue;
    node[d] = aspi_number(at + 1, &end);
    good = end > at + 1 && (!*end || *end == ' ') && isfinite(node[d]);
    at = end;
  }
  return good && !*at ? ASP_OK : fail(s, "'vertex X Y Z' of finite numbers");
}

static asp_code read_facet(Stl *s) {
  static const char *const lines[][2] = {{"outer loop", "'outer loop'"},
                                         {"vertex", "the facet's vertex 1 of 3, 'vertex X Y Z'"},
                                         {"vertex", "the facet's vertex 2 of 3, 'vertex X Y Z'"},
                                         {"vertex", "the facet's vertex 3 of 3, 'vertex X Y Z'"},
                                         {"endloop", "'endloop'"},
                                         {"endfacet", "'endfacet'"}};
  asp_code code = is(s, "facet") ? ASP_OK : fail(s, "'facet normal X Y Z' or 'endsolid'");
  for (int k = 0; k < 6 && !code; k++) {
    code = next(s, "facet");
    if (!code && !is(s, lines[k][0]))
      code = fail(s, lines[k][1]);
    if (!code && k >= 1 && k <= 3)
      code = read_vertex(s, s->triangle.node[k - 1]);
  }
  return code ? code : give(s);
}

static asp_code read_text(Stl *s) {
  asp_code code = ASP_OK;
  while (!code && read_line(s)) {
    if (!is(s, "solid"))
      return fail(s, "'solid NAME', with which a text begins");
    while (!(code = next(s, "solid")) && !is(s, "endsolid") && !(code = read_facet(s)))
      ;
  }
  return code;
}

static asp_code read_any(Stl *s) {
  unsigned char head[HEAD + 1] = "";
  const bool has_head = fread(head, HEAD, 1, s->file) == 1;
  if (ferror(s->file) || fseeko(s->file, 0, SEEK_END) != 0)
    return fail_to_read(s);
  const double length = (double)ftello(s->file);
  const size_t count = has_head ? number_at(head + HEAD - 4) : 0;
  const double bytes = HEAD + RECORD * (double)count;
  const bool binary = has_head && !(bytes > length) && !(bytes < length);
  if (fseeko(s->file, binary ? HEAD : 0, SEEK_SET) != 0)
    return fail_to_read(s);
  if (binary)
    return read_binary(s, count);
  const size_t blanks = has_head ? strspn((const char *)head, " \t\r\n") : 0;
  if (has_head && strncasecmp((const char *)head + blanks, "solid", 5) != 0)
    return aspi_fail(s->error, ASP_EDATA,
                     "STL file '%.200s' is no text that begins with 'solid', and has %.0f bytes; a "
                     "binary one of %zu triangles, as it says, must have %.0f",
                     s->path, length, count, bytes);
  return read_text(s);
}

asp_code aspi_stl_read(const char *path, aspi_stl_taker *take, void *to, asp_error *error) {
  Stl s = {.path = path, .take = take, .to = to, .error = error, .file = fopen(path, "rb")};
  if (!s.file)
    return fail_to_read(&s);
  asp_code code = read_any(&s);
  if (!code && ferror(s.file))
    code = fail_to_read(&s);
  if (!code && s.triangles == 0)
    code = aspi_fail(error, ASP_EDATA,
                     "STL file '%.200s' has no triangles; it must have one or more", path);
  fclose(s.file);
  free(s.line);
  return code;
}
