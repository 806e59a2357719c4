/* The triangles of a mesh for all ranks: one copy in each node, in memory that its ranks share, by
 * MPI-3. Where MPI has no such memory, each rank has a copy.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_NODE_TREE_H
#define ASPERITY_DEM_NODE_TREE_H

#include <mpi.h>
#include <vector>

#include "contact/tree.h"

namespace asperity {

class NodeTree {
public:
  NodeTree() : keeps_(true) {}
  ~NodeTree();
  NodeTree(const NodeTree &) = delete;
  NodeTree &operator=(const NodeTree &) = delete;

  /* From rank 0's tree, which it frees (the others give NULL), a tree for this rank; NULL when out
   * of memory. It is valid while this object is. Collective, as is the end of the object. */
  ContactTree *spread(MPI_Comm world, ContactTree *tree);

  /* True if this rank has the triangles in its own memory, and not in another one's. */
  bool keeps() const {
    return keeps_;
  }

  /* True where MPI has no memory that ranks share. */
  bool each_keeps() const {
    return !own_.empty();
  }

private:
  void *open_block(MPI_Comm world, MPI_Comm node, size_t bytes);

  MPI_Win window_ = MPI_WIN_NULL;
  std::vector<double> own_; /* without a window */
  bool keeps_;
};

} // namespace asperity

#endif
