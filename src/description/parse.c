/* Reads the description of a wall, clause by clause; see keywords.c for its words.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "description/words.h"

#include <stdlib.h>

/* True if the keyword may be the next word; `first`: that is the first one behind its keyword. */
static bool may_be_next(const aspi_words *r, const aspi_keyword *k, bool first) {
  return !k->after || (*k->after ? aspi_is_given(r->d, k->after) : first);
}

/* Accepts the next word if it is a keyword within `of`; NULL: it is not. */
static const aspi_keyword *take_keyword(aspi_words *r, const aspi_keyword *of, bool first,
                                        asp_code *code) {
  for (const aspi_keyword *k = aspi_keywords; k->name; k++) {
    if (strcmp(k->within, of->name) != 0 || !may_be_next(r, k, first) ||
        !aspi_words_accept(r, k->name))
      continue;
    if (aspi_is_given(r->d, k->name))
      *code = aspi_fail(r->error, ASP_EARG, "'%s' is given twice", k->name);
    return k;
  }
  return NULL;
}

static asp_code read_choice(aspi_words *r, const aspi_keyword *k, uint8_t *place) {
  int index;
  asp_code code = aspi_words_choice(r, k, &index);
  *place = (uint8_t)index;
  return code;
}

/* A keyword's value to its place. */
static asp_code read_value(aspi_words *r, const aspi_keyword *k) {
  void *place = (char *)r->d + k->number + k->string + k->choice; /* a keyword has one of them */
  if (k->flag)
    *((uint8_t *)r->d + k->flag) = k->sets;
  const aspi_form *form = aspi_form_of(k);
  return form->read  ? form->read(r, k)
         : k->number ? aspi_words_number(r, k, place)
         : k->string ? aspi_words_file(r, k->name, place)
         : k->choice ? read_choice(r, k, place)
                     : ASP_OK;
}

/* Checks what had to follow a keyword, of which there were `any`. */
static asp_code check_within(aspi_words *r, const aspi_keyword *of, bool any) {
  for (const aspi_keyword *k = aspi_keywords; k->name; k++)
    if (strcmp(k->within, of->name) == 0 && k->needed && !aspi_is_given(r->d, k->name))
      return aspi_fail(r->error, ASP_EARG, "behind '%s', '%s %s' is expected", of->name, k->name,
                       k->values);
  bool has_value = aspi_form_of(of)->read || of->number || of->string || of->choice || !*of->values;
  if (any || has_value)
    return ASP_OK;
  const char *given = aspi_words_word(r, of->name);
  return given ? aspi_fail(r->error, ASP_ENAME, "%s is '%.100s'; it must be %s", of->name, given,
                           of->values)
               : ASP_EARG;
}

/* Names a misspelled word within the keyword in place of the word that is missing. */
static asp_code fail_within(const aspi_words *r, const aspi_keyword *of, asp_code code) {
  char list[ASPI_LIST_MOST] = "", near[64];
  const char *next = r->next < r->count ? r->words[r->next] : "";
  aspi_keyword_names(of->name, list, sizeof list);
  bool is_own = !aspi_keyword_find(next) && !aspi_words_in_list(next, r->others);
  return *next && is_own && !aspi_words_in_list(next, list) && aspi_nearest_name(next, list, near)
             ? aspi_fail_unknown(r->error, "keyword", next, list)
             : code;
}

/* Reads the value of a keyword, and the keywords within it. */
static asp_code read_keyword(aspi_words *r, const aspi_keyword *k) {
  r->d->given |= aspi_keyword_bit(k);
  asp_code code = read_value(r, k);
  if (!code && k->in_si)
    code = aspi_words_check_units(r, k->name);
  const aspi_form *form = aspi_form_of(k);
  bool any = false;
  for (bool more = true; more && !code; any = any || more) {
    const aspi_keyword *in = take_keyword(r, k, !any, &code);
    more = in || (form->parameter && form->parameter(r, k, &code));
    if (in && !code)
      code = read_keyword(r, in);
  }
  if (code)
    return code;
  code = check_within(r, k, any);
  if (!code && form->finish)
    code = form->finish(r);
  return code ? fail_within(r, k, code) : ASP_OK;
}

