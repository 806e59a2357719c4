/* The faces of a wall from files; see faces.h. VTK: "VTK File Formats" (Kitware), the legacy form
 * of LIGGGHTS and OpenFOAM and the XML form of LAMMPS's maps, both as text. Both are names with
 * runs of numbers behind them; of several runs behind a name (sizes, then values) the last counts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/faces.h"
#include "base/error.h"
#include "base/grow.h"
#include "base/text.h"
#include "contact/stl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const aspi_face_names[ASPI_FACE_FIELDS][2] = {{"impacts", "impacts"},
                                                          {"deposited_mass", "depositedMass"},
                                                          {"eroded_mass", "erodedMass"},
                                                          {"erosion_depth", "erodedDepth"},
                                                          {"impact_speed", "impact_speed"}};

/* Arrays of a VTK file; CELLS: corners of each face behind their number, and two numbers before. */
enum { POINTS, CELLS, CORNERS, ENDS, FIELDS, OTHER = FIELDS + ASPI_FACE_FIELDS, ARRAYS };
typedef struct Array {
  double *value;
  size_t count;
} Array;

typedef struct Reader {
  aspi_text text;
  aspi_faces *faces;
  double scale;
  Array array[ARRAYS];
  asp_error *error;
} Reader;

static asp_code fail_memory(const Reader *r) {
  return aspi_fail(r->error, ASP_ENOMEM, "out of memory for '%.200s'", r->text.path);
}

static bool add(void *to, const ContactTriangle *triangle) {
  Reader *r = to;
  aspi_faces *f = r->faces;
  ContactTriangle *triangles = aspi_grow(f->triangle, f->triangles, sizeof *triangles);
  f->triangle = triangles ? triangles : f->triangle;
  int *face = triangles ? aspi_grow(f->face, f->triangles, sizeof *face) : NULL;
  if (!face)
    return false;
  f->face = face;
  for (int k = 0; k < 9; k++)
    triangles[f->triangles].node[k / 3][k % 3] = triangle->node[k / 3][k % 3] * r->scale;
  face[f->triangles++] = (int)f->count;
  return true;
}

static bool add_face(void *to, const ContactTriangle *triangle) {
  bool good = add(to, triangle);
  ((Reader *)to)->faces->count++;
  return good;
}

/* The array of a name; without a name, or of points' values, none that counts. */
static int array_of(const char *name) {
  static const struct {
    const char *name;
    int array;
  } parts[] = {{"POINTS", POINTS},        {"<Points>", POINTS},
               {"POLYGONS", CELLS},       {"CELLS", CELLS},
               {"OFFSETS", ENDS},         {"Name=\"offsets\"", ENDS},
               {"CONNECTIVITY", CORNERS}, {"Name=\"connectivity\"", CORNERS}};
  char plain[80];
  for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
    if (strcmp(name, parts[i].name) == 0)
      return parts[i].array;
  if (sscanf(name, "Name=\"%79[^\"]", plain) != 1)
    snprintf(plain, sizeof plain, "%s", name);
  const char *own = strrchr(plain, ':') ? strrchr(plain, ':') + 1 : plain;
  for (int k = 0; k < 2 * ASPI_FACE_FIELDS; k++)
    if (strcmp(own, aspi_face_names[k / 2][k % 2]) == 0)
      return FIELDS + k / 2;
  return OTHER;
}

/* True for words between a name and its numbers: types, LOOKUP_TABLE, attributes. */
static bool is_between(const char *word) {
  static const char words[] =
      "float double int long unsigned_int vtktypeint64 LOOKUP_TABLE default "
      "<DataArray";
  return aspi_word_index(words, word, strlen(word), true) >= 0 ||
         (strchr(word, '=') && strncmp(word, "Name=", 5) != 0);
}

static asp_code read_vtk(Reader *r) {
  char *word;
  int at = OTHER;
  bool in_run = false, skips = false;
  asp_code code;
  while (!(code = aspi_text_word(&r->text, &word, r->error)) && word) {
    double value;
    Array *a = &r->array[at];
    if (strcmp(word, "BINARY") == 0 || strstr(word, "format=\"binary") ||
        strstr(word, "format=\"appended"))
      return aspi_file_fail(r->text.path, r->text.line, r->error,
                            "it is binary; it must be text (ASCII)");
    if (aspi_text_number(word, false, &value) != ASP_WORD_OTHER) {
      a->count = in_run ? a->count : 0;
      double *grown = aspi_grow(a->value, a->count, sizeof *grown);
      if (!grown)
        return fail_memory(r);
      a->value = grown;
      a->value[a->count++] = value;
      in_run = true;
      continue;
    }
    in_run = false;
    if (strstr(word, "POINT_DATA") || strstr(word, "<PointData"))
      skips = true;
    if (strstr(word, "CELL_DATA") || strstr(word, "<CellData"))
      skips = false;
    if (!is_between(word))
      at = skips ? OTHER : array_of(word);
  }
  return code;
}

