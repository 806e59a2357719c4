/* Triangles that the ranks of a node share; see mesh.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/shapes/mesh.h"

#include <algorithm>

using namespace asperity;

/* Bytes a message. */
static const size_t MESSAGE = 1 << 24;

NodeTree::~NodeTree() {
  int over = 1;
  if (window_ != MPI_WIN_NULL)
    MPI_Finalized(&over);
  if (!over)
    MPI_Win_free(&window_);
}

/* Memory for a tree: of the node's rank 0, which the others see, or of each rank. */
void *NodeTree::open_block(MPI_Comm world, MPI_Comm node, size_t bytes) {
  void *block = NULL;
  MPI_Aint size;
  int unit, all, place;
  MPI_Comm_rank(node, &place);
  MPI_Comm_set_errhandler(node, MPI_ERRORS_RETURN);
  int good = MPI_Win_allocate_shared(place == 0 ? static_cast<MPI_Aint>(bytes) : 0, 1,
                                     MPI_INFO_NULL, node, &block, &window_) == MPI_SUCCESS;
  if (!good)
    window_ = MPI_WIN_NULL;
  else if (MPI_Win_shared_query(window_, 0, &size, &unit, &block) != MPI_SUCCESS)
    good = 0;
  MPI_Allreduce(&good, &all, 1, MPI_INT, MPI_MIN, world);
  keeps_ = !all || place == 0;
  if (all)
    return block;
  if (window_ != MPI_WIN_NULL)
    MPI_Win_free(&window_);
  own_.resize(bytes / sizeof(double) + 1);
  return own_.data();
}

ContactTree *NodeTree::spread(MPI_Comm world, ContactTree *tree) {
  int rank, ranks;
  MPI_Comm_rank(world, &rank);
  MPI_Comm_size(world, &ranks);
  if (ranks == 1)
    return tree;
  size_t bytes = tree ? aspi_tree_bytes(tree) : 0;
  MPI_Bcast(&bytes, sizeof bytes, MPI_BYTE, 0, world);
  MPI_Comm node, keepers;
  MPI_Comm_split_type(world, MPI_COMM_TYPE_SHARED, rank, MPI_INFO_NULL, &node);
  char *block = static_cast<char *>(open_block(world, node, bytes));
  MPI_Comm_split(world, keeps_ ? 0 : MPI_UNDEFINED, rank, &keepers);
  if (rank == 0) {
    aspi_tree_pack(tree, block);
    aspi_tree_free(tree);
  }
  if (keepers != MPI_COMM_NULL) {
    for (size_t at = 0; at < bytes; at += MESSAGE)
      MPI_Bcast(block + at, static_cast<int>(std::min<size_t>(MESSAGE, bytes - at)), MPI_BYTE, 0,
                keepers);
    MPI_Comm_free(&keepers);
  }
  if (window_ != MPI_WIN_NULL)
    MPI_Win_fence(0, window_); /* the others see what is written */
  MPI_Comm_free(&node);
  return aspi_tree_over(block);
}
