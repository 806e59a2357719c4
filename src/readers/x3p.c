/* X3P (ISO 25178-72): a zip of main.xml, which describes the grid, and of its heights in binary;
 * small ones may be in main.xml. Lengths are in m. Read by libzip and expat where they were found
 * when this was built.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "readers/grid.h"

#ifdef ASPI_X3P

#include <expat.h>
#include <math.h>
#include <string.h>
#include <unistd.h>
#include <zip.h>

/* A file. Heights in main.xml are copied to `heights` as text. */
typedef struct x3p {
  char at[200], text[300]; /* the path of the current element, and its text */
  char data[200], valid[200], x_axis[8], z_axis[8], z_type[8];
  aspi_height_grid grid;
  double offset, layers;
  FILE *heights;
  bool in_xml;
} x3p;

static void XMLCALL begin_element(void *user, const char *name, const char **attributes) {
  x3p *x = user;
  (void)attributes;
  aspi_append(x->at, sizeof x->at, "/%s", name);
  *x->text = '\0';
}

static void XMLCALL add_text(void *user, const char *text, int length) {
  x3p *x = user;
  aspi_append(x->text, sizeof x->text, "%.*s", length, text);
}

static void XMLCALL end_element(void *user, const char *name) {
  x3p *x = user;
  const struct {
    const char *at;
    double *number;
    char *word;
    size_t size;
  } keys[] = {{"/CX/Increment", &x->grid.x_scale, NULL, 0},
              {"/CY/Increment", &x->grid.y_scale, NULL, 0},
              {"/CZ/Increment", &x->grid.z_scale, NULL, 0},
              {"/CZ/Offset", &x->offset, NULL, 0},
              {"/SizeZ", &x->layers, NULL, 0},
              {"/CX/AxisType", NULL, x->x_axis, sizeof x->x_axis},
              {"/CZ/AxisType", NULL, x->z_axis, sizeof x->z_axis},
              {"/CZ/DataType", NULL, x->z_type, sizeof x->z_type},
              {"/SizeX", &x->grid.points, NULL, 0},
              {"/SizeY", &x->grid.profiles, NULL, 0},
              {"/ListDimension", &x->grid.points, NULL, 0},
              {"/PointDataLink", NULL, x->data, sizeof x->data},
              {"/ValidPointsLink", NULL, x->valid, sizeof x->valid}};
  char *rest = x->text, *text = aspi_text_field(&rest, '\0');
  size_t end = strlen(x->at), own = strlen(name) + 1;
  for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
    size_t length = strlen(keys[i].at);
    if (end < length || strcmp(x->at + end - length, keys[i].at) != 0)
      continue;
    if (keys[i].number && *text) /* nothing: the default */
      aspi_text_number(text, false, keys[i].number);
    else
      snprintf(keys[i].word, keys[i].size, "%s", text);
  }
  if (strcmp(name, "Datum") == 0) { /* x;y;z or z, or nothing where it is missing */
    const char *z = strrchr(text, ';');
    z = z ? z + 1 : text;
    if (*x->x_axis == 'A')
      fprintf(x->heights, "%.*s;", (int)strcspn(text, ";"), text);
    fprintf(x->heights, "%s\n", *z ? z : "nan");
    x->in_xml = true;
  }
  x->at[end >= own ? end - own : 0] = '\0';
  *x->text = '\0';
}

/* A file of the archive with this name, in any folder but that of macOS; NULL: there is none. */
static zip_file_t *find(zip_t *archive, const char *name) {
  name += strncmp(name, "./", 2) == 0 ? 2 : 0;
  for (zip_int64_t i = 0; i < zip_get_num_entries(archive, 0); i++) {
    const char *own = zip_get_name(archive, (zip_uint64_t)i, 0);
    size_t length = own ? strlen(own) : 0, end = strlen(name);
    bool whole = length == end || (length > end && own[length - end - 1] == '/');
    if (end > 0 && whole && strcmp(own + length - end, name) == 0 &&
        strncmp(own, "__MACOSX/", 9) != 0)
      return zip_fopen_index(archive, (zip_uint64_t)i, 0);
  }
  return NULL;
}

static bool parse(x3p *x, zip_file_t *file) {
  char block[4096];
  zip_int64_t size = 0;
  XML_Parser parser = XML_ParserCreate(NULL);
  bool good = parser;
  if (good) {
    XML_SetUserData(parser, x);
    XML_SetElementHandler(parser, begin_element, end_element);
    XML_SetCharacterDataHandler(parser, add_text);
  }
  do
    good = good && (size = zip_fread(file, block, sizeof block)) >= 0 &&
           XML_Parse(parser, block, (int)size, size == 0) == XML_STATUS_OK;
  while (good && size > 0);
  if (parser)
    XML_ParserFree(parser);
  return good;
}

