/* A user's own materials, read from a text file in columns; they go before the presets of the same
 * name. */
#include "csv.h"
#include "error.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

struct asp_materials {
  int count;
  asp_material *list; /* name, title and source of each are one piece of memory, the name's */
};

typedef struct columns {
  int name, title, modulus, poisson, density, yield, source, seen;
} columns;

/* Where the columns are; -1 and a message where one that must be there is not. */
static columns columns_of(const asp_csv *csv, asp_error *error) {
  return (columns){.name = asp_csv_need(csv, "name", error),
                   .title = asp_csv_find(csv, "title"),
                   .modulus = asp_csv_need(csv, "youngs_modulus_pa", error),
                   .poisson = asp_csv_need(csv, "poissons_ratio", error),
                   .density = asp_csv_need(csv, "density_kg_m3", error),
                   .yield = asp_csv_find(csv, "yield_stress_pa"),
                   .source = asp_csv_find(csv, "source"),
                   .seen = asp_csv_find(csv, "seen")};
}

static const char *field_of(const asp_csv *csv, int column) {
  return column < 0 ? "" : csv->fields[column];
}

/* Copies the words of a row into memory of their own. */
static asp_code copy_words(const asp_csv *csv, const columns *at, asp_material *m,
                           asp_error *error) {
  const char *name = field_of(csv, at->name), *title = field_of(csv, at->title);
  const char *source = field_of(csv, at->source);
  size_t a = strlen(name) + 1, b = strlen(title) + 1, c = strlen(source) + 1;
  char *words = malloc(a + b + c);
  if (!words)
    return asp_fail(error, ASP_ENOMEM, "out of memory for material '%s'", name);
  memcpy(words, name, a);
  memcpy(words + a, title, b);
  memcpy(words + a + b, source, c);
  m->name = words;
  m->title = words + a;
  m->source = words + a + b;
  return ASP_OK;
}

static asp_code read_material(const asp_csv *csv, const columns *at, asp_material *m,
                              asp_error *error) {
  const char *name = field_of(csv, at->name), *seen = field_of(csv, at->seen);
  bool no_yield;
  asp_code code;
  if (!*name || strpbrk(name, " \t,;"))
    return asp_text_fail(&csv->text, csv->text.line, error,
                         "the name '%s'; it must be one word without commas", name);
  if (*seen && strcasecmp(seen, "yes") != 0 && strcasecmp(seen, "no") != 0)
    return asp_text_fail(&csv->text, csv->text.line, error, "seen is '%s'; it must be yes or no",
                         seen);
  if ((code = asp_csv_number(csv, at->modulus, 1e-300, 1e300, &m->youngs_modulus, NULL, error)) ||
      (code = asp_csv_number(csv, at->poisson, -1, 0.5, &m->poissons_ratio, NULL, error)) ||
      (code = asp_csv_number(csv, at->density, 1e-300, 1e300, &m->density, NULL, error)) ||
      (code = asp_csv_number(csv, at->yield, 0, 1e300, &m->yield_stress, &no_yield, error)))
    return code;
  if (no_yield)
    m->yield_stress = 0;
  m->seen = strcasecmp(seen, "yes") == 0;
  return copy_words(csv, at, m, error);
}

static const asp_material *find_own(const asp_materials *own, const char *name) {
  for (int i = 0; name && own && i < own->count; i++)
    if (strcmp(own->list[i].name, name) == 0)
      return &own->list[i];
  return NULL;
}

static asp_code add_material(asp_materials *own, const asp_csv *csv, const columns *at,
                             asp_error *error) {
  if (find_own(own, field_of(csv, at->name)))
    return asp_text_fail(&csv->text, csv->text.line, error, "material '%s' a second time",
                         field_of(csv, at->name));
  asp_material *grown = realloc(own->list, (size_t)(own->count + 1) * sizeof *grown);
  if (!grown)
    return asp_fail(error, ASP_ENOMEM, "out of memory for %d materials", own->count + 1);
  own->list = grown;
  asp_code code = read_material(csv, at, &own->list[own->count], error);
  own->count += !code;
  return code;
}

static asp_code read_all(asp_materials *own, asp_csv *csv, asp_error *error) {
  columns at = columns_of(csv, error);
  if (at.name < 0 || at.modulus < 0 || at.poisson < 0 || at.density < 0)
    return ASP_EDATA;
  asp_code code = ASP_OK;
  for (bool found = true; !code && found;) {
    code = asp_csv_row(csv, &found, error);
    if (!code && found)
      code = add_material(own, csv, &at, error);
  }
  return code;
}

asp_materials *asp_materials_read(const char *path, asp_error *error) {
  asp_csv *csv = asp_csv_open(path, error);
  if (!csv)
    return NULL;
  asp_materials *own = calloc(1, sizeof *own);
  asp_code code =
      own ? read_all(own, csv, error) : asp_fail(error, ASP_ENOMEM, "out of memory for materials");
  asp_csv_close(csv);
  if (!code)
    return own;
  asp_materials_free(own);
  return NULL;
}

void asp_materials_free(asp_materials *materials) {
  for (int i = 0; materials && i < materials->count; i++)
    free((char *)materials->list[i].name);
  if (materials)
    free(materials->list);
  free(materials);
}

int asp_materials_count(const asp_materials *materials) {
  return materials->count;
}

const asp_material *asp_materials_at(const asp_materials *materials, int index) {
  return &materials->list[index];
}

const asp_material *asp_materials_find(const asp_materials *own, const char *name,
                                       asp_error *error) {
  const asp_material *found = find_own(own, name);
  if (found)
    return found;
  asp_error wrong;
  found = asp_material_find(name, &wrong);
  if (found)
    return found;
  asp_fail(error, wrong.code, "%s", wrong.text);
  for (int i = 0; error && own && i < own->count; i++) {
    size_t used = strlen(error->text);
    snprintf(error->text + used, sizeof error->text - used, " %s", own->list[i].name);
  }
  return NULL;
}
