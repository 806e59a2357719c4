/* The canonical text of a description.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number.h"
#include "base/quantity.h"
#include "description/description.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The text so far; what does not fit is counted only. */
typedef struct line {
  char *text;
  size_t size, length;
} line;

static void add_word(line *l, const char *word) {
  size_t n = strlen(word);
  if (l->length > 0)
    l->length++;
  if (l->length < l->size) {
    if (l->length > 0)
      l->text[l->length - 1] = ' ';
    snprintf(l->text + l->length, l->size - l->length, "%s", word);
  }
  l->length += n;
}

/* In SI a length over 1 mm and a stress under 1 MPa get their unit, since the command refuses them
 * without one. */
static void print_value(const asp_description *d, double value, const char *kind, char *text) {
  bool is_si = !(d->units.meter < 1) && !(d->units.meter > 1);
  bool length = is_si && strcmp(kind, "length") == 0 && isfinite(value) && value > 1e-3;
  (length ? aspi_quantity_print_length : aspi_number_print)(value, text);
  if (is_si && strcmp(kind, "stress") == 0 && value > 0 && value < 1e6)
    strcat(text, "Pa");
}

static void add_number(line *l, double value) {
  char text[32];
  aspi_number_print(value, text);
  add_word(l, text);
}

/* `fit=START` of an unknown one. */
static void add_value(line *l, const asp_description *d, const char *name, const char *kind,
                      double value) {
  char text[48] = "fit=";
  print_value(d, value, kind, text + strlen(text));
  add_word(l, !aspi_is_fit(d, name) ? text + strlen("fit=") : isnan(value) ? "fit" : text);
}

/* A keyword within another one, with its number or its choice. */
static void add_keyword(line *l, const asp_description *d, const char *within, const char *name) {
  const asp_keyword *k = aspi_keyword_find(within, name);
  char word[20];
  add_word(l, name);
  if (k->number)
    add_value(l, d, name, k->unit, asp_description_get(d, name));
  if (k->flag && *k->values) {
    aspi_keyword_choice(k, d, word);
    add_word(l, word);
  }
}

/* Those within one that are given and have a value. */
static void add_given(line *l, const asp_description *d, const char *within) {
  for (int i = 0; i < aspi_keyword_count(); i++) {
    const asp_keyword *k = asp_keyword_at(i);
    if (strcmp(k->within, within) == 0 && (k->number || k->flag) && aspi_is_given(d, k->name))
      add_keyword(l, d, within, k->name);
  }
}

/* In quotes where it would not be one word. */
static void add_name(line *l, const char *name) {
  size_t size = strlen(name) + 3;
  char *quoted = strpbrk(name, " \t\"'") || !*name ? malloc(size) : NULL;
  if (quoted) {
    char quote = strchr(name, '"') ? '\'' : '"';
    snprintf(quoted, size, "%c%s%c", quote, name, quote);
  }
  add_word(l, quoted ? quoted : name);
  free(quoted);
}

static void add_lay(line *l, const asp_description *d) {
  if (d->lay == ASP_LAY_NONE)
    return;
  add_word(l, "lay");
  if (d->lay_word)
    add_word(l, d->lay_word);
  for (int i = 0; i < (d->lay == ASP_LAY_VECTOR ? 3 : 1) && !d->lay_word; i++)
    add_number(l, d->lay_numbers[i]);
}

static void add_surface(line *l, const asp_description *d) {
  add_word(l, "surface");
  switch (d->kind) {
  case ASPI_SMOOTH:
    add_word(l, "smooth");
    break;
  case ASPI_SIGMA:
    add_keyword(l, d, "surface", "sigma");
    if (d->lambda_c > 0)
      add_keyword(l, d, "surface", "lambda_c");
    break;
  case ASPI_GAUSSIAN:
    add_keyword(l, d, "surface", "rq");
    add_keyword(l, d, "surface", "lambda_c");
    if (d->lay != ASP_LAY_NONE)
      add_value(l, d, "", "length", d->lambda_along);
    break;
  case ASPI_PROFILE:
  case ASPI_MAP:
    add_word(l, d->kind == ASPI_MAP ? "map" : "profile");
    add_name(l, d->file);
  }
  add_lay(l, d);
  if (aspi_is_given(d, "dp_bins"))
    add_keyword(l, d, "surface", "dp_bins");
}

static void add_spread(line *l, const asp_description *d) {
  if (d->kind == ASPI_SMOOTH && !aspi_is_given(d, "spread"))
    return;
  add_word(l, "spread");
  add_word(l, d->choice.spread->name);
  add_word(l, d->choice.isotropic ? "isotropic" : "plane");
  add_keyword(l, d, "spread", "collisions");
}

