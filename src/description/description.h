/* A description: the words of a wall as they were read, and the table of keywords.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "base/keyword.h"
#include "surface/describe.h"
#include "wall/wall.h"

typedef enum aspi_surface_kind {
  ASPI_SMOOTH,
  ASPI_SIGMA,
  ASPI_GAUSSIAN,
  ASPI_PROFILE,
  ASPI_MAP
} aspi_surface_kind;

/* Numbers of one description that may be unknown. */
enum { ASPI_FITS_MOST = 8 };

/* In the order of the keyword's values. */
typedef enum aspi_deposit { ASPI_FREEZE, ASPI_DELETE, ASPI_DEPOSIT_OFF } aspi_deposit;

struct asp_description {
  asp_units units;
  uint64_t given;                       /* a bit for each keyword of the table */
  unsigned of_law, of_erosion;          /* a bit for each given word of the law */
  const char *last;                     /* the clause that was read last */
  asp_error broken;                     /* the error of a clause that could not be read; it stays */
  struct aspi_completions *completions; /* NULL: they are not asked for */
  uint8_t kind;                         /* an aspi_surface_kind */
  uint8_t deposit;                      /* an aspi_deposit */
  double sigma;                         /* degrees */
  double r_q, lambda_c, lambda_along;
  double spacing, sampling; /* what an instrument prints in place of lambda_c */
  char *file;               /* of the profile or the map */
  asp_lay_kind lay;
  const char *lay_word; /* axial or circumferential; else NULL */
  double lay_numbers[3];
  double bins;
  const asp_spread_model *spread; /* NULL: none is given */
  char *table;
  char **names; /* of the materials */
  int n_materials;
  char *materials_file;
  aspi_materials *own;
  asp_material **materials; /* in the units of the caller */
  bool pairs_come;          /* with the particles */
  double friction, surface_energy, yield_stress;
  double seed;
  /* If true, a number of the law or of a `fittable` keyword may be `fit` or `fit=START`. Until the
   * fit sets it, its value is START if given, else the default, else NaN: it comes from the
   * materials. */
  bool fittable;
  const char *fitted[ASPI_FITS_MOST]; /* names of the numbers that are `fit`, in order */
  int n_fitted;
  aspi_wall_choice choice; /* without what aspi_description_choice adds */
  aspi_cor_table *cor_table;
};

/* ---- the table of keywords ---- */

/* All keywords; the last one has no name. */
extern const aspi_keyword aspi_keywords[];

/* The keyword of that name that begins a clause; NULL: there is none. */
const aspi_keyword *aspi_keyword_find(const char *name);

/* The keyword's bit in `given`. */
uint64_t aspi_keyword_bit(const aspi_keyword *keyword);

/* A number that asp_description_get and _set know: a parameter of the rebound law, else of a
 * keyword; NULL: there is none. *place: its offset in the description. */
const aspi_keyword *aspi_number_find(const asp_description *d, const char *name, size_t *place);

/* Adds the words within one to a list, with blanks between. */
void aspi_keyword_names(const char *within, char *list, size_t size);

/* Checks a number's range, and that it is whole if it must be; `given` is its text. */
asp_code aspi_keyword_check(const aspi_keyword *keyword, const char *given, double value,
                            asp_error *error);

/* ---- content ---- */

/* An empty description: a smooth wall. */
asp_description *aspi_description_create(const asp_units *units, asp_error *error);

/* True if a word of a clause is given, by its name in the table, or a word of the law. */
bool aspi_is_given(const asp_description *d, const char *name);
void aspi_set_given(asp_description *d, const char *name);

/* The nth (from 0) given keyword of a list; NULL: there are fewer. */
const char *aspi_given_of(const asp_description *d, const char *list, int nth);

/* True if a number is unknown. */
bool aspi_is_fit(const asp_description *d, const char *name);

/* The spread model given, or the surface's default. */
const asp_spread_model *aspi_description_spread(const asp_description *d);

/* The parts of the wall given by words, without surface, diameters and pair. */
aspi_wall_choice aspi_description_choice(const asp_description *d);

/* The surface of a wall that is given by numbers. */
asp_surface *aspi_description_surface(const asp_description *d, asp_error *error);

/* heat.c: ASP_EARG if a keyword lacks the form of its curve, ASP_ERANGE if the curves do not hold
 * at the description's temperature. */
asp_code aspi_description_check_curves(const asp_description *d, asp_error *error);

/* ---- heights of a file ---- */

/* Reads the file of a measured wall, unless the caller has set heights. *heights is NULL if there
 * is nothing to read. *doubt: a warning about the file. */
asp_code aspi_heights_read(const asp_description *d, asp_heights **heights, asp_error *doubt,
                           asp_error *error);
