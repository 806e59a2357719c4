/* Shared by the readers of measured profiles and maps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_READERS_READ_H
#define ASP_READERS_READ_H

#include "base/text.h"
#include "readers/warnings.h"
#include "readers/filter.h"
#include "readers/raw.h"

/* Largest number of columns that a text file may use, and the highest degree of a form. */
enum { ASP_COLUMNS_MOST = 1024, ASP_FORM_MAX = 9 };

/* Options of reading a measured profile or map. */
typedef struct aspi_profile_options {
  double unit_x, unit_z; /* meters in one unit of a text file's columns; 0: as the file states */
  double metre;          /* one meter in the unit of the result: 1 for SI, 1e6 for micrometers */
  int form;              /* degree of the polynomial that is taken out as form, 0 to 9; -1: none */
  double spikes;         /* points this many robust sd off their neighbors are bad, and refused or
                            filled as those are; 0: none are */
  bool fill;     /* bad points and gaps are filled by straight lines; false: they are refused */
  bool resample; /* unequal spacing is resampled by straight lines; false: it is refused */
  int row;       /* of an SDF map, from 1 */
  int column;    /* 0, or: of an SDF map, read that column instead; of a text file, the heights */
  int x_number;  /* 0, or: of a text file, the column of positions, from 1 */
  const char *x_column,
      *z_column;  /* of a text file, by number from 1 or by name; NULL: by the header */
  double step[2]; /* m, of a text file that has heights alone: between those of a profile ([0]), or
                     the columns and the rows of a matrix; 0: as the file states */
  double missing; /* if has_missing: the height that marks a missing one */
  bool has_missing;
  aspi_filters filters;
} aspi_profile_options;

/* Units as stated, meters, a mean line taken out, gaps refused, unequal spacing resampled, first
 * row of a map, heights in the second column of a text file. */
aspi_profile_options aspi_profile_options_default(void);

/* Findings and repairs of the reader. */
typedef struct aspi_profile_report {
  size_t points;      /* read from the file */
  size_t bad;         /* bad points among them: not a number, or marked as bad */
  size_t spikes;      /* points taken for spikes */
  size_t outliers;    /* where none are looked for: points that are clearly dust */
  size_t filled;      /* points of the result that were filled in */
  size_t repeats;     /* positions that repeat the one before, whose heights were averaged */
  size_t longest_gap; /* most of them in a row */
  bool resampled;
  double step_least, step_most; /* spacing of the file's positions, in the unit of the result */
  char text[700];               /* all of that as a sentence */
  char warnings[440];           /* what makes the heights doubtful, or "" (warnings.h) */
} aspi_profile_report;

/* ASP_EARG and a message where one is out of its range. */
asp_code aspi_profile_check_options(const aspi_profile_options *options, asp_error *error);

/* Read a measured profile or map from a stream at its beginning, or where that is NULL from the
 * file `path`, level and repair it as the options ask; see asp_reader. `report` may be NULL, and of
 * a profile the options: the defaults. NULL on error; the message names file and line. */
asp_profile *aspi_profile_read(FILE *stream, const char *path, const aspi_profile_options *options,
                               aspi_profile_report *report, asp_error *error);
asp_map *aspi_map_read(FILE *stream, const char *path, const aspi_profile_options *options,
                       aspi_profile_report *report, asp_error *error);

/* Formats, detected by the first bytes; SDF is that of ISO 25178-71. Detection rewinds the stream.
 * ASP_EDATA for closed formats, with the name of a free program that converts them. */
typedef enum aspi_format {
  ASP_FORMAT_TEXT,
  ASP_FORMAT_SDF_TEXT,
  ASP_FORMAT_SDF_BINARY
} aspi_format;
asp_code aspi_format_find(FILE *stream, const char *path, aspi_format *format, asp_error *error);

/* The readers, which leave raw->heights to be freed by the caller, on error too: a profile's
 * columns of text, and SDF, with the first line in ASCII that is not blank already in text->text; a
 * matrix of heights or lines of x, y, z as text, from its beginning. */
asp_code aspi_read_columns(aspi_text *text, const aspi_profile_options *options, aspi_raw *raw,
                           asp_error *error);
asp_code aspi_read_sdf(aspi_text *text, bool binary, const aspi_profile_options *options,
                       aspi_raw *raw, asp_error *error);
asp_code aspi_read_map_text(const aspi_text *text, const aspi_profile_options *options,
                            aspi_raw *raw, asp_error *error);

/* Points of a map in x, y and z, as they come. */
enum { ASP_MAP_AXES = 3 };
typedef struct aspi_map_points {
  double (*at)[ASP_MAP_AXES];
  size_t count, room;
} aspi_map_points;

asp_code aspi_map_points_add(aspi_map_points *points, const double point[ASP_MAP_AXES],
                             asp_error *error);

/* Puts them on their grid; unit: meters in one of each axis. ASP_EDATA where there is none. */
asp_code aspi_map_points_place(const aspi_map_points *points, const char *path,
                               const double unit[ASP_MAP_AXES], aspi_raw *raw, asp_error *error);

/* Takes out the form, marks spikes, fills gaps or refuses them, filters, and writes what it did
 * into the report. */
asp_code aspi_mend(aspi_raw *raw, const char *path, const aspi_profile_options *options,
                   aspi_profile_report *report, asp_error *error);

#endif
