/* One particle on its way through a step. Its path is straight; along it the velocity changes by
 * what acts on the particle, so that a contact finds the velocity of its own instant.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_FLIGHT_H
#define ASPERITY_DEM_FLIGHT_H

#include <vector>

#include "dem/sustained.h"
#include "dem/wall.h"

namespace asperity {

/* Sine of the angle to the wall below which a particle slides. */
const double GRAZING = 1e-6;

struct Wall::Flight {
  /* A face at which the particle stayed in the step before. */
  struct Known {
    Wall *wall;
    size_t shape;
    int face;
    bool met;
  };

  /* A sustained contact as it began. The path needs the speed `keep` along `n`, which is the normal
   * where it met the wall last. */
  struct Stay {
    Wall *wall;
    size_t shape;
    Contact contact;
    double keep, n[3];
    bool is_at(const Wall *other, size_t of, const Contact &now) const;
  };

  /* The lists of one flight at a time, kept for their memory. */
  struct Lists {
    std::vector<Event> events;
    std::vector<Stay> stays;
    std::vector<Support> supports, along;
    std::vector<Known> known;
  };

  const Spheres &spheres;
  const int i;
  const double radius, mass;
  Path path;
  double begin[3], acceleration[3]; /* the velocity at a time of the path is begin + time a */
  double half[3];                   /* what the engine's second half of the step begins with */
  double spin[3];
  double x0[3], v0[3], a0[3]; /* at the beginning of the step */

  std::vector<Event> &events; /* the impacts of the step */

  /* The sustained contacts of one place, and what the particle had before them. */
  std::vector<Stay> &stays;
  std::vector<Support> &supports, &along;
  double free_half[3], free_spin[3];
  double given[3]; /* impulses per mass of those that are over */
  bool squeezed;   /* no velocity satisfies all of them */

  std::vector<Known> &known;
  bool searches_all; /* false as long as the particle meets known faces only, on its known way */
  bool far;          /* from the last contact */

  /* Contacts in a row: the first impact among them, and the spin before. */
  size_t series_begin;
  double series_spin[3];

  Flight(const Spheres &spheres, int particle, Lists &lists);
  asp_particle particle(const asp_pair *pair) const;
  double elapsed() const {
    return spheres.dt - path.left;
  }
  void velocity(double time, double v[3]) const;
  void advance(const Contact &contact, double v[3]);
  void turn(const double before[3], const double after[3], const double n[3]);
  bool has_strayed(double most) const;
  Stay *find_stay(const Wall *wall, size_t shape, const Contact &contact);
  void stay(Wall *wall, size_t shape, const Contact &contact, double hold);
  void settle();
  void give_rest(Wall *wall, size_t shape, const Contact &contact, const double end[3]) const;
  void trap();

private:
  void add_stay(Wall *wall, size_t shape, const Contact &contact, double keep, double hold);
  void follow_walls();
};

} // namespace asperity

#endif
