/* The nodes of a tree of boxes, for the files that walk through it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "contact/tree.h"

enum { CONTACT_TREE_DEPTH = 64 };

/* b if one of them is NaN. Unlike fmax and fmin these are inlined. */
static inline double aspi_larger(double a, double b) {
  return a > b ? a : b;
}

static inline double aspi_smaller(double a, double b) {
  return a < b ? a : b;
}

static inline void aspi_triangle_box(const ContactTriangle *t, double lo[3], double hi[3]) {
  for (int d = 0; d < 3; d++) {
    lo[d] = aspi_smaller(t->node[0][d], aspi_smaller(t->node[1][d], t->node[2][d]));
    hi[d] = aspi_larger(t->node[0][d], aspi_larger(t->node[1][d], t->node[2][d]));
  }
}

/* A leaf has `count` triangles from `first` on; an inner node has count 0, its one child right
 * behind it, and the other at `first`. */
typedef struct ContactNode {
  float lo[3], hi[3];
  int first, count;
} ContactNode;

struct ContactTree {
  ContactTriangle *triangles;
  int *id;
  int *by_id; /* places by their numbers; -1: there is none */
  ContactNode *nodes;
  size_t count, n_nodes, n_ids, room;
  bool borrows; /* the lists are parts of a block that somebody else frees */
};
