/* One particle on its way through a step. Its path is straight; along it the velocity changes by
 * what acts on the particle, so that a contact finds the velocity of its own instant.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_FLIGHT_H
#define ASPERITY_DEM_FLIGHT_H

#include <vector>

#include "dem/step/stepper.h"
#include "dem/step/sustained.h"

namespace asperity {

/* Sine of the angle to the wall below which a particle slides. */
const double GRAZING = 1e-6;

/* Contacts are at one wall if the cosine between their normals is larger; at a corner they are not.
 */
const double SAME_WALL = 0.7;

/* An impact on the way of a particle. */
struct Event : Impact {
  Stepper *wall;
  double elapsed; /* of the step */
  bool grazes;    /* the particle was staying at the wall */
};

struct Flight {
  /* A face at which the particle stayed in the step before. */
  struct Known {
    Stepper *wall;
    size_t shape;
    int face;
    bool met;
  };

  /* A sustained contact as it began. Where it met the wall last, the normal was n, and the path
   * needs the least speed along n_end. */
  struct Sustained {
    Stepper *wall;
    size_t shape;
    Contact contact;
    double least_speed, n[3], n_end[3];
    bool is_at(const Stepper *other, size_t other_shape, const Contact &now) const;
  };

  /* The lists of one flight at a time, kept for their memory. */
  struct Lists {
    std::vector<Event> events;
    std::vector<Sustained> sustained;
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
  std::vector<Sustained> &sustained;
  std::vector<Support> &supports, &along;
  double free_half[3], free_spin[3];
  double settled[3]; /* impulses per mass of those that are over */
  bool squeezed;     /* no velocity satisfies all of them */

  std::vector<Known> &known;
  bool searches_all; /* false as long as the particle meets known faces only, on its known way */
  bool is_apart;     /* from the last contact */

  /* Contacts in a row: the first impact among them, and the spin before. */
  size_t series_begin;
  double series_spin[3];

  Flight(const Spheres &spheres, int particle, Lists &lists);
  double elapsed() const {
    return spheres.dt - path.left;
  }
  void velocity(double time, double v[3]) const;
  void advance(const Contact &contact, double v[3]);
  void turn(const double before[3], const double after[3], const double n[3]);
  bool has_strayed(double most) const;
  Sustained *find_sustained(const Stepper *wall, size_t shape, const Contact &contact);
  void sustain(Stepper *wall, size_t shape, const Contact &contact, double hold);
  void settle();
  void give_rest(Stepper *wall, size_t shape, const Contact &contact, const double end[3]) const;
  void trap();

private:
  void act_along(const double n[3], double ahead[3]) const;
  void add_sustained(Stepper *wall, size_t shape, const Contact &contact, double least_speed,
                     double hold);
  void follow_walls();
};

/* A contact at the end of a path, and the face of the rough wall there. Making one moves the flight
 * on to the contact. */
struct Site {
  Flight &flight;
  Stepper &wall;
  const size_t shape;
  const Path before;
  Contact &contact;
  double v[3], v1[3]; /* of the particle; relative to the wall, after what it has lost so far */
  double press;       /* acceleration that presses the particle to the wall; may be negative */
  FacePlace *face;    /* NULL: the wall is smooth */
  bool is_new, moved; /* a face not met yet; the particle has come to it along the wall */

  Site(Flight &flight, Stepper &wall, size_t shape, Contact &contact);
  asp_particle particle(double lay[3]) const;
  Event event() const;

  /* faces.cpp: finds the particle's face here, or gives it a new one. */
  void find_face();
  bool is_low() const;
  void lose_bounce() const;
  double hold(bool is_sustained) const;
  void stop_along();
  bool graze();

private:
  const FacePlace &valley() const;
  asp_key next_key() const;
  void brake(const double to[3], const double spin[3]);
};

/* hold.cpp: notes the energy of the rebounds of a flight, for the end of the step. */
void note_energy(const Flight &flight);

/* faces.cpp: true if a particle with this energy along the wall, per mass, cannot leave the valley
 * behind its face, where `push` presses it to the wall and `a` acts on it. The other walls at which
 * it stays, with these faces, take what pushes it into them. */
bool lies_in_valley(const FacePlace &face, const FacePlace *const others[], size_t count,
                    double energy, double push, const double a[3]);

/* faces.cpp: the slope that the valley withstands in which a particle lies at the end of a step;
 * 0: it lies in none. */
double hold_at_end(const Stepper &wall, const Spheres &s, int i, const Support &support,
                   const double spin[3]);

} // namespace asperity

#endif
