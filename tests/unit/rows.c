/* The rows of a test in a table of data/; see check.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"

#include <stdlib.h>

/* Takes off the spaces at both ends, and puts the bytes that are meant by \n, \r, \t and \xNN. */
static char *field_of(char *text) {
  static const char names[] = "nrt", bytes[] = "\n\r\t";
  text += strspn(text, " ");
  size_t length = strlen(text);
  while (length && text[length - 1] == ' ')
    text[--length] = '\0';
  char *to = text;
  for (const char *at = text; *at; at++) {
    unsigned byte = (unsigned char)*at;
    if (byte == '\\') {
      assert_int_not_equal(*++at, '\0');
      const char *name = strchr(names, *at);
      if (name)
        byte = (unsigned char)bytes[name - names];
      else
        assert_int_equal(sscanf(at++, "x%2x", &byte), 1);
      at += !name;
    }
    *to++ = (char)byte;
  }
  *to = '\0';
  return text;
}

static char row[2000]; /* that is checked */

int tell_row(void **state) {
  (void)state;
  if (*row)
    print_error("in the row: %s\n", row);
  *row = '\0';
  return 0;
}

void each_row(const char *table, const char *section, void (*check)(char *fields[FIELDS])) {
  char path[1000], line[2000];
  const size_t length = strlen(section);
  int rows = 0;
  bool within = false;
  snprintf(path, sizeof path, "%s/%s", getenv("ASPERITY_TEST_DATA"), table);
  FILE *file = fopen(path, "r");
  if (!file)
    fail_msg("no %s", path);
  while (fgets(line, sizeof line, file)) {
    line[strcspn(line, "\n")] = '\0';
    if (*line == '[')
      within = strncmp(line + 1, section, length) == 0 && line[1 + length] == ']';
    else if (within && *line) {
      char *fields[FIELDS], none[] = "", *rest = line;
      strcpy(row, line);
      for (int i = 0; i < FIELDS; i++) {
        char *next = rest ? strchr(rest, '@') : NULL;
        if (next)
          *next++ = '\0';
        fields[i] = rest ? field_of(rest) : none;
        rest = next;
      }
      if (rest)
        fail_msg("%s of %s has more fields than are read", fields[0], section);
      check(fields);
      rows++;
    }
  }
  fclose(file);
  *row = '\0';
  if (!rows)
    fail_msg("%s has no rows of %s", path, section);
}
