/* Detects the format of a measured file by its first bytes. The signatures of closed formats are
 * those of public files.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "readers/read.h"

#include <string.h>
#include <strings.h>

#define GWYDDION                                                                                   \
  "; the free program Gwyddion (gwyddion.net) opens that of an instrument, and saves it as text"

/* Formats that are not read here, and what to do. */
static const struct {
  const char *begins;
  size_t length;
  const char *name, *way;
} others[] = {{"DSCOMPRESSED", 12, "Digital Surf SUR, compressed", GWYDDION},
              {"VK3_", 4, "Keyence VK3", GWYDDION},
              {"VK4_", 4, "Keyence VK4", GWYDDION},
              {"VK6", 3, "Keyence VK6", GWYDDION},
              {"\x88\x1b\x03\x6f", 4, "MetroPro", GWYDDION},
              {"\x88\x1b\x03\x70", 4, "MetroPro", GWYDDION},
              {"\x88\x1b\x03\x71", 4, "MetroPro", GWYDDION},
              {"AliconaImaging", 14, "Alicona AL3D", GWYDDION},
              {"FRTM_GLIDERV1.00", 16, "FRT MicroProf", GWYDDION},
              {"\\*File list", 11, "Bruker (Veeco) Nanoscope", GWYDDION},
              {"\\*Force file list", 17, "Bruker (Veeco) Nanoscope", GWYDDION},
              {"Binary TrueMap", 14, "TrueMap TMD", GWYDDION},
              {"WSxM file", 9, "Nanotec WSxM", GWYDDION},
              {"\x01\0Directory", 11, "Wyko (Veeco) OPD", GWYDDION},
              {"Zygo XYZ Data File", 18, "text of Zygo's XYZ", GWYDDION},
              {"GWYP", 4, "Gwyddion's own", GWYDDION},
              {"\x89HDF", 4, "HDF5", "; save its heights as text"},
              {"\x93NUMPY", 6, "NumPy", "; save it as text, numpy.savetxt"},
              {"\xd0\xcf\x11\xe0", 4, "Mountains or an old Excel",
               "; save a spreadsheet as CSV, and a surface as SUR or text"},
              {"\x1f\x8b", 2, "gzip", "; unpack it first: gunzip"}};

/* A date and then zeros. */
static bool is_sensofar(const char *begin) {
  return strlen(begin) == 24 && begin[3] == ' ' && begin[13] == ':' && begin[16] == ':';
}

asp_code aspi_format_find(aspi_text *text, aspi_format *format, asp_error *error) {
  char begin[128] = "", *first = begin;
  const char *name = NULL, *way = GWYDDION;
  size_t size = fread(begin, 1, sizeof begin - 1, text->stream);
  asp_code code = aspi_text_rewind(text, error);
  for (size_t i = 0; i < sizeof others / sizeof *others && !name; i++)
    if (size >= others[i].length && memcmp(begin, others[i].begins, others[i].length) == 0) {
      name = others[i].name;
      way = others[i].way;
    }
  name = !name && size > 24 && is_sensofar(begin) ? "Sensofar PLU" : name;
  if (name && !code && !strstr(begin, "ASCII")) /* as WSxM begins its text, too */
    return aspi_file_fail(text->path, 0, error, "%s%s%s",
                          strncmp(name, "text ", 5) == 0 ? "" : "binary, of ", name, way);
  first += strncmp(begin, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
  first += strspn(first, " \t\r\n");
  bool sdf =
      *first && (strncasecmp(first + 1, "ISO-", 4) == 0 || strncasecmp(first + 1, "BCR-", 4) == 0);
  *format = sdf && (*first == 'b' || *first == 'B')   ? ASP_FORMAT_SDF_BINARY
            : sdf                                     ? ASP_FORMAT_SDF_TEXT
            : strncmp(first, "DIGITAL SURF", 12) == 0 ? ASP_FORMAT_SUR
            : strncmp(first, "PK\x03\x04", 4) == 0    ? ASP_FORMAT_ZIP
                                                      : ASP_FORMAT_TEXT;
  return code;
}