/* Points whose bit is not set are missing. */
static void mark_missing(zip_file_t *valid, aspi_raw *raw, size_t skip) {
  unsigned char byte = 0;
  for (size_t i = 0; i < skip + raw->points; i++) {
    if (i % 8 == 0 && zip_fread(valid, &byte, 1) != 1)
      break;
    if (i >= skip && !(byte >> i % 8 & 1)) {
      raw->bad += !isnan(raw->z[i - skip]);
      raw->z[i - skip] = NAN;
    }
  }
}

static asp_code read_data(x3p *x, zip_t *archive, const char *path,
                          const aspi_profile_options *options, aspi_raw *raw, asp_error *error) {
  static const char types[] = "ILFD"; /* of two, four, four and eight bytes, as in SDF: */
  static const int numbers[] = {5, 6, 3, 7};
  const char *type = *x->z_type ? strchr(types, *x->z_type) : NULL;
  zip_file_t *data = x->in_xml ? NULL : find(archive, x->data);
  char block[4096];
  zip_int64_t size;
  while (data && (size = zip_fread(data, block, sizeof block)) > 0)
    fwrite(block, 1, (size_t)size, x->heights);
  if (data)
    zip_fclose(data);
  if ((!data || !type) && !x->in_xml)
    return aspi_file_fail(path, 0, error, "an X3P without heights on a grid");
  x->grid.type = x->in_xml ? -1 : numbers[type - types];
  if (*x->z_axis == 'A') /* absolute: the numbers are heights */
    x->grid.z_scale = 1;
  if (x->layers > 1)
    snprintf(raw->note, sizeof raw->note, "of its %g layers the first is read", x->layers);
  if (*x->x_axis == 'A' && (raw->is_map || !x->in_xml))
    return aspi_file_fail(
        path, 0, error,
        "an X3P with a list of positions (AxisType A) in binary or of a map; save "
        "it as x and z in columns");
  rewind(x->heights);
  aspi_text text = aspi_text_create(x->heights, path);
  aspi_profile_options in_meters = *options;
  in_meters.unit_x = in_meters.unit_z = 1;
  asp_code code = *x->x_axis == 'A' ? aspi_read_columns(&text, &in_meters, raw, error)
                                    : aspi_read_grid(&text, &x->grid, options, raw, error);
  aspi_text_close(&text);
  for (size_t i = 0; i < raw->points && !code; i++)
    raw->z[i] += x->offset;
  zip_file_t *valid = code || options->column ? NULL : find(archive, x->valid);
  if (valid) {
    mark_missing(valid, raw, raw->is_map ? 0 : (size_t)(options->row - 1) * raw->points);
    zip_fclose(valid);
  }
  return code;
}

asp_code aspi_read_x3p(aspi_text *text, const aspi_profile_options *options, aspi_raw *raw,
                       asp_error *error) {
  x3p x = {.grid = {NAN, 1, NAN, NAN, 1, 0, -1, NAN}, .heights = tmpfile()};
  FILE *own = fdopen(dup(fileno(text->stream)), "rb");
  zip_source_t *source = own ? zip_source_filep_create(own, 0, -1, NULL) : NULL;
  zip_t *archive = source ? zip_open_from_source(source, ZIP_RDONLY, NULL) : NULL;
  zip_file_t *main = archive ? find(archive, "main.xml") : NULL;
  asp_code code = ASP_OK;
  if (!x.heights || !archive)
    code = aspi_fail(error, ASP_EFILE, "%.200s: binary, a zip that cannot be opened", text->path);
  else if (!main)
    code = aspi_file_fail(
        text->path, 0, error,
        "binary, a zip that is no X3P; save a spreadsheet as CSV; the free "
        "program Gwyddion (gwyddion.net) opens that of an instrument, and saves it as "
        "text");
  else if (!parse(&x, main))
    code = aspi_file_fail(text->path, 0, error, "the main.xml of this X3P cannot be read");
  else
    code = read_data(&x, archive, text->path, options, raw, error);
  if (main)
    zip_fclose(main);
  if (archive)
    zip_discard(archive);
  else if (source)
    zip_source_free(source);
  else if (own)
    fclose(own);
  if (x.heights)
    fclose(x.heights);
  return code;
}

#else

asp_code aspi_read_x3p(aspi_text *text, const aspi_profile_options *options, aspi_raw *raw,
                       asp_error *error) {
  (void)options;
  (void)raw;
  return aspi_file_fail(text->path, 0, error,
                        "binary, a zip; this build reads no X3P, as libzip and expat were not "
                        "found (Debian: libzip-dev libexpat1-dev); save a spreadsheet as CSV");
}

#endif
