/* The numbers of each atom that a wall keeps, in rows, which move with the atoms between ranks and
 * into restart files.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_LAMMPS_ATOM_ROWS_H
#define ASPERITY_LAMMPS_ATOM_ROWS_H

#include <vector>

#include "dem/wall.h"

namespace asperity {

class AtomRows {
public:
  enum { STATE = Wall::N_STATE, PLACE = Wall::N_PLACE, ALL = STATE + PLACE, SAVED = ALL + 1 };

  double *state() {
    return state_.data();
  }
  double *place() {
    return place_.data();
  }
  /* A pointer to the state of each atom, as LAMMPS has arrays. */
  double **states() {
    return rows_.data();
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
  std::vector<double> state_, place_;
  std::vector<double *> rows_;
};

} // namespace asperity

#endif
