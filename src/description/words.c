/* The words of a description, one after the other, and the numbers among them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "description/words.h"
#include "base/number.h"
#include "base/units.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

bool aspi_words_next_is(const aspi_words *r, const char *word) {
  return r->next < r->count && strcmp(r->words[r->next], word) == 0;
}

void aspi_words_offer(const aspi_words *r, const char *list) {
  aspi_completions *completions = r->d->completions;
  if (!completions || r->next < r->count)
    return;
  completions->at_end = true;
  for (size_t n; *(list += strspn(list, " |")); list += n) {
    char word[64];
    n = strcspn(list, " |");
    snprintf(word, sizeof word, "%.*s", (int)n, list);
    if (!aspi_is_given(r->d, word) && !aspi_words_in_list(word, completions->list))
      aspi_append(completions->list, sizeof completions->list, "%s%s",
                  *completions->list ? " " : "", word);
  }
}

bool aspi_words_accept(aspi_words *r, const char *word) {
  aspi_words_offer(r, word);
  bool here = aspi_words_next_is(r, word);
  r->next += here;
  return here;
}

bool aspi_words_number_next(const aspi_words *r) {
  if (r->next >= r->count)
    return false;
  char *end;
  aspi_number(r->words[r->next], &end);
  return end > r->words[r->next];
}

const char *aspi_words_word(aspi_words *r, const char *name) {
  if (r->next < r->count)
    return r->words[r->next++];
  aspi_words_offer(r, "");
  aspi_fail(r->error, ASP_EARG, "'%s' needs a value", name);
  return NULL;
}

asp_code aspi_words_choice(aspi_words *r, const aspi_keyword *k, int *index) {
  aspi_words_offer(r, k->values);
  const char *given = aspi_words_word(r, k->name);
  int word = given ? aspi_word_index(k->values, given, strlen(given), true) : 0;
  *index = word / 2;
  if (!given)
    return ASP_EARG;
  return word >= 0 && word % 2 == 0 ? ASP_OK
                                    : aspi_fail(r->error, ASP_EARG, "%s is '%.100s'; it must be %s",
                                                k->name, given, k->values);
}

/* True if a word names a law, model or material without its clause, or a second law or model. */
static bool is_name(const aspi_words *r, const char *name) {
  const asp_description *d = r->d;
  const aspi_erosion_law *erosion = d->choice.erosion.law;
  const struct {
    const char *clause, *what, *present;
    bool has;
  } clauses[] = {{"rebound", "law", d->choice.law->name, asp_rebound_find(name, NULL)},
                 {"spread", "model", d->spread ? d->spread->name : "", asp_spread_find(name, NULL)},
                 {"erosion", "law", erosion ? erosion->name : "", aspi_erosion_find(name, NULL)},
                 {"materials", NULL, NULL, aspi_materials_find(NULL, name, NULL)}};
  for (size_t i = 0; i < sizeof clauses / sizeof *clauses; i++) {
    const char *clause = clauses[i].clause;
    if (!clauses[i].has)
      continue;
    if (!aspi_is_given(d, clause))
      aspi_fail(r->error, ASP_ENAME, "'%s' belongs behind '%s': %s %s", name, clause, clause, name);
    else if (clauses[i].what)
      aspi_fail(r->error, ASP_ENAME, "%s takes one %s; '%s' follows '%s'", clause, clauses[i].what,
                name, clauses[i].present);
    return !aspi_is_given(d, clause) || clauses[i].what;
  }
  return false;
}

static bool has_word(const aspi_keyword *parameters, int count, const char *word) {
  while (count > 0 && strcmp(aspi_keyword_word(&parameters[count - 1]), word) != 0)
    count--;
  return count > 0;
}

/* True if a word belongs to a law: the wall's own, or another. */
static bool is_of_law(const aspi_words *r, const char *word) {
  const asp_rebound_law *rebound = r->d->choice.law;
  const aspi_erosion_law *erosion = NULL;
  for (int i = 0; rebound && !has_word(rebound->parameters, rebound->n_parameters, word); i++)
    rebound = asp_rebound_at(i);
  for (int i = 0; i < aspi_erosion_count() && !rebound && !erosion; i++)
    if (has_word(aspi_erosion_at(i)->parameters, aspi_erosion_at(i)->n_parameters, word))
      erosion = aspi_erosion_at(i);
  if (rebound || erosion)
    aspi_fail(r->error, ASP_ENAME, "'%s' belongs to '%s %s'; put it behind these words", word,
              rebound ? "rebound" : "erosion", rebound ? rebound->name : erosion->name);
  return rebound || erosion;
}

bool aspi_words_misplaced(const aspi_words *r, const char *name) {
  for (const aspi_keyword *k = aspi_keywords; k->name; k++) {
    if (!*k->within || strcmp(k->name, name) != 0)
      continue;
    bool here = strcmp(k->within, r->d->last) == 0;
    aspi_fail(r->error, ASP_ENAME, "'%s' %s '%s': %s%s %s%s%s", name,
              here ? "has no place here behind" : "belongs behind", k->within, k->within,
              strcmp(k->within, "spread") == 0 ? " MODEL" : "", name, *k->values ? " " : "",
              k->values);
    return true;
  }
  return *name && (is_name(r, name) || is_of_law(r, name));
}

