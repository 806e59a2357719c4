/* A tree of boxes over triangles, split at the median of their centers along the longest side; see
 * tree.h. Boxes are in single precision, rounded outwards.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "contact/tree_nodes.h"
#include "contact/vector.h"

/* Triangles in a leaf at most; so few are one leaf. */
enum { LEAF = 4, FEW = 24 };

static float larger_f(float a, float b) {
  return a > b ? a : b;
}

static float smaller_f(float a, float b) {
  return a < b ? a : b;
}

/* A triangle while the tree is built. */
typedef struct Item {
  float center[3];
  int from;
} Item;

void aspi_places_free(ContactList *list) {
  free(list->item);
  list->item = NULL;
  list->count = list->room = 0;
}

static bool append(ContactList *list, int item) {
  if (list->count == list->room) {
    const size_t room = list->room ? 2 * list->room : 64;
    int *grown = realloc(list->item, room * sizeof *grown);
    if (!grown)
      return false;
    list->item = grown;
    list->room = room;
  }
  list->item[list->count++] = item;
  return true;
}

static void wrap(const ContactTriangle *triangle, ContactNode *node) {
  for (int k = 0; k < 3; k++)
    for (int d = 0; d < 3; d++) {
      const double at = triangle->node[k][d];
      node->lo[d] = smaller_f(node->lo[d], nextafterf((float)at, -INFINITY));
      node->hi[d] = larger_f(node->hi[d], nextafterf((float)at, INFINITY));
    }
}

