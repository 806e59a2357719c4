/* The faces of a wall, triangles or polygons, and what hit each: from an STL file, or from the map
 * of a simulation as VTK in text (.vtk or .vtp) of any engine.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity.h"
#include "contact/contact.h"

/* Fields of a face, in SI: impacts, deposited and eroded mass, depth of erosion, mean speed of
 * impact. */
typedef enum aspi_of_face {
  ASPI_FACE_IMPACTS,
  ASPI_FACE_DEPOSITED,
  ASPI_FACE_ERODED,
  ASPI_FACE_DEPTH,
  ASPI_FACE_SPEED,
  ASPI_FACE_FIELDS
} aspi_of_face;

/* A polygon is cut into triangles. */
typedef struct aspi_faces {
  size_t triangles, count;
  ContactTriangle *triangle;
  int *face;                         /* of each triangle, from 0 */
  double *area;                      /* of each face */
  double (*value)[ASPI_FACE_FIELDS]; /* of each face; NAN: the file has none */
} aspi_faces;

/* Coordinates are those of the file times `scale`. NULL on error. */
aspi_faces *aspi_faces_read(const char *path, double scale, asp_error *error);
void aspi_faces_free(aspi_faces *faces);

/* Names of the fields in maps, first those of the fixes, then those of OpenFOAM behind `CLOUD:`. */
extern const char *const aspi_face_names[ASPI_FACE_FIELDS][2];
