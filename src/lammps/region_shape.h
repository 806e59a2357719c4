/* A region of LAMMPS as a wall: block, cone, cylinder, plane, prism, sphere, and unions and
 * intersections of them, at rest, or moved and turned by variables. The nearest points of its faces
 * come from region_part.h. Computed here: the first contact along a path, and the faces of its
 * parts that a union hides.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <string>
#include <vector>

#include "region_part.h"
#include "dem/shapes/shape.h"

namespace LAMMPS_NS {

class RegionShape : public asperity::Shape {
public:
  /* Throws an asperity::Error. */
  RegionShape(LAMMPS *lammps, const std::string &id);

  /* Description of the region, equal for equal regions. */
  std::string description() const;

  /* Before a run: it may have been deleted, or defined anew. Throws an asperity::Error. */
  void init();

  /* At the beginning of a run, and of each step: its variables are computed; collective. setup: how
   * far it stands from where the last step has left it. */
  double setup();
  void begin_step();

  bool is_still() const override;
  double travel(double) const override {
    return travel_;
  }
  double clear(const asperity::Course &course, const asperity::FaceList &stays) const override;
  bool separate(const double x[3], double reach, const asperity::FaceList &stays,
                asperity::BarrierList &made) const override;
  double gap(const asperity::Barriers &all, const double from[3], const double to[3],
             double radius) const override;
  bool find(const asperity::Path &path, double radius, double latest,
            asperity::Contact &contact) const override;
  bool under(int face, const double x[3], const double v[3], double reach, asperity::Contact &at,
             double &distance) const override;
  void stick(const asperity::Path &path, const asperity::Contact &contact,
             asperity::Place &place) const override;
  void carry(asperity::Place &place, double radius, double dt, double x[3],
             double v[3]) const override;
  void turn(const asperity::Place &place, double share, double dt, double axes[3][3],
            double omega[3]) const override;
  void lay(const asp_lay &lay, const asperity::Path &path, const asperity::Contact &contact,
           double direction[3]) const override;
  std::vector<double> motion_record() const override;
  void restore_motion(const std::vector<double> &record) override;

private:
  /* A region and what it is made of. */
  struct Node {
    class Region *region;
    int part; /* -1: a union or an intersection */
    bool is_union;
    std::vector<Node> of;
  };

  typedef RegionFoot Foot;

  /* Faces near a point of the path. */
  struct Look {
    double time = 0, x[3] = {};
    bool in_room = false;
    std::vector<Foot> feet;
  };

  /* Buffers of one search at a time, kept to reuse their memory. */
  struct Buffers {
    Look good, now, between;
    std::vector<Foot> feet;
  };

  struct Search;

  void add_region(class Region *region, Node &node);
  class Region *find_region() const;
  void set_share(double share) const;
  bool in_room(const Node &node, bool flip, const double x[3]) const;
  void find_feet(const Node &node, bool flip, const double x[3], double reach,
                 std::vector<Foot> &feet) const;

  double curve(double share, const Foot &foot, const double x[3], double radius,
               const double v[3]) const;

  LAMMPS *lammps_;
  std::string id_;
  Node root_;
  std::vector<RegionPart> parts_;
  bool open_, flat_;      /* any part has an open face; all faces are flat */
  double travel_, speed_; /* of the fastest point in this step */
  mutable Buffers buffers_;
};

} // namespace LAMMPS_NS
