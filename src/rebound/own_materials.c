/* A user's own materials, read from a text file in columns; they go before the presets of the same
 * name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/csv.h"
#include "base/error.h"
#include "rebound/materials.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { ROOM_MOST = 1 << 28 };

typedef struct own_material {
  asp_material material; /* name, title and source are one piece of memory, the name's */
  size_t line;           /* of the file */
} own_material;

struct asp_materials {
  int count, room;
  own_material *list;
  const own_material **by_name; /* in order of the names, then as in the file */
};

typedef struct columns {
  int name, title, modulus, poisson, density, yield, source;
} columns;

/* Positions of the columns; -1 and a message if a required one is missing. */
static columns columns_of(const aspi_csv *csv, asp_error *error) {
  return (columns){.name = aspi_csv_need(csv, "name", error),
                   .title = aspi_csv_find(csv, "title"),
                   .modulus = aspi_csv_need(csv, "youngs_modulus_pa", error),
                   .poisson = aspi_csv_need(csv, "poissons_ratio", error),
                   .density = aspi_csv_need(csv, "density_kg_m3", error),
                   .yield = aspi_csv_find(csv, "yield_stress_pa"),
                   .source = aspi_csv_find(csv, "source")};
}

static const char *field_of(const aspi_csv *csv, int column) {
  return column < 0 ? "" : csv->fields[column];
}

/* Copies the words of a row into memory of their own. */
static asp_code copy_words(const aspi_csv *csv, const columns *at, asp_material *m,
                           asp_error *error) {
  const char *name = field_of(csv, at->name), *title = field_of(csv, at->title);
  const char *source = field_of(csv, at->source);
  size_t a = strlen(name) + 1, b = strlen(title) + 1, c = strlen(source) + 1;
  char *words = malloc(a + b + c);
  if (!words)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for material '%s'", name);
  memcpy(words, name, a);
  memcpy(words + a, title, b);
  memcpy(words + a + b, source, c);
  m->name = words;
  m->title = words + a;
  m->source = words + a + b;
  return ASP_OK;
}

static asp_code read_material(const aspi_csv *csv, const columns *at, asp_material *m,
                              asp_error *error) {
  const char *name = field_of(csv, at->name);
  bool no_yield;
  asp_code code;
  if (!*name || strpbrk(name, " \t,;"))
    return aspi_text_fail(&csv->text, csv->text.line, error,
                          "the name '%s'; it must be one word without commas", name);
  if ((code = aspi_csv_number(csv, at->modulus, 1e-300, 1e300, &m->youngs_modulus, NULL, error)) ||
      (code = aspi_csv_number(csv, at->poisson, -1, 0.5, &m->poissons_ratio, NULL, error)) ||
      (code = aspi_csv_number(csv, at->density, 1e-300, 1e300, &m->density, NULL, error)) ||
      (code = aspi_csv_number(csv, at->yield, 0, 1e300, &m->yield_stress, &no_yield, error)))
    return code;
  if (no_yield)
    m->yield_stress = 0;
  return copy_words(csv, at, m, error);
}

static int compare_names(const void *left, const void *right) {
  const own_material *const *a = left, *const *b = right;
  return strcasecmp((*a)->material.name, (*b)->material.name);
}

static int compare(const void *left, const void *right) {
  const own_material *const *a = left, *const *b = right;
  int order = compare_names(left, right);
  return order ? order : (*a > *b) - (*a < *b);
}

static const asp_material *find_own(const asp_materials *own, const char *name) {
  if (!own || !name)
    return NULL;
  const own_material wanted = {.material.name = name}, *key = &wanted;
  const own_material **found =
      bsearch(&key, own->by_name, (size_t)own->count, sizeof *own->by_name, compare_names);
  return found ? &(*found)->material : NULL;
}

static asp_code add_material(asp_materials *own, const aspi_csv *csv, const columns *at,
                             asp_error *error) {
  if (own->count == own->room) {
    int room = own->room ? 2 * own->room : 16;
    own_material *grown =
        room <= ROOM_MOST ? realloc(own->list, (size_t)room * sizeof *grown) : NULL;
    if (!grown)
      return aspi_fail(error, ASP_ENOMEM, "out of memory for over %d materials", own->count);
    own->list = grown;
    own->room = room;
  }
  asp_code code = read_material(csv, at, &own->list[own->count].material, error);
  own->list[own->count].line = csv->text.line;
  own->count += !code;
  return code;
}

static asp_code read_all(asp_materials *own, aspi_csv *csv, asp_error *error) {
  columns at = columns_of(csv, error);
  if (at.name < 0 || at.modulus < 0 || at.poisson < 0 || at.density < 0)
    return ASP_EDATA;
  asp_code code = ASP_OK;
  for (bool found = true; !code && found;) {
    code = aspi_csv_row(csv, &found, error);
    if (!code && found)
      code = add_material(own, csv, &at, error);
  }
  return code;
}

/* Puts the names in order; of those that are there twice, the first in the file is an error. */
static asp_code sort_names(asp_materials *own, const char *path, asp_error *error) {
  size_t count = (size_t)own->count;
  const own_material *again = NULL;
  own->by_name = malloc((count + 1) * sizeof *own->by_name);
  if (!own->by_name)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for %d materials", own->count);
  for (size_t i = 0; i < count; i++)
    own->by_name[i] = &own->list[i];
  qsort(own->by_name, count, sizeof *own->by_name, compare);
  for (size_t i = 1; i < count; i++)
    if (compare_names(&own->by_name[i - 1], &own->by_name[i]) == 0 &&
        (!again || own->by_name[i] < again))
      again = own->by_name[i];
  if (!again)
    return ASP_OK;
  return aspi_fail(error, ASP_EDATA, "%.200s:%zu: material '%.100s' a second time", path,
                   again->line, again->material.name);
}

asp_materials *asp_materials_read(const char *path, asp_error *error) {
  aspi_csv *csv = aspi_csv_open(path, error);
  if (!csv)
    return NULL;
  asp_materials *own = calloc(1, sizeof *own);
  asp_code code =
      own ? read_all(own, csv, error) : aspi_fail(error, ASP_ENOMEM, "out of memory for materials");
  aspi_csv_close(csv);
  if (!code)
    code = sort_names(own, path, error);
  if (!code)
    return own;
  asp_materials_free(own);
  return NULL;
}

void asp_materials_free(asp_materials *materials) {
  for (int i = 0; materials && i < materials->count; i++)
    free((char *)materials->list[i].material.name);
  if (materials) {
    free(materials->list);
    free(materials->by_name);
  }
  free(materials);
}

int asp_materials_count(const asp_materials *materials) {
  return materials->count;
}

const asp_material *asp_materials_at(const asp_materials *materials, int index) {
  return &materials->list[index].material;
}

const asp_material *asp_materials_find(const asp_materials *own, const char *name,
                                       asp_error *error) {
  const asp_material *found = find_own(own, name);
  if (found)
    return found;
  found = aspi_material_find(name, NULL);
  if (found)
    return found;
  char list[2000] = "";
  for (int i = 0; i < asp_material_count() + (own ? own->count : 0); i++) {
    int mine = i - asp_material_count();
    size_t used = strlen(list);
    snprintf(list + used, sizeof list - used, "%s%s", used ? " " : "",
             mine < 0 ? asp_material_at(i)->name : own->list[mine].material.name);
  }
  aspi_fail_unknown(error, "material", name, list);
  return NULL;
}
