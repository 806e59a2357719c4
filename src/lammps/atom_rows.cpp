/* The numbers of each atom; see atom_rows.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "atom_rows.h"

#include <algorithm>

using namespace asperity;

double AtomRows::bytes() const {
  return static_cast<double>(state_.capacity() * sizeof(double) +
                             pointers_.capacity() * sizeof(double *));
}

void AtomRows::grow(int atoms) {
  const size_t n = static_cast<size_t>(atoms);
  state_.reserve(n * STATE); /* no more than that */
  state_.resize(n * STATE);
  pointers_.resize(n);
  for (size_t i = 0; i < n; i++)
    pointers_[i] = &state_[i * STATE];
  rows_.grow(atoms);
  set_rows();
}

void AtomRows::copy(int from, int to) {
  std::copy_n(pointers_[from], int{STATE}, pointers_[to]);
  rows_.copy(from, to);
}

void AtomRows::clear(int i) {
  std::fill_n(pointers_[i], int{STATE}, 0.0);
  rows_.clear(i);
}

int AtomRows::pack(int i, double *to) const {
  std::copy_n(pointers_[i], int{STATE}, to);
  return STATE + rows_.pack(i, to + STATE);
}

int AtomRows::unpack(int i, const double *from) {
  std::copy_n(from, int{STATE}, pointers_[i]);
  return STATE + rows_.unpack(i, from + STATE);
}

int AtomRows::save(int i, double *to) const {
  to[0] = 1 + pack(i, to + 1);
  return static_cast<int>(to[0]);
}

void AtomRows::restore(int i, const double *all, int nth) {
  unpack(i, Memories::part(all, nth) + 1);
}
