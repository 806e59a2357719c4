/* Shared by the readers of profile files.
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

/* Options of reading a measured profile. */
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
  double step;    /* m, of a text file that has heights alone; 0: it has positions */
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

/* Reads a measured profile, as a stream; see asp_reader. options NULL: the defaults; report may be
 * NULL. NULL on error; the message names file and line. */
asp_profile *aspi_profile_read(const char *path, const aspi_profile_options *options,
                               aspi_profile_report *report, asp_error *error);

/* Writes what was read into a report, which has what was mended already. */
void aspi_report(aspi_profile_report *report, const aspi_raw *raw,
                 const aspi_profile_options *options);

/* Formats, detected by the first bytes; SDF is that of ISO 25178-71. Detection rewinds the stream.
 * ASP_EDATA for closed formats, with the name of a free program that converts them. */
typedef enum aspi_format {
  ASP_FORMAT_TEXT,
  ASP_FORMAT_SDF_TEXT,
  ASP_FORMAT_SDF_BINARY
} aspi_format;
asp_code aspi_format_find(FILE *stream, const char *path, aspi_format *format, asp_error *error);

/* The readers. Each begins with the first line that is not blank already in text->text, and leaves
 * raw->heights to be freed by the caller, on error too. */
asp_code aspi_read_columns(aspi_text *text, const aspi_profile_options *options, aspi_raw *raw,
                           asp_error *error);
asp_code aspi_read_sdf(aspi_text *text, const aspi_profile_options *options, aspi_raw *raw,
                       asp_error *error);

/* The header of an SDF text file, NAN for absent keys. Then its points x profiles heights in turn,
 * before z_scale, NAN for bad points; and the trailer that must follow them. */
typedef struct aspi_sdf {
  double points, profiles, x_scale, y_scale, z_scale, compression;
} aspi_sdf;

/* Rejects options that SDF files do not need: they state units, spacing (`step`) and bad points. */
asp_code aspi_sdf_check_options(const char *path, const aspi_profile_options *options, double step,
                                asp_error *error);

asp_code aspi_sdf_header(aspi_text *text, aspi_sdf *h, asp_error *error);
asp_code aspi_sdf_height(aspi_text *text, const aspi_sdf *h, size_t index, double *height,
                         asp_error *error);
asp_code aspi_sdf_end(aspi_text *text, const aspi_sdf *h, asp_error *error);

/* Like aspi_profile_read, from an open stream; `path` is for messages only. */
asp_profile *aspi_profile_read_stream(FILE *stream, const char *path,
                                      const aspi_profile_options *options,
                                      aspi_profile_report *report, asp_error *error);

#endif
