/* What the readers of profile files hand to each other. */
#ifndef ASP_SURFACE_READ_H
#define ASP_SURFACE_READ_H

#include "base/text.h"

/* Heights as a file has them, equally spaced, in metres; NAN where one is bad or missing. */
typedef struct asp_raw {
  double *heights;
  size_t points, room;
  double spacing;
  size_t read;        /* points in the file */
  size_t bad;         /* of them */
  size_t bad_line;    /* where the first bad point or gap is */
  size_t first_spike; /* the point, from 1 */
  bool resampled;
  double step_least, step_most; /* m */
} asp_raw;

asp_code asp_raw_add(asp_raw *raw, double height, asp_error *error);

/* The readers. Each begins with the first line that is not blank already in text->text, and leaves
 * raw->heights to be freed by the caller, on error too. */
asp_code asp_read_columns(asp_text *text, const asp_profile_options *options, asp_raw *raw,
                          asp_error *error);
asp_code asp_read_sdf(asp_text *text, const asp_profile_options *options, asp_raw *raw,
                      asp_error *error);

/* As asp_profile_read, from an open stream; `path` is for messages only. */
asp_profile *asp_profile_read_stream(FILE *stream, const char *path,
                                     const asp_profile_options *options, asp_profile_report *report,
                                     asp_error *error);

#endif
