/* A tree of boxes over triangles, split at the median of their centres along the longest side; see
 * tree.h. Boxes are in single precision, rounded outwards.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/tree.h"
#include "contact/vector.h"

enum { LEAF = 4, DEPTH = 64 };

/* Of two numbers; where one of them is no number, `b`. fmax and fmin are calls. */
static double larger(double a, double b) {
  return a > b ? a : b;
}

static double smaller(double a, double b) {
  return a < b ? a : b;
}

static float larger_f(float a, float b) {
  return a > b ? a : b;
}

static float smaller_f(float a, float b) {
  return a < b ? a : b;
}

/* A triangle whose height is less than this share of its longest edge has a plane that is not well
 * known. */
static const double SLIVER = 1e-3;

/* A leaf has `count` triangles from `first` on; an inner node has count 0, its one child right
 * behind it, and the other at `first`. */
typedef struct Node {
  float lo[3], hi[3];
  int first, count;
} Node;

struct ContactTree {
  ContactTriangle *triangles;
  int *id;
  int *by_id; /* places in order of their numbers */
  Node *nodes;
  size_t count, n_nodes, room;
  bool borrows; /* the lists are parts of a block that somebody else frees */
};

/* What building needs of a triangle. */
typedef struct Item {
  float center[3];
  int from;
} Item;

void contact_list_free(ContactList *list) {
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

static void wrap(const ContactTriangle *triangle, Node *node) {
  for (int k = 0; k < 3; k++)
    for (int d = 0; d < 3; d++) {
      const double at = triangle->node[k][d];
      node->lo[d] = smaller_f(node->lo[d], nextafterf((float)at, -INFINITY));
      node->hi[d] = larger_f(node->hi[d], nextafterf((float)at, INFINITY));
    }
}

static const Node EMPTY = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, 0, 0};

