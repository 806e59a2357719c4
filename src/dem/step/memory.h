/* What movers remember of a wall, and how that is packed for other ranks and for restart files.
 * Most have not been at the wall and remember nothing, so that only a few numbers of each lie in
 * rows: those that per-atom output shows. They are 0 at first.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <mpi.h>
#include <stddef.h>
#include <stdint.h>
#include <memory>
#include <vector>

#include "contact/tolerances.h"

namespace asperity {

/* The values are in restart files, and per-atom output shows them: 1 is stuck, less than 0 is at
 * the wall in this step. */
enum class Status {
  FREE = 0,
  STUCK = 1,
  TO_DELETE = 2,  /* stuck, and to be deleted */
  RESTING = -1,   /* at the wall, which holds it until the next step */
  REBOUNDED = -3, /* has rebounded in this step */
};

/* What per-atom output shows. */
struct MoverState {
  double impacts;  /* on this wall */
  double status;   /* a Status */
  double force[3]; /* on the wall, in the last step */
  double point[3]; /* where it acted last; of a stuck particle its center */
};

/* Where a stuck mover is held: the center of one of its spheres, in the frame of the shape (of the
 * world, where that is gone), and the axes of a body; and the velocities that it has there. */
struct Stuck {
  double sphere;      /* its tag */
  double shape;       /* from 1; 0: gone */
  double piece, face; /* of the shape, where it is; of the contact by which it has stuck */
  double at[3], axes[3][3], v[3], omega[3];
  double removal; /* integral over time of the rate at which the flow removes it */
  double is_kept; /* 1: the books keep its load, and its force is that of a whole step */
};

/* A face of a shape at which a sphere rests, and the accelerations that the wall gives its mover
 * there: linear, and angular. */
struct Rest {
  double sphere; /* its tag */
  double shape;  /* from 1 */
  double face, push[3], twist[3];
};

/* The energy of a rebound, at a piece of a shape (from 0): v_n^2 at the end of the step is square +
 * work a_n. */
struct Rebound {
  double square, work, normal[3], v_wall[3], shape, piece;
};

/* A face of a rough wall that a sphere has met, and the valley behind it. */
struct FacePlace {
  double sphere;                     /* its tag */
  double at[3];                      /* the contact point at that instant, moving with the wall */
  double normal[3];                  /* of the mean wall, at the last contact */
  double time;                       /* of the last contact */
  double start, height, place, rise; /* an asp_valley; start 0: it is not drawn yet */
  double length;                     /* of the face, where the wall has no lay */
};

/* FacePlace::place of a sphere that lies at the bottom of its valley, and of one that has fallen
 * into it, as long as the valley is not drawn. */
const double AT_BOTTOM = 0, TO_DRAW = 1;

/* Of a particle in a step that has not ended. */
struct Load {
  double waits;              /* 1: there is one */
  double force[3], point[3]; /* as MoverState shows them at its end */
};

/* What it remembers but for lists. */
struct MemoryHead {
  double draws;   /* of valleys, and of faces that it met while it rested */
  double free[3]; /* where it rests, its acceleration without walls at the end of the last step */
  Load load;
};

struct Memory : MemoryHead {
  std::vector<FacePlace> faces;
  std::vector<Rest> rests;      /* those of status RESTING */
  std::vector<Rebound> rebound; /* one, of status REBOUNDED */
  std::vector<Stuck> stuck;     /* one, of status STUCK or TO_DELETE */

  Memory() : MemoryHead() {}

  /* Calls of() for each list: packing, sizes and restart files follow from this. */
  template <class Of> void each(Of &of) {
    of(faces);
    of(rests);
    of(rebound);
    of(stuck);
  }
};

/* What the particles, or the bodies, of this rank remember of a wall, each by its index. */
struct Memories {
  MoverState *state;
  std::vector<std::unique_ptr<Memory>> memory; /* NULL: nothing */
  std::vector<char> loaded;                    /* not 0: it may have a force */

