/* Doubts about bodies; see body_checks.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/body_checks.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"
#include "dem/step/body_motion.h"
#include "dem/text.h"

using namespace asperity;

/* A free body whose moments of inertia have the ratio r, and which turns by the angle a in a step,
 * gains about GAIN (r - 1) a^4 of its energy in that step: 0.4 to 2.6 times that for a triangle, a
 * disc and rods of 2 to 10 spheres. A gain of MOST in STEPS steps is too much. */
static const double GAIN = 0.01, MOST = 0.01, STEPS = 1e5;

std::string asperity::turn_doubt(const Bodies &bodies, const std::string &remedy, MPI_Comm world) {
  double mine = 0, gain;
  for (const Body &body : bodies.all) {
    double omega[3];
    const double *moments = body.inertia, least = *std::min_element(moments, moments + 3);
    spin_of(body, omega);
    const double angle = aspi_length(omega) * bodies.dt;
    if (least > 0)
      mine = std::max(mine, GAIN * (*std::max_element(moments, moments + 3) / least - 1) *
                                pow(angle, 4) * STEPS);
  }
  MPI_Allreduce(&mine, &gain, 1, MPI_DOUBLE, MPI_MAX, world);
  if (remedy.empty() || !(gain > MOST))
    return "";
  return text("bodies turn so far in a step that the engine's rotation adds more than %g %% to the "
              "energy of their turning in %g steps; use ",
              100 * MOST, STEPS) +
         remedy + text(" by a factor of %.2g", pow(gain / MOST, 0.25));
}

std::string asperity::count_doubt(const Bodies &bodies, size_t saved, MPI_Comm world) {
  long long mine = static_cast<long long>(bodies.all.size()), now;
  MPI_Allreduce(&mine, &now, 1, MPI_LONG_LONG, MPI_SUM, world);
  if (now >= static_cast<long long>(saved))
    return "";
  return text(
      "there are %lld bodies of the %zu in the restart file; the engine has lost the others "
      "as it read them",
      now, saved);
}
