/* Reads the description of a wall, clause by clause; see keywords.c for its words.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/number.h"
#include "base/quantity.h"
#include "description/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static asp_code read_model(aspi_words *r) {
  const char *name = aspi_words_word(r, "the spread model");
  if (!name)
    return ASP_EARG;
  char list[ASPI_LIST_MOST] = "";
  for (int i = 1; i < asp_spread_count(); i++) { /* 0 is `none`, that of smooth walls */
    size_t used = strlen(list);
    snprintf(list + used, sizeof list - used, "%s%s", used ? " " : "",
             asp_spread_name(asp_spread_at(i)));
  }
  r->d->spread = asp_spread_find(name, NULL);
  return r->d->spread && r->d->spread != asp_spread_at(0)
             ? ASP_OK
             : aspi_fail_unknown(r->error, "spread model", name, list);
}

static asp_code read_spread(aspi_words *r) {
  asp_description *d = r->d;
  bool any;
  asp_code code = read_model(r);
  if (!code)
    code = aspi_words_values(r, "spread", &any);
  if (code || !aspi_is_given(d, "plane"))
    return code;
  if (aspi_is_given(d, "isotropic"))
    return aspi_fail(r->error, ASP_EARG, "'plane' and 'isotropic' are given; it must be one");
  d->choice.isotropic = false;
  return ASP_OK;
}

/* A law as its clause reads it. */
typedef struct law_clause {
  const asp_parameter *parameters;
  int count;
  bool may_fit, positive; /* positive: those whose least value is 0 are more than that */
  unsigned given;         /* a bit for each parameter */
  asp_code (*take)(aspi_words *r, const asp_parameter *p, int index, double value);
} law_clause;

static asp_code read_parameter(aspi_words *r, const law_clause *l, int index) {
  const asp_parameter *p = &l->parameters[index];
  const char *given = aspi_words_word(r, p->name), *start = given;
  if (!given)
    return ASP_EARG;
  double value = p->fallback;
  bool unknown = l->may_fit && !p->words && aspi_words_unknown(r, given, &start);
  asp_code code = ASP_OK;
  if (p->words)
    code = aspi_parameter_read(p, given, &value, r->error);
  else if (start)
    code = aspi_quantity_read(p->name, start, p->unit, &r->d->units, &value, r->error);
  if (!code && start && !p->words)
    code = aspi_quantity_check(p->name, start, p->unit, value, p->least, p->most,
                               l->positive && !(p->least < 0), r->error);
  if (!code)
    code = l->take(r, p, index, value);
  return !code && unknown ? aspi_words_add_unknown(r, p->name) : code;
}

/* The values of all parameters of a law that follow one word; "": its name. */
static asp_code read_parameters(aspi_words *r, const law_clause *l, const char *keyword) {
  asp_code code = ASP_OK;
  for (int i = 0; i < l->count && !code; i++)
    if (strcmp(aspi_parameter_keyword(&l->parameters[i]), keyword) == 0)
      code = read_parameter(r, l, i);
  return code;
}

/* The parameters of the next word; *more is false where it has none. */
static asp_code read_more(aspi_words *r, law_clause *l, bool *more) {
  for (int i = 0; i < l->count; i++) {
    const char *keyword = aspi_parameter_keyword(&l->parameters[i]);
    if (!*keyword || !aspi_words_take(r, keyword))
      continue;
    if (l->given >> i & 1)
      return aspi_fail(r->error, ASP_EARG, "'%s' is given twice", keyword);
    l->given |= 1u << i;
    return read_parameters(r, l, keyword);
  }
  *more = false;
  return ASP_OK;
}

/* All that follows: keywords within the clause, and words of the law. */
static asp_code read_rest(aspi_words *r, law_clause *l, const char *within) {
  asp_code code = ASP_OK;
  for (bool more = true, any; more && !code; more = more || any) {
    code = aspi_words_values(r, within, &any);
    if (!code)
      code = read_more(r, l, &more);
  }
  return code;
}

static asp_code read_table(aspi_words *r) {
  asp_description *d = r->d;
  asp_code code = aspi_words_file(r, "the file of 'rebound table'", &d->table);
  if (!code)
    code = aspi_words_check_units(r, "a table is");
  if (code)
    return code;
  aspi_cor_table_free(d->cor_table);
  d->cor_table = aspi_cor_table_read(d->table, d->units.meter / d->units.second, r->error);
  d->choice.table = d->cor_table;
  return d->cor_table ? ASP_OK : ASP_EDATA;
}

