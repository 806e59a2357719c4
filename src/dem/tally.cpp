/* What a wall feels of its contacts: counters, maps, rows of the ledger, and the impulses that
 * meshes measure.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/flight.h"

#include "contact/vector.h"

using namespace asperity;

static const double DEGREES = 180 / ASP_PI;

/* An impulse that a particle has given to a shape that measures. v1: relative to the wall. */
void Wall::press(const Spheres &s, int i, size_t shape, int piece, const double n[3],
                 const double impulse[3], const double v1[3]) {
  if (!shapes_[shape].measures)
    return;
  Blow blow;
  blow.piece = piece;
  blow.type = s.type[i];
  blow.mask = s.mask[i];
  vector_copy(impulse, blow.impulse);
  vector_add_scaled(s.x + 3 * static_cast<size_t>(i), -s.radius[i], n, blow.point);
  vector_copy(v1, blow.v_before);
  shapes_[shape].shape->take(blow);
}

void Wall::count(const Flight &flight, const Event &event) {
  const bool stuck = event.impact.outcome == ASP_DEPOSIT;
  const double stuck_mass = stuck ? flight.mass : 0;
  const double energy = 0.5 * flight.mass * vector_dot(event.v1, event.v1);
  counters_[N_IMPACTS]++;
  counters_[N_DEPOSITS] += stuck;
  counters_[DEPOSITED_MASS] += stuck_mass;
  counters_[N_LATER_HITS] += event.impact.hits - 1;
  counters_[N_CAPPED] += event.impact.capped;
  counters_[N_GUARDED] += event.contact.guarded;
  Member &member = shapes_[event.shape];
  member.totals[SHAPE_IMPACTS]++;
  member.totals[SHAPE_DEPOSITS] += stuck;
  member.totals[SHAPE_MASS] += stuck_mass;
  member.totals[SHAPE_ENERGY] += energy;
  if (member.sums.size() > 0) {
    double *sums = member.sums.data() + static_cast<size_t>(event.contact.piece) * N_SUMS;
    sums[PIECE_IMPACTS]++;
    sums[PIECE_MASS] += stuck_mass;
    sums[PIECE_ENERGY] += energy;
  }
  double impulse[3];
  vector_subtract(event.v1, event.impact.v2, impulse);
  vector_scale(flight.mass, impulse);
  press(flight.spheres, flight.i, event.shape, event.contact.piece, event.contact.n, impulse,
        event.v1);
  if (ledger_)
    record(flight, event);
}

void Wall::record(const Flight &flight, const Event &event) {
  typedef Ledger L;
  const asp_coefficients c = asp_impact_coefficients(event.v1, event.contact.n, &event.impact);
  L::Row row;
  row[L::TAG] = static_cast<double>(event.key.tag);
  row[L::IMPACT] = event.key.impact;
  row[L::TIME] = event.time;
  row[L::MESH] = shapes_[event.shape].sums.size() > 0 ? static_cast<double>(event.shape) + 1 : 0;
  row[L::TRIANGLE] = event.contact.piece;
  for (int d = 0; d < 3; d++)
    row[L::X + d] = event.contact.x[d];
  row[L::D_P] = 2 * flight.radius;
  row[L::V1] = c.v1;
  row[L::ALPHA1] = c.alpha1 * DEGREES;
  row[L::DELTA_ALPHA] = event.impact.delta_alpha * DEGREES;
  row[L::TILT_OUT] = event.impact.tilt_out * DEGREES;
  row[L::HITS] = event.impact.hits;
  row[L::V2] = c.v2;
  row[L::ALPHA2] = c.alpha2 * DEGREES;
  row[L::COR_N] = c.cor_n;
  row[L::COR_T] = c.cor_t;
  row[L::OUTCOME] = event.impact.outcome == ASP_REBOUND ? 0
                    : model_.deposit() == Model::DELETE ? 2
                                                        : 1;
  row[L::STEP] = static_cast<double>(flight.spheres.step);
  row[L::COR_T_DEFINED] = c.cor_t_defined;
  ledger_->add(row);
}