  Status status(int i) const {
    return static_cast<Status>(static_cast<int>(state[i].status));
  }
  bool is_stuck(int i) const {
    return state[i].status > 0;
  }
  Memory *find(int i) const {
    return memory[static_cast<size_t>(i)].get();
  }
  Memory &own(int i) {
    std::unique_ptr<Memory> &of = memory[static_cast<size_t>(i)];
    if (!of)
      of.reset(new Memory());
    return *of;
  }
  /* Where it is stuck, if it is. */
  Stuck &stuck(int i) {
    Memory &of = own(i);
    of.stuck.resize(1);
    return of.stuck[0];
  }
  /* Clears the lists that do not belong to this status. */
  void set_status(int i, Status now);
  /* False if the status has no list behind it: a sphere shows that of the body that it was part of.
   */
  bool has_list(int i) const {
    const Memory *of = find(i);
    const Status now = status(i);
    return now == Status::FREE || (of && !(now == Status::RESTING     ? of->rests.empty()
                                           : now == Status::REBOUNDED ? of->rebound.empty()
                                                                      : of->stuck.empty()));
  }
  /* It is not the wall's any more: only the number of its impacts stays. */
  void forget(int i) {
    set_status(i, Status::FREE);
    if (Memory *of = find(i))
      of->faces.clear();
  }
  size_t bytes() const;

  /* As engines move their particles. A packed memory begins with how many numbers it has; pack and
   * unpack return that. */
  void grow(int n) {
    memory.resize(static_cast<size_t>(n));
    loaded.resize(static_cast<size_t>(n));
  }
  void copy(int from, int to);
  void clear(int i) {
    memory[static_cast<size_t>(i)].reset();
  }
  int pack(int i, double *to) const;
  int unpack(int i, const double *from);
};

/* Those of the bodies that were claimed last, in their order. */
class BodyMemories : public Memories {
public:
  BodyMemories() : Memories(), restored_(0) {}

  /* The bodies of this rank are those with these tags. Their memories come from the rank that has
   * them; those that nobody claims are forgotten. Collective. */
  void claim(const std::vector<int64_t> &tags, MPI_Comm world);

  /* All memories of this rank, for a restart file. */
  std::vector<double> pack() const;

  /* From a restart file, to be claimed, after change(state, memory). Throws an Error if the numbers
   * are no memories. */
  template <class Change> void restore(const std::vector<double> &all, Change change) {
    for (size_t at = 0; at < all.size();) {
      MoverState its;
      Memories one;
      one.grow(1);
      const int64_t tag = read(all, at, its, one);
      change(its, one.own(0));
      write(tag, its, one, 0, waiting_);
      restored_++;
    }
  }
  /* How many were restored since the last call. */
  size_t take_restored() {
    const size_t all = restored_;
    restored_ = 0;
    return all;
  }

private:
  static void write(int64_t tag, const MoverState &its, const Memories &rows, size_t i,
                    std::vector<double> &to);
  static int64_t read(const std::vector<double> &all, size_t &at, MoverState &its, Memories &one);

  std::vector<int64_t> tags_;
  std::vector<MoverState> states_;
  std::vector<double> waiting_; /* packed */
  size_t restored_;
};

/* A particle remembers the faces of the walls of a corner; a body so many for each sphere. */
const size_t FACES_MOST = 3, RESTS_MOST = 3;

/* The most numbers that a particle's memory packs to: it has one list by its status. */
const size_t STUCK_SIZE = sizeof(Stuck), RESTS_SIZE = RESTS_MOST * sizeof(Rest);
const int PACKED_MOST = 5 + static_cast<int>((sizeof(MemoryHead) + FACES_MOST * sizeof(FacePlace) +
                                              (RESTS_SIZE > STUCK_SIZE ? RESTS_SIZE : STUCK_SIZE)) /
                                             sizeof(double));
static_assert(sizeof(Rebound) <= sizeof(Stuck),
              "the longest list is that of a stuck or resting one");

} // namespace asperity
