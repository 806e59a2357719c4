/* State of each particle at a wall: two rows of numbers that the engine stores, moves between
 * ranks, and writes into restart files; all 0 at first.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_PARTICLE_STATE_H
#define ASPERITY_DEM_PARTICLE_STATE_H

#include <stddef.h>

namespace asperity {

/* Relative rounding of velocities, times and distances that are compared. */
const double ROUNDING = 1e-9;

/* The values are in restart files, and per-atom output shows them: 1 is stuck, less than 0 is at
 * the wall in this step. */
enum class Status {
  FREE = 0,
  STUCK = 1,
  TO_DELETE = 2,  /* stuck, and to be deleted */
  RESTING = -1,   /* at the wall, which holds it until the next step */
  REBOUNDED = -3, /* has rebounded in this step */
};

struct ParticleState {
  double impacts;  /* on this wall */
  double status;   /* a Status */
  double force[3]; /* on the wall, in the last step */
  double point[3]; /* where it acted last; of a stuck particle its center */
};

/* Position of a stuck particle in the frame of its shape (of the world, where that is gone), and
 * its velocity. */
struct StuckPlace {
  double shape; /* from 1; 0: gone */
  double piece, at[3], velocity[3];
  double is_kept; /* 1: the books keep its load, and its force is that of a whole step */
};

/* A face of a shape at which a sphere rests, and by what the wall accelerates it, or its body,
 * there. */
struct Rest {
  double sphere; /* its tag */
  double shape;  /* from 1; 0: none, and none behind it */
  double face, push[3];
};

/* The energy of a rebound, at a piece of a shape (from 0): v_n^2 at the end of the step is square +
 * work a_n. */
struct ReboundPlace {
  double square, work, normal[3], v_wall[3], shape, piece;
};

/* A face of a rough wall that a sphere has met, and the valley behind it. */
struct FacePlace {
  double sphere;        /* its tag */
  double at[3];         /* the contact point at that instant, moving with the wall */
  double normal[3];     /* of the mean wall, at the last contact; 0: there is no such face */
  double time;          /* of the last contact */
  double start, height; /* an asp_valley; 0: not drawn yet */
};

/* One of the three by the status, and the faces that a particle remembers: those of the walls of a
 * corner. */
struct ParticlePlace {
  static const size_t RESTS = 3, FACES = 3;
  union {
    StuckPlace stuck;
    Rest rests[RESTS];
    ReboundPlace rebound;
  };
  FacePlace faces[FACES];
  double draws; /* of valleys, and of faces that it met while it rested */
};

/* The rows of this rank's particles at one wall. */
struct ParticleRows {
  ParticleState *state;
  ParticlePlace *place;

  Status status(int i) const {
    return static_cast<Status>(static_cast<int>(state[i].status));
  }
  void set_status(int i, Status now) const {
    state[i].status = static_cast<double>(now);
  }
  bool is_stuck(int i) const {
    return status(i) == Status::STUCK || status(i) == Status::TO_DELETE;
  }
};

} // namespace asperity

#endif
