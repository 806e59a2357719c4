/* The numbers of each atom that a wall keeps: in rows, which LAMMPS shows, and in memories. They
 * move with the atoms between ranks and into restart files.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_LAMMPS_ATOM_ROWS_H
#define ASPERITY_LAMMPS_ATOM_ROWS_H

#include <vector>

#include "dem/wall.h"

namespace asperity {

class AtomRows {
public:
  enum { STATE = Wall::N_STATE, MOST = STATE + PACKED_MOST, SAVED_MOST = MOST + 1 };

  explicit AtomRows(Wall &wall) : wall_(wall), rows_(wall.stepper.rows) {}

  /* After the vector has moved. */
  void set_rows() {
    wall_.set_rows(state_.data());
  }
  /* A pointer to the state of each atom, as LAMMPS has arrays. */
  double **states() {
    return pointers_.data();
  }
  double bytes() const;

  void grow(int atoms);
  void copy(int from, int to);
  void clear(int i);
  int pack(int i, double *to) const; /* these two: how many numbers there are */
  int unpack(int i, const double *from);

  /* The first number is the count, including itself; `all` has those of other fixes before the
   * wall's, which are number `nth`. */
  int save(int i, double *to) const;
  void restore(int i, const double *all, int nth);

private:
  Wall &wall_;
  Memories &rows_;
  std::vector<double> state_;
  std::vector<double *> pointers_;
};

} // namespace asperity

#endif