static asp_code take_parameter(aspi_words *r, const asp_parameter *p, int index, double value) {
  (void)index;
  return asp_description_set(r->d, p->name, value, r->error);
}

/* A law's parameters follow its name, or words of their own, some of them one for several. */
static asp_code read_rebound(aspi_words *r) {
  const char *name = aspi_words_word(r, "the rebound law");
  const asp_rebound_law *of = name ? asp_rebound_find(name, r->error) : NULL;
  if (!of)
    return name ? ASP_ENAME : ASP_EARG;
  law_clause l = {of->parameters, of->n_parameters, true, false, 0, take_parameter};
  aspi_wall_choose_law(&r->d->choice, of);
  asp_code code = read_parameters(r, &l, "");
  if (!code && of->needs_table)
    code = read_table(r);
  if (!code)
    code = read_rest(r, &l, "rebound");
  r->d->of_law = l.given;
  return code;
}

static asp_code take_erosion(aspi_words *r, const asp_parameter *p, int index, double value) {
  aspi_erosion *erosion = &r->d->choice.erosion;
  erosion->given[index] = value;
  erosion->si[index] = p->words ? value : value / aspi_quantity_factor(p->unit, &r->d->units);
  return ASP_OK;
}

static asp_code read_erosion(aspi_words *r) {
  aspi_erosion *erosion = &r->d->choice.erosion;
  r->of = " of 'erosion'";
  const char *name = aspi_words_word(r, "the law");
  const aspi_erosion_law *of = name ? aspi_erosion_find(name, r->error) : NULL;
  if (!of)
    return name ? ASP_ENAME : ASP_EARG;
  asp_code code = aspi_words_check_units(r, "erosion is");
  if (code)
    return code;
  aspi_erosion_take(erosion, of, &r->d->units);
  law_clause l = {of->parameters, of->n_parameters, false, true, 0, take_erosion};
  code = read_parameters(r, &l, "");
  return code ? code : read_rest(r, &l, "erosion");
}

static asp_code read_removal(aspi_words *r) {
  aspi_set_given(r->d, "remove");
  asp_code code = aspi_words_check_units(r, "removal is");
  r->d->choice.flow.micron = 1e-6 * aspi_quantity_factor("length", &r->d->units);
  bool any;
  if (!code)
    code = aspi_words_values(r, "remove", &any);
  if (!code && !(aspi_is_given(r->d, "gas_density") && aspi_is_given(r->d, "gas_viscosity")))
    code = aspi_fail(r->error, ASP_EARG,
                     "behind 'remove', 'u_tau U gas_density RHO gas_viscosity NU' is expected");
  return code;
}

static asp_code read_deposit(aspi_words *r) {
  static const char *const kinds[] = {"freeze", "delete", "off"};
  const char *given = aspi_words_word(r, "the value of 'deposit'");
  if (!given)
    return ASP_EARG;
  int kind = 0;
  while (kind < 3 && strcmp(given, kinds[kind]) != 0)
    kind++;
  if (kind == 3)
    return aspi_fail(r->error, ASP_EARG, "deposit is '%.100s'; it must be freeze, delete or off",
                     given);
  r->d->deposit = (aspi_deposit)kind;
  r->d->choice.deposit = r->d->deposit != ASPI_DEPOSIT_OFF;
  return aspi_words_take(r, "remove") ? read_removal(r) : ASP_OK;
}

static asp_code read_grain(aspi_words *r) {
  bool known = aspi_words_take(r, "sphere");
  asp_code code = known ? ASP_OK : aspi_words_values(r, "grain", &known);
  if (code || known)
    return code;
  const char *given = aspi_words_word(r, "the value of 'grain'");
  return given ? aspi_fail(r->error, ASP_EARG, "grain is '%.100s'; it must be sphere or lever S",
                           given)
               : ASP_EARG;
}

/* Clauses that are more than a number. */
static const struct {
  const char *name;
  asp_code (*read)(aspi_words *r);
} clauses[] = {{"surface", aspi_words_surface}, {"spread", read_spread},
               {"rebound", read_rebound},       {"materials", aspi_words_materials},
               {"deposit", read_deposit},       {"grain", read_grain},
               {"erosion", read_erosion}};

static asp_code read_clause(aspi_words *r, const asp_keyword *k) {
  for (size_t i = 0; i < sizeof clauses / sizeof *clauses; i++)
    if (strcmp(clauses[i].name, k->name) == 0)
      return clauses[i].read(r);
  return aspi_words_value(r, k);
}

