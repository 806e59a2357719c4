/* The bodies of fixes rigid and rigid/small; see bodies_lammps.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "bodies_lammps.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

#include "body_turn.h"
#include "contact/vector.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace LAMMPS_NS;
using asperity::Body;
using asperity::BodyMemory;
using asperity::BodyRow;
using asperity::BodySphere;
using asperity::text;

namespace {

/* In LAMMPS since 2022 the function has another name. */
template <class C> auto send(C *comm, Fix *fix, int) -> decltype(comm->forward_comm_fix(fix)) {
  return comm->forward_comm_fix(fix);
}
template <class C> auto send(C *comm, Fix *fix, long) -> decltype(comm->forward_comm(fix)) {
  return comm->forward_comm(fix);
}

} // namespace

std::string BodiesOfLammps::name_of(const Fix *fix) {
  return text("fix %s (id %s)", fix->style, fix->id);
}

std::string BodiesOfLammps::error_of(const Fix *fix) {
  static const char *const KNOWN[] = {"rigid", "rigid/small", "rigid/nve", "rigid/nve/small"};
  for (const char *known : KNOWN)
    if (strcmp(fix->style, known) == 0)
      return "";
  return name_of(fix) +
         " ties particles to bodies, which cannot rebound; bodies that can are those "
         "of rigid, rigid/small, rigid/nve and rigid/nve/small";
}

void BodiesOfLammps::fail_together(std::string wrong) const {
  struct {
    double size;
    int rank;
  } mine = {static_cast<double>(wrong.size()), lammps_->comm->me}, all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE_INT, MPI_MAXLOC, lammps_->world);
  if (!(all.size > 0))
    return;
  wrong.resize(static_cast<size_t>(all.size));
  MPI_Bcast(&wrong[0], static_cast<int>(all.size), MPI_CHAR, all.rank, lammps_->world);
  throw asperity::Error(wrong);
}

void BodiesOfLammps::init() {
  fixes_.clear();
  for (int i = 0; i < lammps_->modify->nfix; i++) {
    Fix *fix = lammps_->modify->fix[i];
    if (fix->rigid_flag && error_of(fix).empty())
      fixes_.push_back(fix);
  }
  own_.assign(3 * fixes_.size(), 0);
  if (static_cast<int64_t>(fixes_.size()) >= FIXES)
    throw asperity::Error(text("there are %zu fixes of rigid bodies; there may be %d",
                               fixes_.size(), static_cast<int>(FIXES) - 1));
}

/* The first number that a fix of bodies sends with a particle is its body's: from 0 of fix rigid
 * (-1: none), the tag of a particle of it of rigid/small (0: none). */
void BodiesOfLammps::number() {
  if (!any())
    return;
  const int n = lammps_->atom->nlocal;
  is_new_ = true;
  numbers_.assign(static_cast<size_t>(n), 0);
  std::vector<double> buffer;
  for (size_t k = 0; k < fixes_.size(); k++) {
    Fix *fix = fixes_[k];
    const int offset = strstr(fix->style, "small") ? 0 : 1;
    buffer.resize(static_cast<size_t>(std::max(1000, fix->maxexchange)));
    for (int i = 0; i < n; i++) {
      fix->pack_exchange(i, buffer.data());
      const int64_t body = static_cast<int64_t>(ubuf(buffer[0]).i) + offset;
      if (body > 0)
        numbers_[static_cast<size_t>(i)] = FIXES * body + static_cast<int64_t>(k);
    }
  }
  restore();
  forget();
}

void BodiesOfLammps::copy(int from, int to) {
  if (static_cast<size_t>(std::max(from, to)) < numbers_.size())
    numbers_[static_cast<size_t>(to)] = numbers_[static_cast<size_t>(from)];
}

/* What a restart file has of the bodies of this rank. */
void BodiesOfLammps::restore() {
  const Atom *atom = lammps_->atom;
  for (int i = 0; i < atom->nlocal && !is_restored_; i++)
    if (const BodyMemory *of = has(i) ? wall_.restored_memory(atom->tag[i]) : NULL)
      memories_[atom->tag[i]].of_wall = *of;
  is_restored_ = true;
}