static const ContactNode EMPTY = {
    {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, 0, 0};

/* Reorders items so that those from `middle` on have centers along d that are not smaller than
 * those before it (Hoare's selection). */
static void select_median(Item *items, size_t count, size_t middle, int d) {
  size_t lo = 0, hi = count - 1;
  while (lo < hi) {
    const float pivot = items[lo + (hi - lo) / 2].center[d];
    size_t i = lo, j = hi;
    for (;;) {
      while (items[i].center[d] < pivot)
        i++;
      while (items[j].center[d] > pivot)
        j--;
      if (i < j) {
        const Item other = items[i];
        items[i] = items[j];
        items[j] = other;
      }
      if (i >= j)
        break;
      i++;
      j--;
    }
    if (middle <= j)
      hi = j;
    else
      lo = j + 1;
  }
}

static int longest_side(const Item *items, size_t count) {
  float lo[3], hi[3];
  for (int d = 0; d < 3; d++) {
    lo[d] = hi[d] = items[0].center[d];
    for (size_t i = 1; i < count; i++) {
      lo[d] = smaller_f(lo[d], items[i].center[d]);
      hi[d] = larger_f(hi[d], items[i].center[d]);
    }
  }
  int longest = 0;
  for (int d = 1; d < 3; d++)
    if (hi[d] - lo[d] > hi[longest] - lo[longest])
      longest = d;
  return longest;
}

static void unite(ContactNode *node, const ContactNode *child) {
  for (int d = 0; d < 3; d++) {
    node->lo[d] = smaller_f(node->lo[d], child->lo[d]);
    node->hi[d] = larger_f(node->hi[d], child->hi[d]);
  }
}

/* Makes the node of some items, and those below it; returns its place. */
static size_t build(ContactTree *tree, const ContactTriangle *triangles, Item *items, size_t first,
                    size_t count) {
  const size_t at = tree->n_nodes++;
  ContactNode *node = &tree->nodes[at];
  *node = EMPTY;
  if (count <= LEAF || tree->count <= FEW) {
    for (size_t i = 0; i < count; i++)
      wrap(&triangles[items[first + i].from], node);
    node->first = (int)first;
    node->count = (int)count;
    return at;
  }
  const size_t half = count / 2;
  select_median(items + first, count, half, longest_side(items + first, count));
  const size_t left = build(tree, triangles, items, first, half);
  const size_t right = build(tree, triangles, items, first + half, count - half);
  node->first = (int)right;
  unite(node, &tree->nodes[left]);
  unite(node, &tree->nodes[right]);
  return at;
}

ContactTree *aspi_tree_begin(void) {
  return calloc(1, sizeof(ContactTree));
}

bool aspi_tree_add(ContactTree *tree, const ContactTriangle *triangle, int id) {
  if (tree->count == tree->room) {
    const size_t room = tree->room ? tree->room + tree->room / 2 : 64;
    ContactTriangle *triangles = realloc(tree->triangles, room * sizeof *triangles);
    if (triangles)
      tree->triangles = triangles;
    int *ids = realloc(tree->id, room * sizeof *ids);
    if (ids)
      tree->id = ids;
    if (!triangles || !ids)
      return false;
    tree->room = room;
  }
  tree->triangles[tree->count] = *triangle;
  tree->id[tree->count++] = id;
  return true;
}

/* Puts triangle items[i].from into place i, along the cycles of the permutation. */
static void put_in_order(ContactTree *tree, Item *items) {
  for (size_t start = 0; start < tree->count; start++) {
    const ContactTriangle triangle = tree->triangles[start];
    const int id = tree->id[start];
    size_t to = start;
    while ((size_t)items[to].from != start) {
      const size_t from = (size_t)items[to].from;
      tree->triangles[to] = tree->triangles[from];
      tree->id[to] = tree->id[from];
      items[to].from = (int)to;
      to = from;
    }
    tree->triangles[to] = triangle;
    tree->id[to] = id;
    items[to].from = (int)to;
  }
}

/* Gives back memory that is not needed. */
static void *shrink(void *list, size_t bytes) {
  void *shrunk = realloc(list, bytes);
  return shrunk ? shrunk : list;
}

bool aspi_tree_finish(ContactTree *tree) {
  const size_t count = tree->count;
  Item *items = malloc((count + 1) * sizeof *items);
  tree->triangles = shrink(tree->triangles, (count + 1) * sizeof *tree->triangles);
  tree->id = shrink(tree->id, (count + 1) * sizeof *tree->id);
  tree->nodes = malloc((count + 1) * sizeof *tree->nodes);
  if (!items || !tree->triangles || !tree->id || !tree->nodes) {
    free(items);
    return false;
  }
  for (size_t i = 0; i < count; i++) {
    const ContactTriangle *t = &tree->triangles[i];
    items[i].from = (int)i;
    for (int d = 0; d < 3; d++)
      items[i].center[d] = (float)((t->node[0][d] + t->node[1][d] + t->node[2][d]) / 3);
  }
  if (count > 0)
    build(tree, tree->triangles, items, 0, count);
  put_in_order(tree, items);
  free(items);
  tree->nodes = shrink(tree->nodes, (tree->n_nodes + 1) * sizeof *tree->nodes);
  for (size_t i = 0; i < count; i++)
    if (tree->id[i] >= (int64_t)tree->n_ids)
      tree->n_ids = (size_t)tree->id[i] + 1;
  tree->by_id = malloc((tree->n_ids + 1) * sizeof *tree->by_id);
  for (size_t id = 0; tree->by_id && id < tree->n_ids; id++)
    tree->by_id[id] = -1;
  for (size_t i = 0; tree->by_id && i < count; i++)
    tree->by_id[tree->id[i]] = (int)i;
  return tree->by_id;
}

void aspi_tree_free(ContactTree *tree) {
  if (!tree)
    return;
  if (!tree->borrows) {
    free(tree->triangles);
    free(tree->id);
    free(tree->by_id);
    free(tree->nodes);
  }
  free(tree);
}

size_t aspi_tree_count(const ContactTree *tree) {
  return tree->count;
}

/* The head of a block; the lists follow, those that need the widest alignment first. */
typedef struct Head {
  size_t count, n_nodes, n_ids;
} Head;

size_t aspi_tree_bytes(const ContactTree *tree) {
  return sizeof(Head) + tree->count * (sizeof(ContactTriangle) + sizeof(int)) +
         tree->n_nodes * sizeof(ContactNode) + tree->n_ids * sizeof(int);
}

static char *put(char *to, const void *list, size_t bytes) {
  memcpy(to, list, bytes);
  return to + bytes;
}

void aspi_tree_pack(const ContactTree *tree, void *block) {
  const Head head = {tree->count, tree->n_nodes, tree->n_ids};
  char *to = put(block, &head, sizeof head);
  to = put(to, tree->triangles, tree->count * sizeof *tree->triangles);
  to = put(to, tree->nodes, tree->n_nodes * sizeof *tree->nodes);
  to = put(to, tree->id, tree->count * sizeof *tree->id);
  put(to, tree->by_id, tree->n_ids * sizeof *tree->by_id);
}

ContactTree *aspi_tree_over(void *block) {
  ContactTree *tree = aspi_tree_begin();
  if (!tree)
    return NULL;
  const Head *head = block;
  tree->count = head->count;
  tree->n_nodes = head->n_nodes;
  tree->n_ids = head->n_ids;
  tree->borrows = true;
  tree->triangles = (ContactTriangle *)(head + 1);
  tree->nodes = (ContactNode *)(tree->triangles + tree->count);
  tree->id = (int *)(tree->nodes + tree->n_nodes);
  tree->by_id = tree->id + tree->count;
  return tree;
}

void aspi_tree_box(const ContactTree *tree, double lo[3], double hi[3]) {
  const ContactNode *root = tree->count > 0 ? tree->nodes : &EMPTY;
  for (int d = 0; d < 3; d++) {
    lo[d] = root->lo[d];
    hi[d] = root->hi[d];
  }
}

const ContactTriangle *aspi_tree_triangle(const ContactTree *tree, int place) {
  return &tree->triangles[place];
}

int aspi_tree_id(const ContactTree *tree, int place) {
  return tree->id[place];
}

int aspi_tree_place(const ContactTree *tree, int id) {
  return id >= 0 && (size_t)id < tree->n_ids ? tree->by_id[id] : -1;
}

/* A box, and the ball around its middle of which it is a part; see aspi_tree_meet(). */
typedef struct Region {
  const double *lo, *hi;
  double middle[3], square; /* of the ball's radius */
} Region;

/* True if the box lo to hi meets both. */
static inline bool region_meets(const Region *region, const double lo[3], const double hi[3]) {
  double square = 0;
  for (int d = 0; d < 3; d++) {
    if (hi[d] < region->lo[d] || lo[d] > region->hi[d])
      return false;
    const double *x = region->middle;
    const double off = aspi_larger(0, aspi_larger(lo[d] - x[d], x[d] - hi[d]));
    square += off * off;
  }
  return square <= region->square;
}

static bool node_meets(const ContactNode *node, const Region *region) {
  const double lo[3] = {node->lo[0], node->lo[1], node->lo[2]};
  const double hi[3] = {node->hi[0], node->hi[1], node->hi[2]};
  return region_meets(region, lo, hi);
}

static bool triangle_meets(const ContactTriangle *t, const Region *region) {
  double lo[3], hi[3];
  aspi_triangle_box(t, lo, hi);
  return region_meets(region, lo, hi);
}

bool aspi_tree_meet(const ContactTree *tree, const double lo[3], const double hi[3], double reach,
                    ContactList *list) {
  Region region = {lo, hi, {0, 0, 0}, reach * reach};
  for (int d = 0; d < 3; d++)
    region.middle[d] = 0.5 * (lo[d] + hi[d]);
  int stack[CONTACT_TREE_DEPTH], top = 0;
  if (tree->count > 0)
    stack[top++] = 0;
  while (top > 0) {
    const int at = stack[--top];
    const ContactNode *node = &tree->nodes[at];
    if (!node_meets(node, &region))
      continue;
    if (node->count == 0) {
      stack[top++] = node->first;
      stack[top++] = at + 1;
    }
    for (int i = node->first; i < node->first + node->count; i++)
      if (triangle_meets(&tree->triangles[i], &region) && !append(list, i))
        return false;
  }
  return true;
}

/* The square of the distance of x from a node's box. */
static double box_square(const ContactNode *node, const double x[3]) {
  double square = 0;
  for (int d = 0; d < 3; d++) {
    const double off = aspi_larger(0, aspi_larger(node->lo[d] - x[d], x[d] - node->hi[d]));
    square += off * off;
  }
  return square;
}

double aspi_tree_distance(const ContactTree *tree, const double x[3], double most, int *place) {
  struct {
    int at;
    double square;
  } stack[CONTACT_TREE_DEPTH];
  int top = 0, found = -1;
  double least = most, nearest[3];
  if (tree->count > 0) {
    stack[top].at = 0;
    stack[top++].square = box_square(tree->nodes, x);
  }
  while (top > 0) {
    const int at = stack[--top].at;
    if (stack[top].square > least * least)
      continue;
    const ContactNode *node = &tree->nodes[at];
    if (node->count == 0) {
      const int child[2] = {at + 1, node->first};
      const double square[2] = {box_square(&tree->nodes[child[0]], x),
                                box_square(&tree->nodes[child[1]], x)};
      const int nearer = square[1] < square[0];
      stack[top].at = child[!nearer];
      stack[top++].square = square[!nearer];
      stack[top].at = child[nearer];
      stack[top++].square = square[nearer];
      continue;
    }
    for (int i = node->first; i < node->first + node->count; i++) {
      const double distance = aspi_triangle_nearest(&tree->triangles[i], x, nearest);
      if (distance < least ||
          (found >= 0 && !(distance > least) && tree->id[i] < tree->id[found])) {
        least = distance;
        found = i;
      }
    }
  }
  if (place)
    *place = found;
  return least;
}
