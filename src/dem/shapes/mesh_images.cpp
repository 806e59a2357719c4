/* The images of a mesh in a periodic box; see mesh.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/shapes/mesh.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"
#include "dem/error.h"

using namespace asperity;

namespace {

/* A path may be this many periods long, and a piece of it may come near this many images. */
const double PERIODS_MOST = 1e6, IMAGES_MOST = 1e4;

/* An arc of this angle (rad, up to a half turn) is off its chord by less than the product with both
 * lengths. */
const double SAGITTA = 0.25;

[[noreturn]] void refuse() {
  throw Error("a particle or a mesh moves through too many periodic boxes in one step; shorten the "
              "time step");
}

} // namespace

bool MeshShape::set_images(const Box &box) {
  const bool changed = !std::equal(period_, period_ + 3, box.period);
  aspi_copy(box.period, period_);
  swept_ = swept();
  return changed;
}

/* The box around the mesh throughout the step. */
Bounds MeshShape::swept() const {
  const Bounds box = whole();
  if (motion_.in_world() || box.lo[0] > box.hi[0])
    return box;
  Bounds swept = Bounds::none();
  double longest = 0;
  const Frame begin = motion_.frame_at(0);
  for (int corner = 0; corner < 8; corner++) {
    double x[3], from[3], to[3], chord[3];
    for (int d = 0; d < 3; d++)
      x[d] = corner >> d & 1 ? box.hi[d] : box.lo[d];
    begin.to_world(x, from);
    motion_.end().to_world(x, to);
    swept.include(from);
    swept.include(to);
    aspi_subtract(to, from, chord);
    longest = std::max(longest, aspi_length(chord));
  }
  swept.widen(SAGITTA * aspi_length(motion_.screw().angular) * longest);
  return swept;
}

/* The time in which a path is no longer than a period. */
double MeshShape::period_of(const Path &path) const {
  double time = HUGE_VAL;
  for (int d = 0; d < 3; d++)
    if (period_[d] > 0 && fabs(path.v[d]) > 0)
      time = std::min(time, period_[d] / fabs(path.v[d]));
  if (!(path.left < PERIODS_MOST * time))
    refuse();
  return time;
}

/* Where a sphere comes between two times of its path. A turning mesh sees the straight path bent.
 */
Bounds MeshShape::around(const Path &path, double from, double to, double radius) const {
  const double bent = aspi_length(motion_.screw().angular) * aspi_length(path.v) * path.left;
  return Bounds::of_path(path.x, path.v, from, to, 1.001 * radius + SAGITTA * bent);
}

const std::vector<MeshShape::Shift> MeshShape::ITSELF(1, MeshShape::Shift{{0, 0, 0}});

/* The images whose boxes meet a region. Valid up to the next call. */
const std::vector<MeshShape::Shift> &MeshShape::images(const Bounds &region) const {
  shifts_.assign(1, Shift{{0, 0, 0}});
  for (int d = 0; d < 3; d++) {
    if (!(period_[d] > 0))
      continue;
    const double first = ceil((region.lo[d] - swept_.hi[d]) / period_[d]);
    const double number = floor((region.hi[d] - swept_.lo[d]) / period_[d]) - first + 1;
    const size_t count = shifts_.size();
    if (!(static_cast<double>(count) * number <= IMAGES_MOST))
      refuse();
    shifts_.resize(count * static_cast<size_t>(std::max(0.0, number)));
    for (size_t k = shifts_.size(); k-- > 0;) {
      shifts_[k] = shifts_[k % count];
      shifts_[k].by[d] = (first + static_cast<double>(k / count)) * period_[d];
    }
    if (shifts_.empty())
      break;
  }
  return shifts_;
}

/* Images the sphere may meet. Shortens `steps` so that sphere and mesh move less than one period; 0
 * if one step is already longer. */
const std::vector<MeshShape::Shift> &MeshShape::images_ahead(const Course &course,
                                                             double &steps) const {
  for (int d = 0; d < 3; d++)
    if (period_[d] > 0)
      steps = std::min(steps, period_[d] / (fabs(course.v[d]) + course.widen));
  steps = steps < 1 ? 0 : steps;
  return images(Bounds::of_path(course.x, course.v, 0, steps, course.reach + steps * course.widen));
}
