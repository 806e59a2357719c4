/* A description: the words of a wall as they were read, and the table of keywords.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_DESCRIPTION_DESCRIPTION_H
#define ASP_DESCRIPTION_DESCRIPTION_H

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

typedef enum aspi_deposit { ASPI_FREEZE, ASPI_DELETE, ASPI_DEPOSIT_OFF } aspi_deposit;

struct asp_description {
  asp_units units;
  uint64_t given;   /* a bit for each keyword of the table */
  unsigned of_law;  /* a bit for each parameter of the law whose word is given */
  const char *last; /* the clause that was read last */
  asp_error broken; /* the error of a clause that could not be read; it stays */
  aspi_surface_kind kind;
  double sigma; /* degrees */
  double r_q, lambda_c, lambda_along;
  double r_sm; /* where lambda_c comes of it, with no sampling length; else NaN */
  char *file;  /* of the profile or the map */
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
  double friction, surface_energy, yield_stress;
  aspi_deposit deposit;
  double seed;
  /* True lets numbers that may be unknown be `fit`, or `fit=START` in place of START: those of the
   * law, and of keywords with `may_fit`. Such a number has the value START, else that of its
   * default, else it is NaN: that of the materials. It is unknown until it is set. */
  bool may_fit;
  const char *fits[ASPI_FITS_MOST]; /* those that are, by name, in order */
  int n_fits;
  aspi_wall_choice choice;  /* the wall of these words; the surface of a profile is still to come */
  asp_surface *surface;     /* of the numbers or the map; NULL: to be made */
  asp_profile *profile;     /* read from the file; NULL: the caller's, or not read yet */
  asp_map *map;             /* alike */
  asp_map_numbers measured; /* of the map whose surface was made */
  asp_error doubt;          /* about the file that was read */
  aspi_cor_table *cor_table;
};

int aspi_keyword_count(void);

/* The word `name` within another one; NULL: it is none. */
const asp_keyword *aspi_keyword_find(const char *within, const char *name);

/* The words within one, with blanks between; `""` for those of clauses. */
void aspi_keyword_names(const char *within, char *list, size_t size);

/* Checks a number's range, and that it is whole where it must be. */
asp_code aspi_keyword_check(const asp_keyword *keyword, double value, asp_error *error);

/* An empty description: a smooth wall. */
asp_description *aspi_description_create(const asp_units *units, asp_error *error);

/* True if a word of a clause is given, by its name in the table, or a word of the law. */
bool aspi_is_given(const asp_description *d, const char *name);
void aspi_set_given(asp_description *d, const char *name);

/* The word that a flag stands for. Writes it to `word`. */
void aspi_keyword_choice(const asp_keyword *keyword, const asp_description *d, char word[20]);

/* ASP_ERANGE and a message where the file of a wall tells little about spheres of diameter d_p:
 * where they cover under 10 points, or it is under 20 correlation lengths long. */
asp_code aspi_description_check_sampling(const asp_description *description, const asp_wall *wall,
                                         double d_p, asp_error *error);

/* True if a number is unknown. */
bool aspi_is_fit(const asp_description *d, const char *name);

#endif
