/* A word of a wall's description: a keyword of the table in description/keywords.c, or a parameter
 * of a law. Parser, canonical text, messages, help, completion and fits all read these records.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* When a keyword is in the canonical text. */
typedef enum aspi_print {
  ASPI_PRINT_IF_SET,
  ASPI_PRINT_IF_ROUGH,
  ASPI_PRINT,
  ASPI_PRINT_NEVER
} aspi_print;

/* Conditions on the rest of a description without which a word has no effect; bits. */
typedef enum aspi_need {
  ASPI_ROUGH = 1,      /* a rough wall */
  ASPI_SIZES = 2,      /* a model that is prepared for diameters */
  ASPI_PAIR = 4,       /* a rebound law with materials */
  ASPI_NO_MU = 8,      /* a rebound law without a friction of its own */
  ASPI_STICKS = 16,    /* not `deposit off` */
  ASPI_FREEZES = 32,   /* deposit freeze */
  ASPI_NO_RATE = 64,   /* a yield stress that is not a rate */
  ASPI_IS_HOT = 128,   /* a temperature at which the law softens */
  ASPI_HAS_YIELD = 256 /* a yield stress or a rate in the words */
} aspi_need;

/* Places are offsets in the description; a keyword has one of `number`, `string` and `choice`, the
 * other offsets are 0. A parameter has its place in its law. */
typedef struct aspi_keyword {
  const char *name;
  const char *unit;     /* of a number: its kind, as "length"; "": it has none */
  double default_value; /* the value, or the start of a fit, if none is given; SI */
  double least, most;   /* range of a number */
  const char *text;     /* the help; NULL: a value of the keyword it is within */
  const char *word;   /* parameters: the word in front, which several may share; "": the law's name;
                         NULL: its own name */
  const char *values; /* as a syntax shows them, a choice as "off | on"; parameters: NULL if it is
                         a number */
  const char *default_text; /* the default, as text; "" if there is none */
  const char *within; /* the keyword it belongs to; "": it begins a clause; NULL: a parameter */
  const char *after;  /* keywords of which one must come before it; "": it must be first; NULL:
                         any order */
  size_t number;      /* place of a double */
  size_t string;      /* place of a char * */
  size_t choice;      /* place of a byte: the word's number among the values */
  size_t flag;        /* place of a byte that the keyword sets to `sets` */
  uint8_t sets;
  bool above;    /* the number must be more than `least` */
  bool whole;    /* it must be a whole number */
  bool fittable; /* `asperity calibrate` can fit it */
  bool needed;   /* it must be given within its keyword */
  bool in_si;    /* its constants are in SI, so the caller's units must be known */
  aspi_print printed;
  unsigned needs; /* aspi_need bits */
} aspi_keyword;

/* The word in front of a parameter; "": it follows the law's name. */
static inline const char *aspi_keyword_word(const aspi_keyword *parameter) {
  return parameter->word ? parameter->word : parameter->name;
}
