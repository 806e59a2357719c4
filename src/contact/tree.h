/* Triangles in a tree of boxes: finds those that a box meets, and the nearest to a point. 72 bytes
 * a triangle for its nodes and about 30 for its number and the tree.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stddef.h>

#include "contact/contact.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ContactTree ContactTree;

/* A growing list of numbers of triangles; all zero when empty, freed by aspi_places_free. */
typedef struct ContactList {
  int *item;
  size_t count, room;
} ContactList;

void aspi_places_free(ContactList *list);

/* Make the tree triangle by triangle: begin, add, and finish before anything else. Takes copies of
 * the triangles with their numbers, `id` (from 0, each once; the largest one counts for memory).
 * NULL and false when out of memory; the tree is to be freed all the same. */
ContactTree *aspi_tree_begin(void);
bool aspi_tree_add(ContactTree *tree, const ContactTriangle *triangle, int id);
bool aspi_tree_finish(ContactTree *tree);
void aspi_tree_free(ContactTree *tree);

size_t aspi_tree_count(const ContactTree *tree);
size_t aspi_tree_bytes(const ContactTree *tree);

/* A tree as a block of aspi_tree_bytes(), aligned as malloc's; it holds no addresses, so that
 * processes can share one. The tree over a block copies nothing: the block must outlive it. NULL
 * when out of memory. */
void aspi_tree_pack(const ContactTree *tree, void *block);
ContactTree *aspi_tree_over(void *block);

/* The box around all triangles; lo > hi where there are none. */
void aspi_tree_box(const ContactTree *tree, double lo[3], double hi[3]);

/* A triangle by its place in the tree, 0 to count - 1, and its number. */
const ContactTriangle *aspi_tree_triangle(const ContactTree *tree, int place);
int aspi_tree_id(const ContactTree *tree, int place);

/* The place of the triangle of a number, or -1. */
int aspi_tree_place(const ContactTree *tree, int id);

/* Lower bound of the time for which a sphere of radius `reach`, growing by `widen` per time, stays
 * clear of all triangles except those in the planes of the `skipped` ones listed in `skip`, while
 * its center moves along x + v t; at most `most`. Where it is at most `least`, it may be any such
 * time. */
double aspi_tree_clear(const ContactTree *tree, const double x[3], const double v[3], double reach,
                       double widen, double least, double most, const int *skip, int skipped);

/* Planes that each have some of the triangles behind them: n.x <= at. */
typedef struct ContactPlane {
  double n[3], at;
} ContactPlane;

/* Fills at most `room` planes that separate x from all triangles nearer than `reach` except those
 * in the planes of the `skipped` ones listed in `skip`; returns their number, -1 if there is no
 * room for all, or no memory. `near` is for its own use. */
int aspi_tree_separate(const ContactTree *tree, const double x[3], double reach, const int *skip,
                       int skipped, ContactList *near, ContactPlane *planes, int room);

/* Appends the places of all triangles whose boxes meet the box lo to hi and come within `reach` of
 * its middle. False when out of memory. */
bool aspi_tree_meet(const ContactTree *tree, const double lo[3], const double hi[3], double reach,
                    ContactList *list);

/* The distance of x from the nearest triangle, or `most` if none is nearer; its place in *place
 * (may be NULL), -1 if none. Of triangles at one distance, that with the least number. */
double aspi_tree_distance(const ContactTree *tree, const double x[3], double most, int *place);

#ifdef __cplusplus
}
#endif
