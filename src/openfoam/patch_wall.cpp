/* One rough wall, in words; see patch_walls.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "asperity_engine.h"
#include "dem/error.h"
#include "dem/books/ledger_file.h"
#include "dem/text.h"
#include "openfoam/patch_walls.h"

using namespace asperity;

PatchWall::PatchWall(const std::string &name_, const std::string &key, const std::string &words,
                     const Cloud &cloud)
    : name(name_), worn_density(0), words_(NULL, asp_description_free), wall_(NULL, asp_wall_free),
      key_(asp_key_wall(key.c_str())) {
  asp_error wrong;
  words_.reset(asp_description_parse(words.c_str(), NULL, &wrong));
  if (!words_)
    throw Error(wrong.text);
  deletes = strcmp(asp_description_word(words_.get(), "deposit"), "delete") == 0;
  has_flow = asp_description_is_given(words_.get(), "remove");
  temperature_ = asp_description_is_given(words_.get(), "temperature")
                     ? asp_description_get(words_.get(), "temperature")
                     : 0;
  check(cloud);
  wall_.reset(asp_wall_create(words_.get(), cloud.d_least, cloud.d_most, &wrong));
  const asp_surface *surface = wall_ ? asp_wall_surface(wall_.get()) : NULL;
  if (!wall_ || (surface && cloud.d_most > 0 && asp_surface_check(surface, cloud.d_most, &wrong)))
    throw Error(wrong.text);
  if (asp_description_is_given(words_.get(), "erosion"))
    worn_density = asp_description_get(words_.get(), "density");
  const asp_material *target = asp_description_material(words_.get(), 1);
  if (asp_description_is_given(words_.get(), "erosion") && !(worn_density > 0)) {
    if (!target)
      throw Error("the depth of erosion needs the density of the wall: by 'materials', or 'density "
                  "RHO' behind 'erosion'");
    worn_density = asp_material_get(target, "density");
  }
}

/* Words that do not fit the case. In two dimensions OpenFOAM takes away the velocity out of the
 * plane, and energy with it; in a wedge it keeps the parcels in the plane in spite of it. */
void PatchWall::check(const Cloud &cloud) const {
  const asp_description *words = words_.get();
  const std::string surface = asp_description_word(words, "surface");
  asp_error wrong;
  if (asp_description_check_heat(words, cloud.has_temperature, &wrong))
    throw Error(wrong.text);
  if (asp_description_needs_sizes(words) && !(cloud.d_least > 0 && cloud.d_most >= cloud.d_least))
    throw Error("a measured wall needs the diameters of the parcels: dMin, which must be more than "
                "0, and dMax, which must be dMin or more");
  if (has_flow && cloud.is_steady)
    throw Error("a cloud in steady state has no time in which 'remove' could take deposits away");
  const asp_lay_kind lay = asp_description_lay(words).kind;
  if (lay == ASP_LAY_ANGLE)
    throw Error("the lay is an angle, which counts on cylinders only; it must be a vector");
  const bool in_plane = strcmp(asp_description_word(words, "tilt"), "plane") == 0;
  if (cloud.is_flat && surface != "smooth" &&
      (!in_plane || surface == "map" || lay != ASP_LAY_NONE))
    throw Error("this case has two dimensions (empty or wedge patches), and the wall tilts out of "
                "their plane; the spread "
                "must be 'plane', as in 'spread visible plane', without map and lay");
}

asp_key PatchWall::key_of(const Parcel &parcel) const {
  asp_key key = parcel.key;
  key.seed = asp_wall_seed(wall_.get());
  key.wall = key_;
  return key;
}

Hit PatchWall::hit(const Parcel &parcel, bool with_row) {
  typedef LedgerColumn L;
  const asp_particle &sphere = parcel.sphere;
  const asp_key key = key_of(parcel);
  Hit hit = {};
  asp_error wrong;
  if (asp_wall_impact(wall_.get(), &sphere, parcel.v1, parcel.n, &key, &hit) &&
      asp_wall_sticking(wall_.get(), sphere.temperature, NULL, &wrong))
    throw Error(wrong.text);
  hit.mass = parcel.number * sphere.density * ASP_SPHERE_VOLUME(sphere.d_p);
  hit.eroded_mass = hit.mass * hit.eroded;
  for (int k = 0; k < 3; k++) {
    hit.energy += hit.mass / 2 * parcel.v1[k] * parcel.v1[k];
    hit.impulse[k] = hit.mass * (parcel.v1[k] - hit.v2[k]);
  }
  if (!with_row)
    return hit;
  LedgerRow row = impact_row(parcel.v1, parcel.n, hit);
  row[L::TAG] = static_cast<double>(key.tag);
  row[L::IMPACT] = key.impact;
  row[L::TIME] = parcel.time;
  row[L::MESH] = parcel.patch + 1;
  row[L::D_P] = sphere.d_p;
  row[L::OUTCOME] = hit.outcome == ASP_REBOUND ? 0 : deletes ? 2 : 1;
  row[L::STEP] = parcel.step;
  row[L::MASS] = hit.mass;
  row[L::ERODED_MASS] = hit.eroded_mass;
  row[L::TEMPERATURE] = sphere.temperature > 0 ? sphere.temperature : temperature_;
  std::copy_n(parcel.x, 3, &row[L::X]);
  std::copy_n(hit.impulse, 3, &row[L::IMPULSE_X]);
  rows.push_back(row);
  return hit;
}

/* A parcel has no place for what has happened to it, and none is needed: its adhesion is its own,
 * and the exponential number that ends it can be drawn anew in each step. */
bool PatchWall::removes(const Parcel &parcel, double dt) const {
  asp_particle sphere = parcel.sphere;
  if (asp_description_is_given(words_.get(), "u_tau"))
    sphere.gas = ASP_GAS_NONE;
  const asp_key key = key_of(parcel);
  const asp_removal removal = asp_wall_removal(wall_.get(), &sphere, &key);
  return removal.rate * dt > removal.most;
}

std::string PatchWall::heading() const {
  return description_text(words_.get());
}

std::string PatchWall::notes(const Cloud &cloud) {
  asp_particle largest = asp_particle();
  largest.d_p = cloud.d_most;
  largest.density = cloud.density;
  largest.pair = asp_wall_pair(wall_.get());
  asp_check_input input = asp_check_input();
  input.words = words_.get();
  input.wall = wall_.get();
  input.d_least = cloud.d_least;
  input.largest = &largest;
  for (int i = 0; i < 2; i++)
    input.material[i] = asp_description_material(words_.get(), i);
  std::string all;
  char doubt[480];
  for (int i = 0; asp_warning(&input, i, doubt, sizeof doubt); i++)
    if (*doubt && said_.insert(doubt).second)
      all += std::string("\n    warning: ") + doubt;
  return all;
}
