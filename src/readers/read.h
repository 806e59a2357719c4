/* Shared by the readers of measured profiles and maps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "base/text.h"

/* The highest degree of a form. */
enum { ASP_FORM_MAX = 9 };

/* Options of reading a measured profile or map. */
typedef struct aspi_profile_options {
  double unit_x, unit_z; /* meters in one unit of a text file's columns; 0: as the file states */
  double meter;          /* one meter in the unit of the result: 1 for SI, 1e6 for micrometers */
  int form;              /* degree of the polynomial that is taken out as form, 0 to 9; -1: none */
  double spikes;         /* points this many robust sd off their neighbors are bad, and refused or
                            filled as those are; 0: none are */
  bool fill; /* bad points and gaps are filled by straight lines; false: they are refused */
  int row;   /* of an SDF map, or trace of a text file, from 1 */
  const char *column; /* NULL, or: of an SDF map, that column instead; of a text file, the heights,
                         by number from 1 or by name */
  const char *x_column; /* of a text file, the positions alike; NULL: by the header */
  double step[2];  /* m, of a text file that has heights alone: between those of a profile ([0]), or
                      the columns and the rows of a matrix; 0: as the file states */
  double missing;  /* the height that marks a missing one; NAN: there is none */
  double lambda_s; /* of a profile: shorter waves are taken out, m; 0: none are */
} aspi_profile_options;

/* Defaults: units as stated, meters, mean line subtracted, gaps refused, unequal spacing resampled,
 * first row of a map, heights in the second column of a text file. */
aspi_profile_options aspi_profile_options_default(void);

/* Findings and repairs of the reader. */
typedef struct aspi_profile_report {
  size_t spikes;      /* points taken for spikes */
  size_t outliers;    /* where none are looked for: points that are clearly dust */
  size_t filled;      /* points of the result that were filled in */
  size_t longest_gap; /* most of them in a row */
  char text[700];     /* for the log: the counts above, separator and unit in one sentence */
  char warnings[440]; /* what makes the heights doubtful, or "" */
} aspi_profile_report;

/* Reads a measured profile or map from a stream at its beginning, or where that is NULL from the
 * file `path`, or profiles of one wall from several files, `A,B,C`; levels and repairs them as the
 * options ask; see asp_heights_read. NULL for `options`: the defaults; for `report`: none. NULL on
 * error; the message names file and line. */
asp_heights *aspi_read(FILE *stream, const char *path, bool is_map,
                       const aspi_profile_options *options, aspi_profile_report *report,
                       asp_error *error);

/* ASP_ERANGE and a message if a measured wall resolves too little for spheres of diameter d_p:
 * under 10 points per sphere, or a wall under 20 correlation lengths lambda long; all lengths in
 * one unit. For a map use the larger step, the shorter side and lambda_2. */
asp_code aspi_sampling_check(double d_p, double spacing, double length, double lambda,
                             asp_error *error);

/* ---- inside the room ---- */

/* Heights of a file, row by row; a profile is one row. NAN: bad or missing. Memory grows as heights
 * are read, so false counts in a header allocate nothing. */
typedef struct aspi_raw {
  const char *path; /* for messages */
  double *z;        /* m */
  bool is_map;
  size_t points, columns, rows;
  double step[2];   /* m, between columns and rows; of a profile the first alone */
  size_t read, bad; /* points in the file, and the bad ones of them */
  size_t bad_line;  /* where the first bad point or gap is; 0: not known */
  char text[300];   /* how the file was read, as ", of column 2", or "" */
  char note[160];   /* numbers of the file that were not read, or "" */
} aspi_raw;

/* Adds a height (m). */
asp_code aspi_raw_add(aspi_raw *raw, double height, asp_error *error);

size_t aspi_raw_count_bad(const aspi_raw *raw);

/* The least and the greatest good height; *least > *most if there is none. */
void aspi_raw_range(const aspi_raw *raw, double *least, double *most);

/* Formats, detected by the first bytes; SDF is that of ISO 25178-71. Detection rewinds the text.
 * ASP_EDATA for others that are known, with the name of a free program that converts them. */
typedef enum aspi_format {
  ASP_FORMAT_TEXT,
  ASP_FORMAT_SDF_TEXT,
  ASP_FORMAT_SDF_BINARY,
  ASP_FORMAT_SUR,
  ASP_FORMAT_ZIP
} aspi_format;
asp_code aspi_format_find(aspi_text *text, aspi_format *format, asp_error *error);

/* The readers of a text at its beginning. They leave raw->z to be freed by the caller, on error
 * too.
 */
asp_code aspi_read_columns(const aspi_text *text, const aspi_profile_options *options,
                           aspi_raw *raw, asp_error *error);
asp_code aspi_read_sdf(aspi_text *text, bool is_binary, const aspi_profile_options *options,
                       aspi_raw *raw, asp_error *error);
asp_code aspi_read_sur(aspi_text *text, const aspi_profile_options *options, aspi_raw *raw,
                       asp_error *error);
asp_code aspi_read_x3p(aspi_text *text, const aspi_profile_options *options, aspi_raw *raw,
                       asp_error *error);

/* Subtracts the form, marks spikes, fills or refuses gaps, filters, and reports what it did. */
asp_code aspi_mend(aspi_raw *raw, const aspi_profile_options *options, aspi_profile_report *report,
                   asp_error *error);

/* Takes waves shorter than lambda_s out of heights at equal spacing, in place. ASP_EARG if it does
 * not fit the profile. */
asp_code aspi_filter(double *heights, size_t points, double spacing, double lambda_s,
                     asp_error *error);

/* ---- warnings about heights: dust, few steps, clipped ---- */

/* Robust standard deviations off its neighbors at which a point is dust, not roughness. */
#define ASP_SPIKES_CLEAR 20.0

/* Heights as a file has them, before the form is taken out. */
typedef struct aspi_steps {
  size_t points, levels; /* levels: 0 if there are too many to count */
  double quantum;        /* the least distance between neighbors of different height */
  double end[2];         /* the lowest and the highest one */
  size_t cut[2];         /* points that lie there side by side, where they are many; else 0 */
} aspi_steps;

aspi_steps aspi_steps_find(const aspi_raw *raw);

/* Writes the warnings, "" if none; heights in m. `outliers`: points that lie
 * ASP_SPIKES_CLEAR off their neighbors. */
void aspi_warnings_write(const aspi_steps *steps, size_t outliers, char *text, size_t size);

/* ---- heights that may stand for missing ones: what instruments write where they have none, as
 * -9999 ---- */

/* Starts as {.stated = NAN}, or with the height that the user declares as missing. */
typedef struct aspi_missing {
  double stated;
  size_t count; /* heights other than known marks; their range */
  double least, most;
  double mark; /* the largest of the known marks; 0: none */
  size_t line; /* where that mark is */
} aspi_missing;

/* Notes one height of the file and returns it; NAN if it is the stated mark. */
double aspi_missing_note(aspi_missing *missing, double height, size_t line);

/* ASP_EDATA if a known mark of missing heights is far outside the range of the others. */
asp_code aspi_missing_check(const aspi_missing *missing, const char *path, asp_error *error);