/* Forgets bodies that are no more. */
void BodiesOfLammps::forget() {
  const Atom *atom = lammps_->atom;
  std::vector<int64_t> tags;
  for (int i = 0; i < atom->nlocal && !memories_.empty(); i++)
    if (has(i))
      tags.push_back(atom->tag[i]);
  std::sort(tags.begin(), tags.end());
  for (auto at = memories_.begin(); at != memories_.end();)
    at = std::binary_search(tags.begin(), tags.end(), at->first) ? std::next(at)
                                                                 : memories_.erase(at);
}

int BodiesOfLammps::pack_memory(int i, double *to) {
  const auto at = memories_.find(lammps_->atom->tag[i]);
  to[0] = at == memories_.end() ? 1 : MEMORY;
  if (at != memories_.end())
    memcpy(to + 1, &at->second, sizeof at->second);
  return static_cast<int>(to[0]);
}

int BodiesOfLammps::unpack_memory(int i, const double *from) {
  if (from[0] > 1)
    memcpy(&memories_[lammps_->atom->tag[i]], from + 1, sizeof(Memory));
  return static_cast<int>(from[0]);
}

std::vector<double> BodiesOfLammps::rows() const {
  std::vector<double> all;
  for (const auto &memory : memories_) {
    const BodyRow row = {static_cast<double>(memory.first), memory.second.of_wall};
    const double *from = reinterpret_cast<const double *>(&row);
    all.insert(all.end(), from, from + sizeof row / sizeof *from);
  }
  return all;
}

int BodiesOfLammps::pack(int n, const int *list, double *to) const {
  for (int k = 0; k < n; k++)
    std::copy_n(&sent_[SENT * static_cast<size_t>(list[k])], int{SENT}, to + SENT * k);
  return SENT * n;
}

void BodiesOfLammps::unpack(int n, int first, const double *from) {
  std::copy_n(from, SENT * static_cast<size_t>(n), row(first));
}

void BodiesOfLammps::keep() {
  const Atom *atom = lammps_->atom;
  if (!any())
    return;
  kept_.resize(9 * static_cast<size_t>(atom->nlocal));
  for (int i = 0; i < atom->nlocal; i++) {
    double *to = &kept_[9 * static_cast<size_t>(i)];
    aspi_copy(atom->x[i], to);
    aspi_copy(atom->v[i], to + 3);
    aspi_copy(atom->omega[i], to + 6);
  }
}

/* All particles of bodies that this rank sees, ordered by body and tag; each once. */
void BodiesOfLammps::read_particles(bool forces) {
  const Atom *atom = lammps_->atom;
  const int all = atom->nlocal + atom->nghost;
  sent_.resize(SENT * static_cast<size_t>(std::max(all, 1)));
  for (int i = 0; i < atom->nlocal; i++) {
    double *to = row(i);
    to[0] = static_cast<double>(numbers_[static_cast<size_t>(i)]);
    aspi_copy(atom->x[i], to + 1);
    std::copy_n(&kept_[9 * static_cast<size_t>(i)], 9, to + 4);
    std::fill_n(to + 13, 6, 0.);
    if (forces) {
      aspi_copy(atom->f[i], to + 13);
      aspi_copy(atom->torque[i], to + 16);
    }
  }
  send(lammps_->comm, fix_, 0);
  particles_.clear();
  for (int i = 0; i < all; i++)
    if (row(i)[0] > 0)
      particles_.push_back(Particle{static_cast<int64_t>(row(i)[0]), atom->tag[i], i});
  std::sort(particles_.begin(), particles_.end(), [](const Particle &a, const Particle &b) {
    return a.body != b.body ? a.body < b.body : a.tag != b.tag ? a.tag < b.tag : a.i < b.i;
  });
  particles_.erase(std::unique(particles_.begin(), particles_.end(),
                               [](const Particle &a, const Particle &b) {
                                 return a.body == b.body && a.tag == b.tag;
                               }),
                   particles_.end());
}