/* Reorders items so that those from `middle` on have centres along d that are not smaller than
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

static void unite(Node *node, const Node *child) {
  for (int d = 0; d < 3; d++) {
    node->lo[d] = smaller_f(node->lo[d], child->lo[d]);
    node->hi[d] = larger_f(node->hi[d], child->hi[d]);
  }
}

/* Makes the node of some items, and those below it; its place. */
static size_t build(ContactTree *tree, const ContactTriangle *triangles, Item *items, size_t first,
                    size_t count) {
  const size_t at = tree->n_nodes++;
  Node *node = &tree->nodes[at];
  *node = EMPTY;
  if (count <= LEAF) {
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

/* A number and the place of its triangle. */
typedef struct Numbered {
  int id, place;
} Numbered;

static int by_number(const void *a, const void *b) {
  const Numbered *of_a = a, *of_b = b;
  return (of_a->id > of_b->id) - (of_a->id < of_b->id);
}

static bool number(ContactTree *tree) {
  Numbered *order = malloc((tree->count + 1) * sizeof *order);
  if (!order)
    return false;
  for (size_t i = 0; i < tree->count; i++)
    order[i] = (Numbered){tree->id[i], (int)i};
  qsort(order, tree->count, sizeof *order, by_number);
  for (size_t i = 0; i < tree->count; i++)
    tree->by_id[i] = order[i].place;
  free(order);
  return true;
}

ContactTree *contact_tree_begin(void) {
  return calloc(1, sizeof(ContactTree));
}

bool contact_tree_add(ContactTree *tree, const ContactTriangle *triangle, int id) {
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

/* Gives back what was taken too much of. */
static void *shrink(void *list, size_t bytes) {
  void *shrunk = realloc(list, bytes);
  return shrunk ? shrunk : list;
}

bool contact_tree_finish(ContactTree *tree) {
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
  tree->by_id = malloc((count + 1) * sizeof *tree->by_id);
  return tree->by_id && number(tree);
}

ContactTree *contact_tree_create(const ContactTriangle *triangles, const int *id, size_t count) {
  ContactTree *tree = contact_tree_begin();
  bool good = tree != NULL;
  for (size_t i = 0; good && i < count; i++)
    good = contact_tree_add(tree, &triangles[i], id[i]);
  if (good && contact_tree_finish(tree))
    return tree;
  contact_tree_free(tree);
  return NULL;
}

void contact_tree_free(ContactTree *tree) {
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

size_t contact_tree_count(const ContactTree *tree) {
  return tree->count;
}

/* What a block begins with; the lists follow, those that need the widest alignment first. */
typedef struct Head {
  size_t count, n_nodes;
} Head;

size_t contact_tree_bytes(const ContactTree *tree) {
  return sizeof(Head) + tree->count * (sizeof(ContactTriangle) + 2 * sizeof(int)) +
         tree->n_nodes * sizeof(Node);
}

static char *put(char *to, const void *list, size_t bytes) {
  memcpy(to, list, bytes);
  return to + bytes;
}

void contact_tree_pack(const ContactTree *tree, void *block) {
  const Head head = {tree->count, tree->n_nodes};
  char *to = put(block, &head, sizeof head);
  to = put(to, tree->triangles, tree->count * sizeof *tree->triangles);
  to = put(to, tree->nodes, tree->n_nodes * sizeof *tree->nodes);
  to = put(to, tree->id, tree->count * sizeof *tree->id);
  put(to, tree->by_id, tree->count * sizeof *tree->by_id);
}

ContactTree *contact_tree_over(void *block) {
  ContactTree *tree = contact_tree_begin();
  if (!tree)
    return NULL;
  const Head *head = block;
  tree->count = head->count;
  tree->n_nodes = head->n_nodes;
  tree->borrows = true;
  tree->triangles = (ContactTriangle *)(head + 1);
  tree->nodes = (Node *)(tree->triangles + tree->count);
  tree->id = (int *)(tree->nodes + tree->n_nodes);
  tree->by_id = tree->id + tree->count;
  return tree;
}

void contact_tree_box(const ContactTree *tree, double lo[3], double hi[3]) {
  const Node *root = tree->count > 0 ? tree->nodes : &EMPTY;
  for (int d = 0; d < 3; d++) {
    lo[d] = root->lo[d];
    hi[d] = root->hi[d];
  }
}

const ContactTriangle *contact_tree_triangle(const ContactTree *tree, int place) {
  return &tree->triangles[place];
}

int contact_tree_id(const ContactTree *tree, int place) {
  return tree->id[place];
}

int contact_tree_place(const ContactTree *tree, int id) {
  size_t lo = 0, hi = tree->count;
  while (lo < hi) {
    const size_t middle = lo + (hi - lo) / 2;
    if (tree->id[tree->by_id[middle]] < id)
      lo = middle + 1;
    else
      hi = middle;
  }
  return lo < tree->count && tree->id[tree->by_id[lo]] == id ? tree->by_id[lo] : -1;
}

static bool overlaps(const Node *node, const double lo[3], const double hi[3]) {
  for (int d = 0; d < 3; d++)
    if (node->hi[d] < lo[d] || node->lo[d] > hi[d])
      return false;
  return true;
}

static bool triangle_overlaps(const ContactTriangle *t, const double lo[3], const double hi[3]) {
  for (int d = 0; d < 3; d++)
    if (larger(t->node[0][d], larger(t->node[1][d], t->node[2][d])) < lo[d] ||
        smaller(t->node[0][d], smaller(t->node[1][d], t->node[2][d])) > hi[d])
      return false;
  return true;
}

/* Appends the places of the triangles whose boxes meet the box lo to hi. True when it ended early:
 * at the first one where there is no list, else when out of memory. */
static bool meet(const ContactTree *tree, const double lo[3], const double hi[3],
                 ContactList *list) {
  int stack[DEPTH], top = 0;
  if (tree->count > 0)
    stack[top++] = 0;
  while (top > 0) {
    const int at = stack[--top];
    const Node *node = &tree->nodes[at];
    if (!overlaps(node, lo, hi))
      continue;
    if (node->count == 0) {
      stack[top++] = node->first;
      stack[top++] = at + 1;
    }
    for (int i = node->first; i < node->first + node->count; i++)
      if (triangle_overlaps(&tree->triangles[i], lo, hi) && (!list || !append(list, i)))
        return true;
  }
  return false;
}

bool contact_tree_meets(const ContactTree *tree, const double lo[3], const double hi[3]) {
  return meet(tree, lo, hi, NULL);
}

bool contact_tree_meet(const ContactTree *tree, const double lo[3], const double hi[3],
                       ContactList *list) {
  return !meet(tree, lo, hi, list);
}

/* A sphere that moves and grows; see contact_tree_clear(). For boxes, the box around it is taken.
 */
typedef struct Sweep {
  double x[3], v[3], reach, widen;
  double lo[3], hi[3];       /* sides of its box at the beginning */
  double rises[3], falls[3]; /* times in which the upper side goes up by 1, the lower one down */
  bool leaves_up[3], leaves_down[3]; /* whether the other side goes that way too */
} Sweep;

static Sweep sweep_of(const double x[3], const double v[3], double reach, double widen) {
  Sweep sweep = {.reach = reach, .widen = widen};
  vector_copy(x, sweep.x);
  vector_copy(v, sweep.v);
  for (int d = 0; d < 3; d++) {
    const double up = widen + v[d], down = widen - v[d];
    sweep.lo[d] = x[d] - reach;
    sweep.hi[d] = x[d] + reach;
    sweep.rises[d] = up > 0 || up < 0 ? 1 / up : INFINITY;
    sweep.falls[d] = down > 0 || down < 0 ? 1 / down : INFINITY;
    sweep.leaves_up[d] = down < 0;
    sweep.leaves_down[d] = up < 0;
  }
  return sweep;
}

/* When it first meets the box lo to hi; `most` where it does not before. Until *end it may be
 * there.
 */
static inline double sweep_meets(const Sweep *sweep, const double lo[3], const double hi[3],
                                 double most, double *end) {
  double begin = 0;
  *end = most;
  for (int d = 0; d < 3; d++) {
    const double above = lo[d] - sweep->hi[d], below = sweep->lo[d] - hi[d];
    if (above > 0) {
      if (sweep->leaves_down[d])
        return most;
      begin = larger(begin, above * sweep->rises[d]);
    } else if (sweep->leaves_down[d])
      *end = smaller(*end, above * sweep->rises[d]);
    if (below > 0) {
      if (sweep->leaves_up[d])
        return most;
      begin = larger(begin, below * sweep->falls[d]);
    } else if (sweep->leaves_up[d])
      *end = smaller(*end, below * sweep->falls[d]);
    if (begin > *end)
      return most;
  }
  return begin;
}

static inline double sweep_meets_node(const Sweep *sweep, const Node *node, double most) {
  const double lo[3] = {node->lo[0], node->lo[1], node->lo[2]};
  const double hi[3] = {node->hi[0], node->hi[1], node->hi[2]};
  double end;
  return sweep_meets(sweep, lo, hi, most, &end);
}

/* Narrows the times in which it is not beyond a plane: where n.(center - on) is at most the radius
 * times `length`, that of n. False where it is beyond it throughout. */
static bool sweep_is_within(const Sweep *sweep, const double n[3], double length,
                            const double on[3], double *begin, double *end) {
  double arm[3];
  vector_subtract(sweep->x, on, arm);
  const double gap = vector_dot(n, arm) - sweep->reach * length;
  const double closing = sweep->widen * length - vector_dot(n, sweep->v);
  if (gap > 0) {
    if (!(closing * *end > gap))
      return false;
    *begin = larger(*begin, gap / closing);
  } else if (closing < 0)
    *end = smaller(*end, gap / closing);
  return *begin <= *end;
}

/* Not before it is at the triangle's box, at its plane, and on the inner side of its edges: what
 * flies along a wall that is aslant to the axes is in the boxes of its triangles for long. */
static double sweep_meets_triangle(const Sweep *sweep, const ContactTriangle *t, double most) {
  double lo[3], hi[3], end;
  for (int d = 0; d < 3; d++) {
    lo[d] = smaller(t->node[0][d], smaller(t->node[1][d], t->node[2][d]));
    hi[d] = larger(t->node[0][d], larger(t->node[1][d], t->node[2][d]));
  }
  double begin = sweep_meets(sweep, lo, hi, most, &end);
  if (!(begin < most))
    return most;
  double edge[3][3], n[3], back[3];
  for (int k = 0; k < 3; k++)
    vector_subtract(t->node[(k + 1) % 3], t->node[k], edge[k]);
  vector_cross(edge[0], edge[1], n);
  vector_copy(n, back);
  vector_scale(-1, back);
  const double length = vector_length(n);
  const double longest = larger(vector_dot(edge[0], edge[0]),
                                larger(vector_dot(edge[1], edge[1]), vector_dot(edge[2], edge[2])));
  if (!(length > SLIVER * longest))
    return begin;
  if (!sweep_is_within(sweep, n, length, t->node[0], &begin, &end) ||
      !sweep_is_within(sweep, back, length, t->node[0], &begin, &end))
    return most;
  for (int k = 0; k < 3; k++) {
    double outward[3];
    vector_cross(edge[k], n, outward);
    if (!sweep_is_within(sweep, outward, vector_length(outward), t->node[k], &begin, &end))
      return most;
  }
  return smaller(begin, most);
}

static bool has(const int *list, int count, int number) {
  for (int k = 0; k < count; k++)
    if (list[k] == number)
      return true;
  return false;
}

double contact_tree_clear(const ContactTree *tree, const double x[3], const double v[3],
                          double reach, double widen, double most, const int *skip, int skipped) {
  const Sweep sweep = sweep_of(x, v, reach, widen);
  struct {
    int at;
    double time;
  } stack[DEPTH];
  int top = 0;
  double first = most;
  if (tree->count > 0) {
    stack[top].at = 0;
    stack[top++].time = sweep_meets_node(&sweep, tree->nodes, most);
  }
  while (top > 0 && first > 0) {
    const int at = stack[--top].at;
    if (!(stack[top].time < first))
      continue;
    const Node *node = &tree->nodes[at];
    if (node->count == 0) { /* the child that is met first, first */
      const int child[2] = {at + 1, node->first};
      const double time[2] = {sweep_meets_node(&sweep, &tree->nodes[child[0]], first),
                              sweep_meets_node(&sweep, &tree->nodes[child[1]], first)};
      const int sooner = time[1] < time[0];
      for (int k = 0; k < 2; k++) {
        const int which = k == 0 ? !sooner : sooner;
        if (!(time[which] < first))
          continue;
        stack[top].at = child[which];
        stack[top++].time = time[which];
      }
    }
    for (int i = node->first; i < node->first + node->count; i++)
      if (!has(skip, skipped, tree->id[i]))
        first = smaller(first, sweep_meets_triangle(&sweep, &tree->triangles[i], first));
  }
  return first;
}

/* The square of the distance of x from a node's box. */
static double box_square(const Node *node, const double x[3]) {
  double square = 0;
  for (int d = 0; d < 3; d++) {
    const double off = larger(0, larger(node->lo[d] - x[d], x[d] - node->hi[d]));
    square += off * off;
  }
  return square;
}

double contact_tree_distance(const ContactTree *tree, const double x[3], double most, int *place) {
  struct {
    int at;
    double square;
  } stack[DEPTH];
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
    const Node *node = &tree->nodes[at];
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
      const double distance = contact_triangle_nearest(&tree->triangles[i], x, nearest);
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
