/* The clauses that name a model or a law, and the parameters of a law.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/units.h"
#include "description/words.h"

#include <math.h>

asp_code aspi_spread_read(aspi_words *r, const aspi_keyword *k) {
  char list[ASPI_LIST_MOST] = "";
  for (int i = 1; i < asp_spread_count(); i++) /* 0 is `none`, that of smooth walls */
    aspi_append(list, sizeof list, "%s%s", i > 1 ? " " : "", asp_spread_name(asp_spread_at(i)));
  aspi_words_offer(r, list);
  const char *name = aspi_words_word(r, k->name);
  if (!name)
    return ASP_EARG;
  r->d->spread = asp_spread_find(name, NULL);
  return r->d->spread && r->d->spread != asp_spread_at(0)
             ? ASP_OK
             : aspi_fail_unknown(r->error, "spread model", name, list);
}

asp_code aspi_spread_finish(aspi_words *r) {
  return aspi_words_check_one(r, "plane isotropic");
}

void aspi_spread_write(aspi_line *l, const asp_description *d, const aspi_keyword *k) {
  (void)k;
  aspi_line_word(l, asp_spread_name(aspi_description_spread(d)));
}

/* A law with its values, in the caller's units. */
typedef struct law {
  const char *name;
  const aspi_keyword *parameters;
  int count;
  const double *values;
} law;

static bool is_erosion(const aspi_keyword *k) {
  return strcmp(k->name, "erosion") == 0;
}

static law law_of(const asp_description *d, const aspi_keyword *k) {
  const aspi_erosion_law *erosion = d->choice.erosion.law;
  const asp_rebound_law *rebound = d->choice.law;
  return is_erosion(k) ? (law){erosion->name, erosion->parameters, erosion->n_parameters,
                               d->choice.erosion.given}
                       : (law){rebound->name, rebound->parameters, rebound->n_parameters,
                               d->choice.parameters};
}

static asp_code read_parameter(aspi_words *r, const aspi_keyword *k, const aspi_keyword *p,
                               double *value) {
  aspi_keyword number = *p;
  int index;
  number.fittable = k->fittable;
  if (!p->values)
    return aspi_words_number(r, &number, value);
  asp_code code = aspi_words_choice(r, p, &index);
  *value = index;
  return code;
}

/* The values of all parameters that follow one word; "": the law's name. */
static asp_code read_group(aspi_words *r, const aspi_keyword *k, const char *keyword) {
  const law l = law_of(r->d, k);
  double *values = is_erosion(k) ? r->d->choice.erosion.given : r->d->choice.parameters;
  asp_code code = ASP_OK;
  for (int i = 0; i < l.count && !code; i++)
    if (strcmp(aspi_keyword_word(&l.parameters[i]), keyword) == 0)
      code = read_parameter(r, k, &l.parameters[i], &values[i]);
  return code;
}

bool aspi_law_parameter(aspi_words *r, const aspi_keyword *k, asp_code *code) {
  const law l = law_of(r->d, k);
  unsigned *given = is_erosion(k) ? &r->d->of_erosion : &r->d->of_law;
  for (int i = 0; i < l.count; i++) {
    const char *keyword = aspi_keyword_word(&l.parameters[i]);
    if (!*keyword || !aspi_words_accept(r, keyword))
      continue;
    *code = *given >> i & 1 ? aspi_fail(r->error, ASP_EARG, "'%s' is given twice", keyword)
                            : read_group(r, k, keyword);
    *given |= 1u << i;
    return true;
  }
  return false;
}

static asp_code read_table(aspi_words *r) {
  asp_description *d = r->d;
  asp_code code = aspi_words_file(r, "rebound table", &d->table);
  if (!code)
    code = aspi_words_check_units(r, "rebound table");
  if (code)
    return code;
  d->choice.table = d->cor_table =
      aspi_cor_table_read(d->table, d->units.meter / d->units.second, r->error);
  return d->cor_table ? ASP_OK : ASP_EDATA;
}

asp_code aspi_law_read(aspi_words *r, const aspi_keyword *k) {
  asp_description *d = r->d;
  const int count = is_erosion(k) ? aspi_erosion_count() : asp_rebound_count();
  for (int i = 0; i < count; i++)
    aspi_words_offer(r, is_erosion(k) ? aspi_erosion_at(i)->name : asp_rebound_at(i)->name);
  const char *name = aspi_words_word(r, k->name);
  if (!name)
    return ASP_EARG;
  const asp_rebound_law *rebound = is_erosion(k) ? NULL : asp_rebound_find(name, r->error);
  const aspi_erosion_law *erosion = is_erosion(k) ? aspi_erosion_find(name, r->error) : NULL;
  if (rebound)
    aspi_wall_choose_law(&d->choice, rebound);
  else if (erosion)
    aspi_erosion_take(&d->choice.erosion, erosion, &d->units);
  else
    return ASP_ENAME;
  asp_code code = read_group(r, k, "");
  return !code && rebound && rebound->needs_table ? read_table(r) : code;
}

asp_code aspi_erosion_finish(aspi_words *r) {
  aspi_erosion *erosion = &r->d->choice.erosion;
  for (int i = 0; i < erosion->law->n_parameters; i++)
    erosion->si[i] =
        erosion->given[i] / aspi_quantity_factor(erosion->law->parameters[i].unit, &r->d->units);
  return ASP_OK;
}

static bool differs(const asp_description *d, const aspi_keyword *p, double value) {
  double default_value = p->default_value * aspi_quantity_factor(p->unit, &d->units);
  return value < default_value || value > default_value ||
         (isnan(default_value) && !isnan(value)) || aspi_is_fit(d, p->name);
}

/* Parameters behind one word are left out if all have their defaults. */
void aspi_law_write(aspi_line *to, const asp_description *d, const aspi_keyword *k) {
  const law l = law_of(d, k);
  aspi_line_word(to, l.name);
  if (!is_erosion(k) && d->choice.law->needs_table)
    aspi_line_name(to, d->table);
  for (int i = 0, next; i < l.count; i = next) {
    const char *keyword = aspi_keyword_word(&l.parameters[i]);
    bool any = !*keyword;
    for (next = i; next < l.count && strcmp(aspi_keyword_word(&l.parameters[next]), keyword) == 0;
         next++)
      any = any || differs(d, &l.parameters[next], l.values[next]);
    if (any && *keyword)
      aspi_line_word(to, keyword);
    for (int j = i; j < next && any; j++) {
      const aspi_keyword *p = &l.parameters[j];
      if (p->values)
        aspi_line_word_of(to, p->values, 2 * (int)l.values[j]);
      else
        aspi_line_value(to, d, p->name, p->unit, l.values[j]);
    }
  }
}
