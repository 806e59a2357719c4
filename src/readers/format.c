/* Detects the format of a measured file by its first bytes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "readers/read.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

/* Formats of instruments that are closed, or that others read better. */
static const struct {
  const char *begins, *name;
} closed[] = {{"DIGITAL SURF", "Digital Surf SUR"},
              {"DSCOMPRESSED", "Digital Surf SUR"},
              {"PK\x03\x04", "a zip (X3P, PLUX, VK6, OPDx, or of a spreadsheet)"},
              {"VK3_", "Keyence VK3"},
              {"VK4_", "Keyence VK4"},
              {"\x01\x1b", "MetroPro"},
              {"GWYP", "Gwyddion's own"},
              {"\x89HDF", "HDF5"}};

asp_code aspi_format_find(aspi_text *text, aspi_format *format, asp_error *error) {
  char begin[40] = "", *first = begin;
  aspi_text_bytes(text, begin, sizeof begin - 1);
  asp_code code = aspi_text_rewind(text, error);
  first += strncmp(begin, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
  first += strspn(first, " \t\r\n");
  for (size_t i = 0; i < sizeof closed / sizeof *closed && !code; i++)
    if (strncmp(first, closed[i].begins, strlen(closed[i].begins)) == 0)
      code =
          aspi_fail(error, ASP_EDATA,
                    "%.200s: the format is %s, which is not read here; the free program Gwyddion "
                    "(gwyddion.net) opens that of an instrument, and saves it as SDF or as text",
                    text->path, closed[i].name);
  bool sdf =
      *first && (strncasecmp(first + 1, "ISO-", 4) == 0 || strncasecmp(first + 1, "BCR-", 4) == 0);
  *format = !sdf                                    ? ASP_FORMAT_TEXT
            : tolower((unsigned char)*first) == 'b' ? ASP_FORMAT_SDF_BINARY
                                                    : ASP_FORMAT_SDF_TEXT;
  return code;
}