char *aspi_words_copy(const char *text, asp_error *error) {
  size_t size = strlen(text) + 1;
  char *made = malloc(size);
  if (!made)
    aspi_fail(error, ASP_ENOMEM, "out of memory for a description");
  return made ? memcpy(made, text, size) : NULL;
}

asp_code aspi_words_file(aspi_words *r, const char *name, char **file) {
  aspi_words_offer(r, "FILE");
  const char *given = aspi_words_word(r, name);
  if (!given)
    return ASP_EARG;
  if (strcmp(given, "-") == 0)
    return aspi_fail(r->error, ASP_EARG, "%s is '-'; it must be the name of a file", name);
  free(*file);
  *file = aspi_words_copy(given, r->error);
  return *file ? ASP_OK : ASP_ENOMEM;
}

asp_code aspi_words_check_one(const aspi_words *r, const char *list) {
  const char *second = aspi_given_of(r->d, list, 1);
  return second ? aspi_fail(r->error, ASP_EARG, "'%s' and '%s' are given; it must be one",
                            aspi_given_of(r->d, list, 0), second)
                : ASP_OK;
}

asp_code aspi_words_check_units(const aspi_words *r, const char *name) {
  if (aspi_quantity_factor("stress", &r->d->units) > 0)
    return ASP_OK;
  return aspi_fail(r->error, ASP_EARG, "'%s' is in SI units, which cannot be converted to %s", name,
                   r->d->units.name);
}

/* The start of a fit where none is given. */
static asp_code default_start(aspi_words *r, const aspi_keyword *k, double *value) {
  char units[120];
  aspi_quantity_units(k->unit, units, sizeof units);
  *value = k->default_value * aspi_quantity_factor(k->unit, &r->d->units);
  return strcmp(k->unit, "length") != 0
             ? ASP_OK
             : aspi_fail(
                   r->error, ASP_EARG,
                   "a fit of %s needs a value to begin with: say '%s fit=VALUE', in one of: %s",
                   k->name, k->name, units);
}

asp_code aspi_words_number(aspi_words *r, const aspi_keyword *k, double *value) {
  asp_description *d = r->d;
  const char *given = aspi_words_word(r, k->name), *start = given;
  if (!given)
    return ASP_EARG;
  bool begins = strncmp(given, "fit=", 4) == 0;
  bool unknown = d->fittable && k->fittable && (begins || strcmp(given, "fit") == 0);
  if (unknown)
    start = begins ? given + 4 : NULL;
  asp_code code = start ? aspi_quantity_read(k->name, start, k->unit, &d->units, value, r->error)
                        : default_start(r, k, value);
  if (!code && start)
    code = aspi_keyword_check(k, start, *value, r->error);
  if (code || !unknown)
    return code;
  if (d->n_fitted == ASPI_FITS_MOST)
    return aspi_fail(r->error, ASP_EARG, "at most %d numbers can be fitted; drop one, e.g. %s",
                     ASPI_FITS_MOST, k->name);
  d->fitted[d->n_fitted++] = k->name;
  return ASP_OK;
}

const char *aspi_quote_end(const char *begin) {
  const char *at = begin + 1;
  while ((at = strchr(at, *begin)) && at[1] == *begin)
    at += 2;
  return at;
}

void aspi_line_word(aspi_line *l, const char *word) {
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

void aspi_line_name(aspi_line *l, const char *name) {
  char *quoted = strpbrk(name, " \t\r\n\"'") || !*name ? malloc(2 * strlen(name) + 3) : NULL;
  if (quoted) {
    char *to = quoted, quote = strchr(name, '"') && !strchr(name, '\'') ? '\'' : '"';
    *to++ = quote;
    for (const char *c = name; *c; *to++ = *c++)
      if (*c == quote)
        *to++ = quote;
    *to++ = quote;
    *to = '\0';
  }
  aspi_line_word(l, quoted ? quoted : name);
  free(quoted);
}

void aspi_line_word_of(aspi_line *l, const char *list, int number) {
  char word[40];
  for (; number > 0; number--)
    list += strcspn(list, " ") + 1;
  snprintf(word, sizeof word, "%.*s", (int)strcspn(list, " "), list);
  aspi_line_word(l, word);
}

void aspi_line_number(aspi_line *l, double value) {
  char text[32];
  aspi_number_print(value, text);
  aspi_line_word(l, text);
}

/* In SI a length over 1 mm and a stress under 1 MPa get their unit, since the command refuses them
 * without one. */
void aspi_line_value(aspi_line *l, const asp_description *d, const char *name, const char *kind,
                     double value) {
  bool is_si = !(d->units.meter < 1) && !(d->units.meter > 1);
  bool length = is_si && strcmp(kind, "length") == 0 && isfinite(value) && value > 1e-3;
  char text[48] = "fit=", *number = text + strlen(text);
  aspi_number_print(value, number);
  if (length)
    strcat(number, "m");
  if (is_si && strcmp(kind, "stress") == 0 && value > 0 && value < 1e6)
    strcat(number, "Pa");
  aspi_line_word(l, !aspi_is_fit(d, name) ? number : isnan(value) ? "fit" : text);
}
