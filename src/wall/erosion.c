/* The clause `erosion` of a description: read, checked and printed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/number.h"
#include "base/quantity.h"
#include "wall/description.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The words of the clause that are left. */
typedef struct reader {
  const char *const *words;
  int count, *next;
  const asp_units *units;
  asp_error *error;
} reader;

static const char *word(const reader *r, const char *what) {
  if (*r->next < r->count)
    return r->words[(*r->next)++];
  aspi_fail(r->error, ASP_EARG, "%s of 'erosion' is missing", what);
  return NULL;
}

static asp_code read_parameter(const reader *r, aspi_erosion *erosion, int i) {
  const asp_parameter *p = &erosion->law->parameters[i];
  const char *given = word(r, p->name);
  double *value = &erosion->given[i];
  if (!given)
    return ASP_EARG;
  asp_code code = p->words ? asp_parameter_read(p, given, value, r->error)
                           : aspi_quantity_read(p->name, given, p->unit, r->units, value, r->error);
  if (!code && !p->words && !(p->least < 0))
    code = aspi_check_positive(r->error, p->name, "", *value);
  erosion->si[i] = p->words ? *value : *value / aspi_quantity_factor(p->unit, r->units);
  return code;
}

static asp_code read_face(const reader *r, aspi_erosion *erosion) {
  const char *given = word(r, "the value of 'face'");
  if (!given)
    return ASP_EARG;
  erosion->tilted = strcmp(given, "tilted") == 0;
  if (erosion->tilted || strcmp(given, "mean") == 0)
    return ASP_OK;
  return aspi_fail(r->error, ASP_EARG, "face is '%.100s'; it must be mean or tilted", given);
}

static asp_code read_density(const reader *r, aspi_erosion *erosion) {
  const aspi_keyword *k = aspi_keyword_find("erosion", "density");
  const char *given = word(r, "density");
  asp_code code =
      given ? aspi_quantity_read("density", given, k->unit, r->units, &erosion->density, r->error)
            : ASP_EARG;
  return code ? code : aspi_keyword_check(k, erosion->density, r->error);
}

/* The parameter whose keyword a word is; -1: none. */
static int find_parameter(const aspi_erosion_law *law, const char *name) {
  for (int i = 0; i < law->n_parameters; i++)
    if (strcmp(asp_parameter_keyword(&law->parameters[i]), name) == 0)
      return i;
  return -1;
}

asp_code aspi_wall_read_erosion(asp_wall *wall, int count, const char *const *words, int *next,
                                asp_error *error) {
  reader r = {words, count, next, &wall->said->units, error};
  aspi_erosion *erosion = &wall->choice.erosion;
  const char *name = word(&r, "the law");
  const aspi_erosion_law *law = name ? aspi_erosion_find(name, error) : NULL;
  if (!law)
    return name ? ASP_ENAME : ASP_EARG;
  if (!(aspi_quantity_factor("stress", r.units) > 0))
    return aspi_fail(error, ASP_EARG, "erosion is in SI units, which cannot be converted to %s",
                     r.units->name);
  aspi_erosion_take(erosion, law, r.units);
  asp_code code = ASP_OK;
  for (int i = 0; i < law->n_parameters && !code; i++)
    if (!law->parameters[i].keyword)
      code = read_parameter(&r, erosion, i);
  for (bool more = true; more && !code && *next < count;) {
    const char *now = words[*next];
    int i = find_parameter(law, now);
    more = i >= 0 || strcmp(now, "face") == 0 || strcmp(now, "density") == 0;
    *next += more;
    if (i >= 0)
      code = read_parameter(&r, erosion, i);
    else if (more)
      code = strcmp(now, "face") == 0 ? read_face(&r, erosion) : read_density(&r, erosion);
  }
  return code;
}

asp_code aspi_wall_check_erosion(const asp_wall *wall, asp_error *error) {
  const aspi_erosion *erosion = &wall->choice.erosion;
  if (!erosion->law || erosion->density > 0 ||
      (wall->said->n_materials > 0 && wall->choice.law->needs_pair))
    return ASP_OK;
  return aspi_fail(error, ASP_EARG,
                   "erosion needs the density of the wall: by 'materials', or 'density RHO' in its "
                   "own words");
}

static void add(char *text, size_t size, const char *name, const char *value) {
  size_t used = strlen(text);
  snprintf(text + used, size - used, " %s%s%s", name, *name ? " " : "", value);
}

/* Prints a parameter's value; for a choice of words, the chosen word. */
static void print_value(const asp_parameter *p, double value, char text[40]) {
  const char *one = asp_parameter_words(p);
  if (!*one) {
    aspi_number_print(value, text);
    return;
  }
  for (int i = (int)value; i > 0; i--)
    one += strcspn(one, " ") + 1;
  snprintf(text, 40, "%.*s", (int)strcspn(one, " "), one);
}

void aspi_wall_describe_erosion(const asp_wall *wall, char *text, size_t size) {
  const aspi_erosion *erosion = &wall->choice.erosion;
  const aspi_erosion_law *law = erosion->law;
  char value[40];
  *text = '\0';
  if (!law)
    return;
  snprintf(text, size, "erosion %s", law->name);
  for (int i = 0; i < law->n_parameters; i++) {
    const asp_parameter *p = &law->parameters[i];
    double now = erosion->si[i], standard = p->fallback;
    if (isnan(now) || (p->keyword && !(now < standard || now > standard || isnan(standard))))
      continue;
    print_value(p, erosion->given[i], value);
    add(text, size, asp_parameter_keyword(p), value);
  }
  aspi_number_print(erosion->density, value);
  if (erosion->density > 0)
    add(text, size, "density", value);
  add(text, size, "face", erosion->tilted ? "tilted" : "mean");
}