/* The clause that a name of a law, a model or a material belongs to; NULL: it is none. */
static const char *find_clause(const char *name) {
  return asp_rebound_find(name, NULL)            ? "rebound"
         : asp_spread_find(name, NULL)           ? "spread"
         : aspi_erosion_find(name, NULL)         ? "erosion"
         : aspi_materials_find(NULL, name, NULL) ? "materials"
                                                 : NULL;
}

/* Says where the word belongs, or lists those allowed at the start of a clause: those of all
 * clauses, of the last one, and the caller's. */
static asp_code fail_keyword(const aspi_words *r, const char *name) {
  if (aspi_words_misplaced(r, name))
    return ASP_ENAME;
  const char *clause = find_clause(name);
  if (clause && !aspi_is_given(r->d, clause))
    return aspi_fail(r->error, ASP_ENAME, "'%s' belongs behind '%s': %s %s", name, clause, clause,
                     name);
  char list[ASPI_LIST_MOST];
  aspi_keyword_names("", list, sizeof list);
  for (int i = 0; i < aspi_keyword_count(); i++) {
    const asp_keyword *k = asp_keyword_at(i);
    size_t used = strlen(list);
    if (*r->d->last && strcmp(k->within, r->d->last) == 0)
      snprintf(list + used, sizeof list - used, " %s", k->name);
  }
  const asp_rebound_law *of = r->d->choice.law;
  for (int i = 0; i < of->n_parameters && strcmp(r->d->last, "rebound") == 0; i++) {
    const char *keyword = aspi_parameter_keyword(&of->parameters[i]);
    size_t used = strlen(list);
    if (!aspi_words_in_list(keyword, list))
      snprintf(list + used, sizeof list - used, " %s", keyword);
  }
  size_t used = strlen(list);
  snprintf(list + used, sizeof list - used, "%s%s", *r->others ? " " : "", r->others);
  return aspi_fail_unknown(r->error, "keyword", name, list);
}

asp_code asp_description_read(asp_description *d, int count, const char *const *words,
                              const char *others, int *taken, asp_error *error) {
  others = others ? others : "";
  asp_error wrong = d->broken;
  aspi_words r = {d, words, count, 1, others, &wrong, ""};
  *taken = 0;
  if (d->broken.code)
    return aspi_fail(error, wrong.code, "%s", wrong.text);
  if (count <= 0 || aspi_words_in_list(words[0], others))
    return ASP_OK;
  const asp_keyword *k = aspi_keyword_find("", words[0]);
  asp_code code = k ? ASP_OK : fail_keyword(&r, words[0]);
  if (!code && aspi_is_given(d, words[0]))
    code = aspi_fail(&wrong, ASP_EARG, "'%s' is given twice", words[0]);
  if (!code) {
    aspi_set_given(d, words[0]);
    d->last = k->name;
    code = read_clause(&r, k);
    *taken = r.next;
  }
  if (!code)
    return ASP_OK;
  d->broken = wrong;
  return aspi_fail(error, code, "%s", wrong.text);
}

/* Cuts a text into words, in place; quotes hold one together. The number of words, and where there
 * is room for them, these; -1 where a quote has no end. */
static int split(char *text, const char **words) {
  int count = 0;
  for (char *at = text; *(at += strspn(at, " \t\r\n"));) {
    char quote = *at == '"' || *at == '\'' ? *at++ : '\0';
    char *end = quote ? strchr(at, quote) : at + strcspn(at, " \t\r\n");
    if (!end)
      return -1;
    if (words)
      words[count] = at;
    count++;
    at = end + (*end != '\0');
    if (words)
      *end = '\0';
  }
  return count;
}

static asp_code parse(asp_description *d, char *text, asp_error *error) {
  int count = split(text, NULL), next = 0, taken;
  if (count < 0)
    return aspi_fail(error, ASP_EARG, "a quote in the description has no end");
  const char **words = calloc((size_t)count + 1, sizeof *words);
  if (!words)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a description");
  split(text, words);
  asp_code code = ASP_OK;
  while (next < count && !code) {
    code = asp_description_read(d, count - next, words + next, "", &taken, error);
    next += taken;
  }
  free(words);
  return code ? code : asp_description_complete(d, error);
}

asp_description *asp_description_parse(const char *text, const asp_units *units, asp_error *error) {
  if (!text) {
    aspi_fail(error, ASP_EARG, "the text of a description is NULL");
    return NULL;
  }
  asp_description *d = aspi_description_create(units, error);
  char *words = d ? aspi_words_copy(text, error) : NULL;
  asp_code code = words ? parse(d, words, error) : ASP_ENOMEM;
  free(words);
  if (!code)
    return d;
  asp_description_free(d);
  return NULL;
}
