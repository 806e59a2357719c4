/* The words of a description that the wall itself does not keep, and the table of keywords.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_WALL_DESCRIPTION_H
#define ASP_WALL_DESCRIPTION_H

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

typedef enum aspi_deposit { ASPI_FREEZE, ASPI_DELETE, ASPI_DEPOSIT_OFF } aspi_deposit;

struct aspi_description {
  asp_units units;
  uint64_t given;   /* a bit for each keyword of the table */
  const char *last; /* the clause that was read last */
  aspi_surface_kind kind;
  double sigma; /* degrees */
  double r_q, lambda_c, lambda_along;
  char *file; /* of the profile or the map */
  asp_lay_kind lay;
  const char *lay_word; /* axial or circumferential; else NULL */
  double lay_numbers[3];
  double bins;
  const asp_spread_model *spread; /* NULL: auto, or none is given */
  bool chooses;                   /* spread auto */
  double tolerance;
  char choice[400]; /* of auto, and why */
  asp_error doubt;  /* about the file, once asp_wall_make has read it */
  char *table;
  char **names; /* of the materials */
  int n_materials;
  char *materials_file;
  aspi_materials *own;
  asp_material **materials; /* in the units of the caller */
  double friction, surface_energy, yield_stress;
  aspi_deposit deposit;
  double seed;
  /* True lets numbers that may be unknown be `fit`, or `fit=START` in place of START: those of the
   * law, and of keywords with `may_fit`. Such a number has the value START, else that of its
   * default, else it is NaN: that of the materials. It is unknown until it is set. */
  bool may_fit;
  const char *fits[ASPI_FITS_MOST]; /* those that are, by name, in order */
  int n_fits;
  asp_surface *surface; /* what the description makes of it */
  asp_profile *profile; /* read by asp_wall_make; else NULL */
  asp_map *map;
  aspi_cor_table *cor_table;
};

/* A word of a description. */
typedef struct aspi_keyword {
  const char *name;
  const char *within; /* the keyword that it belongs to; "" where it begins a clause of its own */
  const char *values; /* as a syntax shows them; "" for none */
  const char *unit;   /* of a number: its kind, as aspi_quantity_read has them; NULL: no number */
  double fallback, least, most;
  bool above; /* it must be more than `least` */
  bool whole;
  bool may_fit;         /* see aspi_description */
  const char *standard; /* the default, as text; "" where there is none */
  const char *text;
} aspi_keyword;

int aspi_keyword_count(void);
const aspi_keyword *aspi_keyword_at(int index);

/* The word `name` within another one, which must be there. */
const aspi_keyword *aspi_keyword_find(const char *within, const char *name);

/* The words within one, with blanks between; `""` for those of clauses. */
void aspi_keyword_names(const char *within, char *list, size_t size);

/* True if a word of a clause is given, by its name in the table. */
bool aspi_is_given(const aspi_description *said, const char *name);
void aspi_set_given(aspi_description *said, const char *name);

/* Says of the first given word without an effect what it has none with. */
asp_code aspi_check_effects(const asp_wall *wall, asp_error *error);

void aspi_description_free(aspi_description *said);

/* A number's range, and that it is whole where it must be. */
asp_code aspi_keyword_check(const aspi_keyword *keyword, double value, asp_error *error);

/* A number of the description by name; NULL for another name. */
double *aspi_description_number(aspi_description *said, const char *name);

/* The value of such a number; NaN for another name, or if it is not given. */
double aspi_description_get(const aspi_description *said, const char *name);

/* Sets sigma, or rq and lambda_c, where the surface is given by them; friction, surface_energy,
 * yield_stress, tolerance or seed. ASP_ENAME without a message for another name. */
asp_code aspi_description_set(aspi_description *said, const char *name, double value,
                              asp_error *error);

/* True if a number is unknown; know: no longer. */
void aspi_description_know(aspi_description *said, const char *name);
bool aspi_is_fit(const aspi_description *said, const char *name);

/* The surface that the numbers of the description, or the wall's map, make. */
asp_code aspi_make_surface(asp_wall *wall, asp_error *error);

#endif
