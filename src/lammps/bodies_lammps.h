/* The bodies of LAMMPS's fixes rigid and rigid/small, for a wall, by public means only. A body is
 * read from its particles after the step has moved them, by the rank that has the one with the
 * lowest tag; the others must be among that rank's ghosts. It gets its new position and velocity by
 * its own fix, from forces for which that fix integrates a second time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_BODIES_LAMMPS_H
#define LMP_BODIES_LAMMPS_H

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "fix.h"
#include "dem/wall.h"

namespace LAMMPS_NS {

class BodiesOfLammps {
public:
  BodiesOfLammps(LAMMPS *lammps, Fix *fix, const asperity::Wall &wall)
      : lammps_(lammps), fix_(fix), wall_(wall), is_new_(true), is_restored_(false),
        is_any_stuck_(false) {
    bodies_.begins = true;
  }

  /* What walls cannot do with a fix that ties particles to bodies; empty: nothing. */
  static std::string error_of(const Fix *fix);

  /* Before a run: finds the fixes. */
  void init();
  bool any() const {
    return !fixes_.empty();
  }

  /* After particles have come, gone, or moved between ranks; and when one of them is moved. */
  void number();
  void copy(int from, int to);
  bool has(int i) const {
    return static_cast<size_t>(i) < numbers_.size() && numbers_[static_cast<size_t>(i)] > 0;
  }

  /* At the end of a step, and at the beginning of a run: keeps where the particles are. */
  void keep();

  /* The bodies of this rank, with the memories of the walls of a run, after the first half of a
   * step; and moves those that have met a wall. Collective. Throw an asperity::Error. */
  typedef std::vector<BodiesOfLammps *> Walls;
  asperity::Bodies *take(const Walls &walls);
  void put();

  /* The same at the end of a step, after keep(), if a body is stuck on any rank, else NULL; then
   * only velocities change. */
  asperity::Bodies *take_stuck(const Walls &walls);
  void put_velocities();

  /* Lists the bodies of all ranks that this wall deletes; collective. True for a particle of one.
   */
  void list_deleted();
  bool is_deleted(int i) const {
    return has(i) &&
           std::binary_search(deleted_.begin(), deleted_.end(), numbers_[static_cast<size_t>(i)]);
  }

  /* What is remembered of the body of which a particle has the lowest tag, as it moves to another
   * rank: how many numbers there are; and all of it for a restart file. */
  int pack_memory(int i, double *to);
  int unpack_memory(int i, const double *from);
  std::vector<double> rows() const;

  /* Of each particle to its ghosts: the number of its body, its place, and that of the end of the
   * step before with velocity, spin, force and torque. */
  enum { SENT = 19 };
  int pack(int n, const int *list, double *to) const;
  void unpack(int n, int first, const double *from);

private:
  struct Particle {
    int64_t body, tag;
    int i;
  };

  /* Forces for the fixes to integrate, in the place of the particles' own. */
  class Kick;

  /* Of a body: its number, its axes at the end of the last step, and what it remembers. */
  struct Memory {
    double body, has_axes, axes[3][3];
    asperity::BodyMemory of_wall;
  };

public:
  enum { MEMORY = sizeof(Memory) / sizeof(double) + 1 };

private:
  /* Fixes of bodies, at most: the number of a body is that in its fix, times this, and the fix's.
   */
  static const int64_t FIXES = 16;

  void restore();
  void forget();
  void read_particles(bool forces);
  void read_bodies(const Walls &walls, bool forces);
  void add_body(size_t from, size_t to, const Walls &walls, double time);
  void set_axes(asperity::Body &body, const double inertia[6], const Walls &walls, double time);
  void find_own();
  void set_momentum(asperity::Body &body, size_t from);
  int count_turns() const;
  void integrate(Kick &kick, std::vector<asperity::Body> &now, int number, int count);
  void accelerate(Kick &kick, const std::vector<asperity::Body> &now);
  void arm_of(int i, const double center[3], double arm[3]) const;
  std::string velocity_error(size_t b, const asperity::Body &way) const;
  std::string masses_error() const;
  /* Throws the error of the first rank that has one: LAMMPS shows those of rank 0 only. */
  void fail_together(std::string wrong) const;
  static std::string name_of(const Fix *fix);
  Fix *fix_of(const Particle &particle) const {
    return fixes_[static_cast<size_t>(particle.body % FIXES)];
  }
  const double *own_of(const Particle &particle) const {
    return &own_[3 * static_cast<size_t>(particle.body % FIXES)];
  }
  double *row(int i) {
    return &sent_[SENT * static_cast<size_t>(i)];
  }

  LAMMPS *lammps_;
  Fix *fix_; /* the wall's */
  const asperity::Wall &wall_;
  std::vector<Fix *> fixes_;
  std::vector<double> own_, added_;    /* accelerations that each fix, and of each body its, adds */
  bool is_new_;                        /* particles have moved between ranks since the last step */
  bool is_restored_;                   /* what was in a restart file has been taken */
  bool is_any_stuck_;                  /* on any rank, in this step */
  std::vector<int64_t> numbers_;       /* of the body of each particle of this rank; 0: none */
  std::map<int64_t, Memory> memories_; /* by the lowest tag of the body */
  std::vector<double> deleted_;        /* numbers of bodies */
  std::vector<double> kept_;           /* x, v, and omega of each particle */
  std::vector<double> sent_;           /* of each particle, with ghosts */
  std::vector<Particle> particles_;
  asperity::Bodies bodies_;
  std::vector<asperity::Body> before_; /* the bodies as they were taken */
  std::vector<Particle> firsts_;       /* the first particle of each */
};

} // namespace LAMMPS_NS

#endif
