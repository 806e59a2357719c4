/* A user's own materials, read from a text file in columns; they go before the presets of the same
 * name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/csv.h"
#include "base/error.h"
#include "rebound/materials.h"

#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

struct aspi_materials {
  int count;
  asp_material **list; /* as in the file; each with its words behind it in memory */
  void *by_name;       /* the same as a tree */
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

/* A material with the words of a row. */
static asp_material *create(const aspi_csv *csv, const columns *at, asp_error *error) {
  const char *name = field_of(csv, at->name), *title = field_of(csv, at->title);
  const char *source = field_of(csv, at->source);
  size_t a = strlen(name) + 1, b = strlen(title) + 1, c = strlen(source) + 1;
  asp_material *m = malloc(sizeof *m + a + b + c);
  if (!m) {
    aspi_fail(error, ASP_ENOMEM, "out of memory for material '%s'", name);
    return NULL;
  }
  char *words = (char *)(m + 1);
  *m = (asp_material){.name = memcpy(words, name, a),
                      .title = memcpy(words + a, title, b),
                      .source = memcpy(words + a + b, source, c)};
  return m;
}

static asp_code read_numbers(const aspi_csv *csv, const columns *at, asp_material *m,
                             asp_error *error) {
  bool no_yield;
  asp_code code;
  if (!*m->name || strpbrk(m->name, " \t,;"))
    return aspi_text_fail(&csv->text, csv->text.line, error,
                          "the name '%s'; it must be one word without commas", m->name);
  if ((code = aspi_csv_number(csv, at->modulus, 1e-300, 1e300, &m->youngs_modulus, NULL, error)) ||
      (code = aspi_csv_number(csv, at->poisson, -1, 0.5, &m->poissons_ratio, NULL, error)) ||
      (code = aspi_csv_number(csv, at->density, 1e-300, 1e300, &m->density, NULL, error)) ||
      (code = aspi_csv_number(csv, at->yield, 0, 1e300, &m->yield_stress, &no_yield, error)))
    return code;
  if (no_yield)
    m->yield_stress = 0;
  return ASP_OK;
}

static int compare(const void *left, const void *right) {
  const asp_material *a = left, *b = right;
  return strcasecmp(a->name, b->name);
}

static asp_code add_material(aspi_materials *own, const aspi_csv *csv, const columns *at,
                             asp_error *error) {
  size_t count = (size_t)own->count;
  if ((count & (count - 1)) == 0) { /* full: 0, 1, 2, 4, 8, ... */
    asp_material **grown = realloc(own->list, (count ? 2 * count : 1) * sizeof *grown);
    if (!grown)
      return aspi_fail(error, ASP_ENOMEM, "out of memory for over %zu materials", count);
    own->list = grown;
  }
  asp_material *m = create(csv, at, error);
  if (!m)
    return ASP_ENOMEM;
  own->list[own->count++] = m;
  asp_code code = read_numbers(csv, at, m, error);
  if (code)
    return code;
  asp_material *const *node = tsearch(m, &own->by_name, compare);
  if (!node)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for over %zu materials", count);
  return *node == m ? ASP_OK
                    : aspi_text_fail(&csv->text, csv->text.line, error,
                                     "material '%.100s' a second time", m->name);
}

static asp_code read_all(aspi_materials *own, aspi_csv *csv, asp_error *error) {
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

aspi_materials *aspi_materials_read(const char *path, asp_error *error) {
  aspi_csv *csv = aspi_csv_open(path, error);
  if (!csv)
    return NULL;
  aspi_materials *own = calloc(1, sizeof *own);
  asp_code code =
      own ? read_all(own, csv, error) : aspi_fail(error, ASP_ENOMEM, "out of memory for materials");
  aspi_csv_close(csv);
  if (!code)
    return own;
  aspi_materials_free(own);
  return NULL;
}

void aspi_materials_free(aspi_materials *materials) {
  for (int i = 0; materials && i < materials->count; i++) {
    tdelete(materials->list[i], &materials->by_name, compare);
    free(materials->list[i]);
  }
  if (materials)
    free(materials->list);
  free(materials);
}

int aspi_materials_count(const aspi_materials *materials) {
  return materials->count;
}

const asp_material *aspi_materials_at(const aspi_materials *materials, int index) {
  return materials->list[index];
}

const asp_material *aspi_materials_find(const aspi_materials *own, const char *name,
                                        asp_error *error) {
  const asp_material wanted = {.name = name}, *const * node;
  if (own && name && (node = tfind(&wanted, &own->by_name, compare)) != NULL)
    return *node;
  const asp_material *found = aspi_material_find(name, NULL);
  if (found)
    return found;
  char list[2000] = "";
  for (int i = 0; i < asp_material_count() + (own ? own->count : 0); i++) {
    int mine = i - asp_material_count();
    aspi_append(list, sizeof list, "%s%s", *list ? " " : "",
                mine < 0 ? asp_material_at(i)->name : own->list[mine]->name);
  }
  aspi_fail_unknown(error, "material", name, list);
  return NULL;
}
