/* The canonical text of a description.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "description/words.h"

static bool is_shown(const asp_description *d, const aspi_keyword *k) {
  const uint8_t *flag = (const uint8_t *)d + k->flag;
  return (!k->flag || *flag == k->sets) &&
         (k->printed == ASPI_PRINT ||
          (k->printed == ASPI_PRINT_IF_ROUGH && d->kind != ASPI_SMOOTH) ||
          (k->printed != ASPI_PRINT_NEVER && d->given & aspi_keyword_bit(k)));
}

static void write_value(aspi_line *l, const asp_description *d, const aspi_keyword *k) {
  const void *place = (const char *)d + k->number + k->string + k->choice;
  const aspi_form *form = aspi_form_of(k);
  if (form->write)
    form->write(l, d, k);
  else if (k->number)
    aspi_line_value(l, d, k->name, k->unit, *(const double *)place);
  else if (k->string)
    aspi_line_name(l, *(char *const *)place);
  else if (k->choice)
    aspi_line_word_of(l, k->values, 2 * *(const uint8_t *)place);
}

/* Writes all keywords within one. A keyword that needs values or words behind it is left out
 * without them. */
static void write_within(aspi_line *l, const asp_description *d, const char *within) {
  for (const aspi_keyword *k = aspi_keywords; k->name; k++) {
    if (strcmp(k->within, within) != 0 || !is_shown(d, k))
      continue;
    const size_t before = l->length;
    aspi_line_word(l, k->name);
    const size_t name = l->length;
    write_value(l, d, k);
    write_within(l, d, k->name);
    if (l->length > name || !*k->values)
      continue;
    l->length = before;
    if (before < l->size)
      l->text[before] = '\0';
  }
}

size_t asp_description_text(const asp_description *d, char *text, size_t size) {
  aspi_line l = {text, size, 0};
  if (size > 0)
    *text = '\0';
  write_within(&l, d, "");
  return l.length;
}

/* Skips a word, or a name in quotes, and the blanks behind it. */
static const char *behind_word(const char *at) {
  const char *end = *at == '"' || *at == '\'' ? aspi_quote_end(at) : NULL;
  at = end ? end + 1 : at + strcspn(at, " ");
  return at + strspn(at, " ");
}

static bool begins_clause(const char *at) {
  size_t length = strcspn(at, " ");
  for (const aspi_keyword *k = aspi_keywords; k->name; k++)
    if (!*k->within && strlen(k->name) == length && strncmp(k->name, at, length) == 0)
      return true;
  return false;
}

size_t asp_description_clause(const char *text) {
  const char *at = behind_word(text);
  while (*at && !begins_clause(at))
    at = behind_word(at);
  return (size_t)(at - text);
}