/* Reports where the word belongs, or lists the words allowed here: keywords that begin a clause,
 * words of the last clause, and the caller's. */
static asp_code fail_keyword(const aspi_words *r, const char *name) {
  if (aspi_words_misplaced(r, name))
    return ASP_ENAME;
  char list[ASPI_LIST_MOST] = "";
  aspi_keyword_names("", list, sizeof list);
  if (*r->d->last)
    aspi_keyword_names(r->d->last, list, sizeof list);
  const asp_rebound_law *of = r->d->choice.law;
  for (int i = 0; i < of->n_parameters && strcmp(r->d->last, "rebound") == 0; i++) {
    const char *keyword = aspi_keyword_word(&of->parameters[i]);
    if (!aspi_words_in_list(keyword, list))
      aspi_append(list, sizeof list, " %s", keyword);
  }
  aspi_append(list, sizeof list, "%s%s", *r->others ? " " : "", r->others);
  return aspi_fail_unknown(r->error, "keyword", name, list);
}

asp_code asp_description_read(asp_description *d, int count, const char *const *words,
                              const char *others, int *taken, asp_error *error) {
  others = others ? others : "";
  asp_error wrong = d->broken;
  aspi_words r = {d, words, count, 1, others, &wrong};
  *taken = 0;
  if (d->broken.code)
    return aspi_fail(error, wrong.code, "%s", wrong.text);
  if (count <= 0 || aspi_words_in_list(words[0], others))
    return ASP_OK;
  const aspi_keyword *k = aspi_keyword_find(words[0]);
  asp_code code = k ? ASP_OK : fail_keyword(&r, words[0]);
  if (!code && aspi_is_given(d, words[0]))
    code = aspi_fail(&wrong, ASP_EARG, "'%s' is given twice", words[0]);
  if (!code) {
    d->last = k->name;
    code = read_keyword(&r, k);
    *taken = r.next;
  }
  if (!code)
    return ASP_OK;
  d->broken = wrong;
  return aspi_fail(error, code, "%s", wrong.text);
}

/* Cuts a text into words, in place; quotes hold one together. The number of words, and where there
 * is room for them, the words; -1 where a quote has no end. */
static int split(char *text, const char **words) {
  int count = 0;
  for (char *at = text; *(at += strspn(at, " \t\r\n"));) {
    bool quoted = *at == '"' || *at == '\'';
    char *end = quoted ? (char *)aspi_quote_end(at) : at + strcspn(at, " \t\r\n"), *to = at;
    if (!end)
      return -1;
    const char quote = *at;
    if (words)
      words[count] = at;
    count++;
    for (at += quoted; words && at < end; at += 1 + (quoted && *at == quote))
      *to++ = *at;
    at = end + (*end != '\0');
    if (words)
      *to = '\0';
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
  return code ? code : asp_description_check(d, error);
}

bool aspi_description_complete(aspi_completions *completions, int count, const char *const *words) {
  asp_error error;
  asp_description *d = aspi_description_create(NULL, &error);
  if (!d)
    return false;
  d->fittable = true;
  d->completions = completions;
  asp_code code = ASP_OK;
  for (int next = 0, taken; next < count && !code; next += taken)
    code = asp_description_read(d, count - next, words + next, "", &taken, &error);
  const aspi_words end = {.d = d};
  for (const aspi_keyword *k = aspi_keywords; k->name && !code; k++)
    if (!*k->within)
      aspi_words_offer(&end, k->name);
  bool may_end = !code || !completions->at_end;
  asp_description_free(d);
  return may_end;
}

asp_description *asp_description_parse(const char *text, const asp_units *units, asp_error *error) {
  if (!text)
    return aspi_fail_null(error, ASP_EARG, "the text of a description is NULL");
  asp_description *d = aspi_description_create(units, error);
  char *words = d ? aspi_words_copy(text, error) : NULL;
  asp_code code = words ? parse(d, words, error) : ASP_ENOMEM;
  free(words);
  if (!code)
    return d;
  asp_description_free(d);
  return NULL;
}