static void add_parameter(line *l, const asp_description *d, const asp_parameter *p, double value) {
  const char *word = p->words;
  if (!word) {
    add_value(l, d, p->name, p->unit, value);
    return;
  }
  for (int i = (int)value; i > 0; i--)
    word += strcspn(word, " ") + 1;
  char one[40];
  snprintf(one, sizeof one, "%.*s", (int)strcspn(word, " "), word);
  add_word(l, one);
}

/* A law's parameters and their values. */
typedef struct law_numbers {
  const asp_parameter *parameters;
  int count;
  const double *values; /* in the caller's units */
  const double *own;    /* in those of the defaults */
} law_numbers;

static bool differs(const asp_description *d, const law_numbers *l, int i) {
  double value = l->own[i], standard = l->parameters[i].fallback;
  return value < standard || value > standard || (isnan(standard) && !isnan(value)) ||
         aspi_is_fit(d, l->parameters[i].name);
}

/* Parameters behind one word are left out if all have their defaults. */
static void add_parameters(line *l, const asp_description *d, const law_numbers *of) {
  for (int i = 0, next; i < of->count; i = next) {
    const char *keyword = aspi_parameter_keyword(&of->parameters[i]);
    bool any = !*keyword;
    for (next = i;
         next < of->count && strcmp(aspi_parameter_keyword(&of->parameters[next]), keyword) == 0;
         next++)
      any = any || differs(d, of, next);
    if (any && *keyword)
      add_word(l, keyword);
    for (int k = i; k < next && any; k++)
      add_parameter(l, d, &of->parameters[k], of->values[k]);
  }
}

static void add_rebound(line *l, const asp_description *d) {
  const asp_rebound_law *of = d->choice.law;
  const double *values = d->choice.parameters;
  add_word(l, "rebound");
  add_word(l, of->name);
  if (of->needs_table)
    add_name(l, d->table);
  add_parameters(l, d, &(law_numbers){of->parameters, of->n_parameters, values, values});
  add_given(l, d, "rebound");
}

static void add_constants(line *l, const asp_description *d) {
  if (aspi_is_given(d, "materials")) {
    add_word(l, "materials");
    for (int i = 0; i < d->n_materials; i++)
      add_name(l, d->names[i]);
    if (d->materials_file) {
      add_word(l, "file");
      add_name(l, d->materials_file);
    }
  }
  static const char *const numbers[] = {"friction", "surface_energy", "yield_stress"};
  for (int i = 0; i < 3; i++)
    if (aspi_is_given(d, numbers[i]))
      add_keyword(l, d, "", numbers[i]);
}

static void add_deposit(line *l, const asp_description *d) {
  add_word(l, "deposit");
  add_word(l, asp_description_word(d, "deposit"));
  if (aspi_is_given(d, "remove"))
    add_word(l, "remove");
  add_given(l, d, "remove");
}

static void add_grain(line *l, const asp_description *d) {
  if (!(d->choice.lever > 0))
    return;
  add_word(l, "grain");
  add_keyword(l, d, "grain", "lever");
}

static void add_erosion(line *l, const asp_description *d) {
  const aspi_erosion *erosion = &d->choice.erosion;
  const aspi_erosion_law *of = erosion->law;
  if (!of)
    return;
  add_word(l, "erosion");
  add_word(l, of->name);
  add_parameters(l, d,
                 &(law_numbers){of->parameters, of->n_parameters, erosion->given, erosion->si});
  if (aspi_is_given(d, "density"))
    add_keyword(l, d, "erosion", "density");
  add_keyword(l, d, "erosion", "face");
}

size_t asp_description_text(const asp_description *d, char *text, size_t size) {
  line l = {text, size, 0};
  if (size > 0)
    *text = '\0';
  add_surface(&l, d);
  add_spread(&l, d);
  add_rebound(&l, d);
  add_constants(&l, d);
  add_deposit(&l, d);
  add_grain(&l, d);
  add_erosion(&l, d);
  add_keyword(&l, d, "", "seed");
  return l.length;
}

/* Behind a word, or a name in quotes, and the blanks that follow. */
static const char *behind_word(const char *at) {
  const char *end = *at == '"' || *at == '\'' ? strchr(at + 1, *at) : NULL;
  at = end ? end + 1 : at + strcspn(at, " ");
  return at + strspn(at, " ");
}

static bool begins_clause(const char *at) {
  size_t length = strcspn(at, " ");
  for (int i = 0; i < aspi_keyword_count(); i++) {
    const asp_keyword *k = asp_keyword_at(i);
    if (!*k->within && strlen(k->name) == length && strncmp(k->name, at, length) == 0)
      return true;
  }
  return false;
}

size_t asp_description_clause(const char *text) {
  const char *at = behind_word(text);
  while (*at && !begins_clause(at))
    at = behind_word(at);
  return (size_t)(at - text);
}