/* Adds a face of `n` corners, as triangles that share its first one. */
static asp_code add_polygon(Reader *r, const double *corner, size_t n) {
  const Array *points = &r->array[POINTS];
  for (size_t k = 0; k < n; k++)
    if (!(corner[k] >= 0 && 3 * corner[k] + 2 < (double)points->count))
      return aspi_file_fail(r->text.path, 0, r->error, "a face has the point %g of %zu", corner[k],
                            points->count / 3);
  for (size_t k = 1; k + 1 < n; k++) {
    const size_t of[3] = {0, k, k + 1};
    ContactTriangle triangle;
    for (int c = 0; c < 3; c++)
      memcpy(triangle.node[c], points->value + 3 * (size_t)corner[of[c]], sizeof triangle.node[c]);
    if (!add(r, &triangle))
      return fail_memory(r);
  }
  r->faces->count++;
  return ASP_OK;
}

static asp_code make_faces(Reader *r) {
  const Array *cells = &r->array[CELLS], *corners = &r->array[CORNERS], *ends = &r->array[ENDS];
  asp_code code = ASP_OK;
  size_t from = 0;
  for (size_t at = 2, n; at < cells->count && !code; at += n + 1) {
    n = (size_t)fmin(fmax(0, cells->value[at]), (double)(cells->count - at - 1));
    code = add_polygon(r, cells->value + at + 1, n);
  }
  for (size_t i = 0; i < ends->count && !code && cells->count <= 2; i++) {
    size_t end = (size_t)fmin(fmax(0, ends->value[i]), (double)corners->count);
    if (end > from) /* in the legacy form the first end is 0 */
      code = add_polygon(r, corners->value + from, end - from);
    from = end > from ? end : from;
  }
  if (!code && r->faces->triangles == 0)
    code = aspi_file_fail(r->text.path, 0, r->error, "no faces: VTK must have polygons");
  return code;
}

/* Areas, and the values that the file has. */
static asp_code finish(Reader *r) {
  aspi_faces *f = r->faces;
  f->area = calloc(f->count, sizeof *f->area);
  f->value = calloc(f->count, sizeof *f->value);
  if (!f->area || !f->value)
    return fail_memory(r);
  for (size_t i = 0; i < f->triangles; i++)
    f->area[f->face[i]] += aspi_triangle_area(&f->triangle[i]);
  for (int k = 0; k < ASPI_FACE_FIELDS; k++) {
    const Array *a = &r->array[FIELDS + k];
    if (a->count > 0 && a->count != f->count)
      return aspi_file_fail(r->text.path, 0, r->error, "%zu numbers of '%s' for %zu faces",
                            a->count, aspi_face_names[k][0], f->count);
    for (size_t i = 0; i < f->count; i++)
      f->value[i][k] = a->count > 0 ? a->value[i] : NAN;
  }
  return ASP_OK;
}

aspi_faces *aspi_faces_read(const char *path, double scale, asp_error *error) {
  char first[8] = "";
  aspi_faces *faces = calloc(1, sizeof *faces);
  Reader r = {.text.path = path, .faces = faces, .scale = scale, .error = error};
  FILE *file = faces ? aspi_file_open(path, error) : NULL;
  asp_code code = file ? ASP_OK : faces ? ASP_EFILE : fail_memory(&r);
  if (file && fread(first, 1, sizeof first - 1, file) > 0 &&
      (*first == '<' || strncmp(first, "# vtk", 5) == 0)) {
    rewind(file);
    r.text = aspi_text_create(file, path);
    code = read_vtk(&r);
    code = code ? code : make_faces(&r);
    aspi_text_close(&r.text);
  } else if (file) {
    code = aspi_stl_read(path, add_face, &r, error);
  }
  code = code ? code : finish(&r);
  if (file)
    fclose(file);
  for (int k = 0; k < ARRAYS; k++)
    free(r.array[k].value);
  if (!code)
    return faces;
  aspi_faces_free(faces);
  return NULL;
}

void aspi_faces_free(aspi_faces *f) {
  if (!f)
    return;
  free(f->triangle);
  free(f->face);
  free(f->area);
  free(f->value);
  free(f);
}
