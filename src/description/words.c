/* The words of a description, one after the other, and the numbers among them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "description/words.h"
#include "base/error.h"
#include "base/number.h"
#include "base/quantity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool aspi_words_next_is(const aspi_words *r, const char *word) {
  return r->next < r->count && strcmp(r->words[r->next], word) == 0;
}

bool aspi_words_take(aspi_words *r, const char *word) {
  bool here = aspi_words_next_is(r, word);
  r->next += here;
  return here;
}

bool aspi_words_take_once(aspi_words *r, const char *name, asp_code *code) {
  if (!aspi_words_take(r, name))
    return false;
  if (aspi_is_given(r->d, name))
    *code = aspi_fail(r->error, ASP_EARG, "'%s' is given twice", name);
  aspi_set_given(r->d, name);
  return true;
}

/* The same for any keyword within another one. NULL if the next word is none of them. */
static const asp_keyword *take_keyword(aspi_words *r, const char *within, asp_code *code) {
  for (int i = 0; i < aspi_keyword_count(); i++) {
    const asp_keyword *k = asp_keyword_at(i);
    if (strcmp(k->within, within) == 0 && aspi_words_take_once(r, k->name, code))
      return k;
  }
  return NULL;
}

const char *aspi_words_word(aspi_words *r, const char *what) {
  if (r->next < r->count)
    return r->words[r->next++];
  aspi_fail(r->error, ASP_EARG, "%s%s is missing", what, r->of);
  return NULL;
}

bool aspi_words_misplaced(const aspi_words *r, const char *name) {
  for (int i = 0; i < aspi_keyword_count(); i++) {
    const asp_keyword *k = asp_keyword_at(i);
    if (!*k->within || strcmp(k->name, name) != 0)
      continue;
    bool here = strcmp(k->within, r->d->last) == 0;
    aspi_fail(r->error, ASP_ENAME, "'%s' %s '%s': %s%s %s%s%s", name,
              here ? "has no place here behind" : "belongs behind", k->within, k->within,
              strcmp(k->within, "spread") == 0 ? " MODEL" : "", name, *k->values ? " " : "",
              k->values);
    return true;
  }
  return false;
}

bool aspi_words_number_next(const aspi_words *r) {
  if (r->next >= r->count)
    return false;
  char *end;
  aspi_number(r->words[r->next], &end);
  return end > r->words[r->next];
}

char *aspi_words_copy(const char *text, asp_error *error) {
  size_t size = strlen(text) + 1;
  char *made = malloc(size);
  if (made)
    memcpy(made, text, size);
  else
    aspi_fail(error, ASP_ENOMEM, "out of memory for a description");
  return made;
}

asp_code aspi_words_file(aspi_words *r, const char *what, char **name) {
  const char *given = aspi_words_word(r, what);
  if (!given)
    return ASP_EARG;
  if (strcmp(given, "-") == 0)
    return aspi_fail(r->error, ASP_EARG, "%s is '-'; it must be the name of a file", what);
  free(*name);
  *name = aspi_words_copy(given, r->error);
  return *name ? ASP_OK : ASP_ENOMEM;
}

bool aspi_words_unknown(const aspi_words *r, const char *given, const char **start) {
  bool alone = strcmp(given, "fit") == 0, begins = strncmp(given, "fit=", 4) == 0;
  bool unknown = r->d->may_fit && (alone || begins);
  *start = !unknown ? given : begins ? given + 4 : NULL;
  return unknown;
}

asp_code aspi_words_add_unknown(aspi_words *r, const char *name) {
  asp_description *d = r->d;
  if (d->n_fits == ASPI_FITS_MOST)
    return aspi_fail(r->error, ASP_EARG, "%s is one number too many to fit; there may be %d", name,
                     ASPI_FITS_MOST);
  d->fits[d->n_fits++] = name;
  return ASP_OK;
}

/* Degrees: default start of a fit of sigma. */
#define SIGMA_START 5

/* The default start of a fit. */
static asp_code standard_start(aspi_words *r, const asp_keyword *k, double *value) {
  char units[120];
  aspi_quantity_units(k->unit, units, sizeof units);
  if (strcmp(k->unit, "length") == 0)
    return aspi_fail(r->error, ASP_EARG,
                     "a fit of %s needs a value to begin with: say '%s fit=VALUE', in one of: %s",
                     k->name, k->name, units);
  *value = strcmp(k->name, "sigma") == 0 ? SIGMA_START : NAN;
  return ASP_OK;
}

asp_code aspi_words_number(aspi_words *r, const char *within, const char *name, double *value) {
  const asp_keyword *k = aspi_keyword_find(within, name);
  aspi_set_given(r->d, name);
  const char *given = aspi_words_word(r, name), *start = given;
  if (!given)
    return ASP_EARG;
  bool unknown = k->may_fit && aspi_words_unknown(r, given, &start);
  asp_code code = start ? aspi_quantity_read(name, start, k->unit, &r->d->units, value, r->error)
                        : standard_start(r, k, value);
  if (!code && start)
    code = k->whole ? aspi_keyword_check(k, *value, r->error)
                    : aspi_quantity_check(name, start, k->unit, *value, k->least, k->most, k->above,
                                          r->error);
  return !code && unknown ? aspi_words_add_unknown(r, k->name) : code;
}

/* The choice of two words that sets a flag. */
static asp_code read_flag(aspi_words *r, const asp_keyword *k, bool *flag) {
  char what[60];
  snprintf(what, sizeof what, "the value of '%s'", k->name);
  const char *given = *k->values ? aspi_words_word(r, what) : NULL, *second = NULL;
  *flag = true;
  if (!*k->values)
    return ASP_OK;
  if (!given)
    return ASP_EARG;
  second = strrchr(k->values, ' ') + 1;
  *flag = strcmp(given, second) == 0;
  size_t length = strcspn(k->values, " ");
  if (*flag || (strlen(given) == length && strncmp(given, k->values, length) == 0))
    return ASP_OK;
  return aspi_fail(r->error, ASP_EARG, "%s is '%.100s'; it must be %.*s or %s", k->name, given,
                   (int)length, k->values, second);
}

asp_code aspi_words_value(aspi_words *r, const asp_keyword *k) {
  void *place = (char *)r->d + k->number + k->flag; /* one of them is 0 */
  aspi_set_given(r->d, k->name);
  return k->number ? aspi_words_number(r, k->within, k->name, place)
         : k->flag ? read_flag(r, k, place)
                   : ASP_OK;
}

asp_code aspi_words_values(aspi_words *r, const char *within, bool *any) {
  asp_code code = ASP_OK;
  const asp_keyword *k;
  for (*any = false; !code && (k = take_keyword(r, within, &code)); *any = true)
    code = code ? code : aspi_words_value(r, k);
  return code;
}

asp_code aspi_words_check_units(const aspi_words *r, const char *what) {
  if (aspi_quantity_factor("stress", &r->d->units) > 0)
    return ASP_OK;
  return aspi_fail(r->error, ASP_EARG, "%s in SI units, which cannot be converted to %s", what,
                   r->d->units.name);
}
