/* Finds the columns of positions and heights in a text file; see header.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_READERS_HEADER_H
#define ASP_READERS_HEADER_H

#include "readers/read.h"

enum { ASP_HEADER_KEPT = 8, ASP_HEADER_NEAR = 3 };

/* The last lines before the data, the very last first; "" where there are fewer. Units that are
 * stated of no axis count in those that are near to the data only. */
typedef struct aspi_header {
  char line[ASP_HEADER_KEPT][ASP_TEXT_MOST];
} aspi_header;

/* Takes a line that is not blank in. */
void aspi_header_note(aspi_header *header, const char *line);

/* The columns, from 0; x is -1 where positions are counted, y where a position is x alone. Units in
 * m; 0 where none is stated. */
typedef struct aspi_columns {
  int x, y, z;
  double unit_x, unit_y, unit_z;
  bool are_depths; /* the heights count downward */
} aspi_columns;

/* Chooses the columns of lines with that many fields, `used` of them without empty ones at the end;
 * false and the reason where it cannot. */
bool aspi_choose_columns(const aspi_header *header, char separator, int fields, int used,
                         const aspi_profile_options *options, aspi_columns *chosen, char *why,
                         size_t size);

/* The columns of x, y and z of a map's points, from 0, and their units in m, 0 where none is
 * stated. False where the header does not name all three. */
typedef struct aspi_axes {
  int column[3];
  double unit[3];
  bool are_depths;
} aspi_axes;

bool aspi_find_axes(const aspi_header *header, char separator, int fields, aspi_axes *axes);

/* Completes the units: the user's, those of the columns, or those of the header as a whole. */
asp_code aspi_find_units(const aspi_text *text, const aspi_profile_options *options,
                         const aspi_header *header, aspi_columns *columns, asp_error *error);

#endif
