/* A mesh of triangles as a wall: at rest, or moving as a rigid body, or with a surface that runs
 * along itself (a belt). Contacts are found in the mesh's own frame, by its own tree of boxes,
 * however long the step is, as long as the mesh turns by less than a quarter of a turn in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "contact/tree.h"
#include "dem/engine.h"
#include "dem/shapes/motion.h"
#include "dem/shapes/shape.h"

namespace asperity {

/* The triangles of a mesh for all ranks: one copy in each node, in memory that its ranks share, by
 * MPI-3. Where MPI has no such memory, each rank has a copy. */
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

class MeshShape : public Shape {
public:
  MeshShape();
  ~MeshShape() override;

  /* Takes the triangles, in the mesh's own frame, that `add` gives to the tree of rank 0, for all
   * ranks. add: false when out of memory; all ranks throw an Error that it throws. Collective. */
  void build(MPI_Comm world, const std::function<bool(ContactTree *)> &add);

  /* Call when the mesh has moved, or the box may have changed. True if the box has other periods
   * than before. */
  bool set_images(const Box &box);

  Motion &motion() {
    return motion_;
  }
  const Motion &motion() const {
    return motion_;
  }
  const ContactTree *triangles() const {
    return tree_.get();
  }

  double travel(double dt) const override;
  double clear(const Course &course, const FaceList &stays) const override;
  bool separate(const double x[3], double reach, const FaceList &stays,
                BarrierList &made) const override;
  double gap(const Barriers &all, const double from[3], const double to[3],
             double radius) const override;
  bool repeats(int axis) const override;
  bool find(const Path &path, double radius, double latest, Contact &contact) const override;
  bool under(int face, const double x[3], const double v[3], double reach, Contact &at,
             double &distance) const override;
  bool is_still() const override;
  void stick(const Path &path, const Contact &contact, Place &place) const override;
  void carry(Place &place, double radius, double dt, double x[3], double v[3]) const override;
  void turn(const Place &place, double share, double dt, double axes[3][3],
            double omega[3]) const override;
  size_t bytes() const override;
  void lay(const asp_lay &lay, const Path &path, const Contact &contact,
           double direction[3]) const override;
  bool is_across(const double direction[3]) const override;

protected:
  /* True where MPI has no memory that the ranks of a node share. */
  bool each_keeps() const {
    return shared_.each_keeps();
  }
  Bounds whole() const; /* around all triangles */

  /* A belt: a mesh at rest whose surface runs. v: at the point `foot` of a triangle. */
  virtual bool runs() const {
    return false;
  }
  virtual void surface_velocity(int, const double[3], double v[3]) const {
    v[0] = v[1] = v[2] = 0;
  }

private:
  struct Shift {
    double by[3];
  };
  static const std::vector<Shift> ITSELF;
  /* Tree indices: the triangle that gets the load, and the one that gives the normal. */
  struct Places {
    int piece, face;
  };

  Bounds swept() const;
  double period_of(const Path &path) const;
  Bounds around(const Path &path, double from, double to, double radius) const;
  const std::vector<Shift> &images(const Bounds &region) const;
  const std::vector<Shift> &images_at(const double x[3], double reach) const {
    const double still[3] = {0, 0, 0};
    return period_[0] + period_[1] + period_[2] > 0 ? images(Bounds::of_path(x, still, 0, 0, reach))
                                                    : ITSELF;
  }
  const std::vector<Shift> &images_ahead(const Course &course, double &steps) const;
  void local_path(const Path &path, const Shift &shift, ContactPath &local) const;
  const ContactList &meet(const Bounds &box, double reach) const;
  bool clip(const ContactPath &local, double radius, double &from, double &to) const;
  bool find_image(const ContactPath &local, double radius, double from, double latest,
                  ContactTouch &touch, Places &place) const;
  bool find_piece(const Path &path, double radius, double from, double latest,
                  Contact &contact) const;
  void set_contact(const Path &path, const ContactPath &local, const Shift &shift, double radius,
                   const ContactTouch &touch, const Places &place, Contact &contact) const;
  bool walk(Place &place, double radius, double dt) const;

  NodeTree shared_;
  std::unique_ptr<ContactTree, void (*)(ContactTree *)> tree_;
  Motion motion_;
  double period_[3];                  /* 0 along an axis that is not periodic */
  Bounds swept_;                      /* around the mesh in this step */
  mutable std::vector<Shift> shifts_; /* what images() has found */
  mutable ContactList near_;          /* what meet() has found */
};

} // namespace asperity
