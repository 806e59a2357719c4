/* The numbers of each atom; see atom_rows.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "atom_rows.h"

#include <algorithm>

using namespace asperity;

double AtomRows::bytes() const {
  return (state_.capacity() + place_.capacity()) * sizeof(double) +
         rows_.capacity() * sizeof(double *);
}

void AtomRows::grow(int atoms) {
  const size_t n = static_cast<size_t>(atoms);
  state_.reserve(n * STATE); /* no more than that */
  place_.reserve(n * PLACE);
  state_.resize(n * STATE);
  place_.resize(n * PLACE);
  rows_.resize(n);
  for (size_t i = 0; i < n; i++)
    rows_[i] = &state_[i * STATE];
}

void AtomRows::copy(int from, int to) {
  const size_t a = static_cast<size_t>(from), b = static_cast<size_t>(to);
  std::copy_n(&state_[a * STATE], int{STATE}, &state_[b * STATE]);
  std::copy_n(&place_[a * PLACE], int{PLACE}, &place_[b * PLACE]);
}

void AtomRows::clear(int i) {
  const double none[ALL] = {0};
  unpack(i, none);
}

int AtomRows::pack(int i, double *to) const {
  const size_t n = static_cast<size_t>(i);
  std::copy_n(&state_[n * STATE], int{STATE}, to);
  std::copy_n(&place_[n * PLACE], int{PLACE}, to + STATE);
  return ALL;
}

int AtomRows::unpack(int i, const double *from) {
  const size_t n = static_cast<size_t>(i);
  std::copy(from, from + STATE, &state_[n * STATE]);
  std::copy(from + STATE, from + ALL, &place_[n * PLACE]);
  return ALL;
}

int AtomRows::save(int i, double *to) const {
  to[0] = SAVED;
  return pack(i, to + 1) + 1;
}

void AtomRows::restore(int i, const double *all, int nth) {
  for (int before = 0; before < nth; before++)
    all += static_cast<int>(*all);
  if (static_cast<int>(*all) == SAVED)
    unpack(i, all + 1);
  else
    clear(i);
}
