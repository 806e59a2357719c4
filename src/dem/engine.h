/* Interface to an engine: the functions that a wall calls at set-up and in each step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <math.h>
#include <mpi.h>
#include <stdint.h>
#include <algorithm>
#include <string>
#include <vector>

namespace asperity {

/* The simulation box. */
struct Box {
  double lo[3];     /* its lower corner */
  double period[3]; /* length along each periodic axis, 0 along the others */

  /* Moves x by whole periods to where it is nearest to `near`. */
  void bring_near(const double near[3], double x[3]) const {
    for (int d = 0; d < 3; d++)
      if (period[d] > 0)
        x[d] += period[d] * floor((near[d] - x[d]) / period[d] + 0.5);
  }

  /* Moves x by whole periods into the box. */
  void wrap(double x[3]) const {
    for (int d = 0; d < 3; d++)
      if (period[d] > 0)
        x[d] -= period[d] * floor((x[d] - lo[d]) / period[d]);
  }
};

/* A box around something, its sides along the axes. */
struct Bounds {
  double lo[3], hi[3];
  void include(const double x[3]) {
    for (int d = 0; d < 3; d++) {
      lo[d] = std::min(lo[d], x[d]);
      hi[d] = std::max(hi[d], x[d]);
    }
  }
  void widen(double by) {
    for (int d = 0; d < 3; d++) {
      lo[d] -= by;
      hi[d] += by;
    }
  }
  std::string describe() const;
  static Bounds none() {
    return Bounds{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  }
  /* The box of a sphere that moves from x by v, between two times. */
  static Bounds of_path(const double x[3], const double v[3], double from, double to,
                        double radius);
};

/* The spheres of this rank, at the end of a step without walls; valid for one call. Vectors are
 * rows of three. */
struct Spheres {
  int64_t step;
  double dt;
  int n;
  const int *mask, *type; /* type from 1 */
  const void *tag;        /* integers of tag_bytes (4 or 8) each */
  int tag_bytes;
  double *x, *v, *omega; /* omega may be NULL */
  double *f, *torque;    /* what acts on them; at the end of a step walls add to it */
  const double *radius, *mass;

  int64_t tag_of(int i) const {
    return tag_bytes == 4 ? static_cast<const int32_t *>(tag)[i]
                          : static_cast<const int64_t *>(tag)[i];
  }
};

class Engine {
public:
  virtual ~Engine() {}

  virtual MPI_Comm world() const = 0;
  virtual std::string id() const = 0;          /* of the fix */
  virtual std::string units() const = 0;       /* the unit style of the script */
  virtual std::string known_units() const = 0; /* "si, cgs or micro": those that are tested */
  virtual int types() const = 0;               /* how many types of atoms there are */
  virtual int dimension() const = 0;           /* 3, or 2: all in the plane z = 0 */
  virtual double time() const = 0;             /* at the present step */

  /* Once, by rank 0; all ranks call. */
  virtual void warn(const std::string &what) const = 0;
  virtual void print(const std::string &what) const = 0;

  /* The values of a constant of the script by its name, one for each type or each pair of types,
   * row by row; none where the script has none. Returns the command that states such a constant,
   * without values, for an error message; empty if there is none. */
  virtual std::string constants(const char *, bool, std::vector<double> &values) const {
    values.clear();
    return "";
  }

  /* The numbers of that name of this rank's particles; throws an Error that tells the names. */
  virtual const double *numbers(const std::string &name) const = 0;

  /* The diameters of the group's particles that there are or will be, of all ranks. Both 0: none.
   */
  virtual void diameters(double &least, double &most) const = 0;

  /* For each type, whether there are such particles, or will be, and the least and the largest of
   * their densities (0: not there yet); of all ranks. */
  struct Kind {
    bool present;
    double least, most;
  };
  virtual std::vector<Kind> kinds() const = 0;

  int rank() const {
    int rank;
    MPI_Comm_rank(world(), &rank);
    return rank;
  }
};

/* Extends a range of diameters, both 0 if there are none yet, by those of a group; of all ranks of
 * `world`. */
void add_diameters(const Spheres &spheres, int group, MPI_Comm world, double &least, double &most);

/* The kinds of the spheres of a group; `present` has a number over 0 for each type of which there
 * will be some. Of all ranks of `world`. */
std::vector<Engine::Kind> kinds_of(const Spheres &spheres, int group,
                                   const std::vector<double> &present, MPI_Comm world);

/* The items (double or char) of all ranks, one rank's behind another's: on rank 0, and on all of
 * them. Collective. */
template <class Item> std::vector<Item> gather(const std::vector<Item> &mine, MPI_Comm world);
std::vector<double> gather_for_all(const std::vector<double> &mine, MPI_Comm world);

/* A text of rank 0 on all ranks. */
std::string share(std::string text, MPI_Comm world);

} // namespace asperity
