/* Results of contacts at a wall: its counters, force and torque, the sums of its shapes and
 * triangles, and the rows of its ledger. All loads come through Wall::add().
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/wall.h"

#include "contact/vector.h"
#include "dem/ledger_row.h"

using namespace asperity;

ContactLoad::ContactLoad(const Spheres &s, int i, int of, const double center[3],
                         const double normal[3], const double impulse_per_mass[3],
                         const double v1[3])
    : piece(of), type(s.type[i]), mask(s.mask[i]), couple{0, 0, 0}, dissipated(0), eroded(0) {
  aspi_copy(normal, n);
  aspi_add_scaled(center, -s.radius[i], normal, point);
  aspi_copy(impulse_per_mass, impulse);
  aspi_scale(-s.mass[i], impulse);
  aspi_copy(v1, v_before);
}

/* The moment of inertia of a sphere. */
static double inertia(const Spheres &s, int i) {
  return 0.4 * s.mass[i] * s.radius[i] * s.radius[i];
}

void ContactLoad::set_couple(const Spheres &s, int i, const double center[3],
                             const double turn[3]) {
  double arm[3];
  aspi_subtract(center, point, arm);
  aspi_cross(arm, impulse, couple);
  aspi_add_scaled(couple, -inertia(s, i), turn, couple);
}

/* Adds to `count` sums of a piece from `first` on. */
void Wall::Member::add(int piece, Sum first, int count, const double values[]) {
  for (int k = 0; k < count; k++)
    totals[first + k + (first + k > SUM_IMPACTS)] += values[k];
  double *of = sums.size() > 0 ? sums.data() + static_cast<size_t>(piece) * N_SUMS + first : NULL;
  for (int k = 0; of && k < count; k++)
    of[k] += values[k];
}

Wall::Held::Held(const Spheres &s, int i) : spin{0, 0, 0} {
  aspi_copy(s.v + 3 * static_cast<size_t>(i), v);
  if (s.omega)
    aspi_copy(s.omega + 3 * static_cast<size_t>(i), spin);
}

void Wall::add(size_t shape, const ContactLoad &load) {
  Member &member = shapes_[shape];
  double arm[3], torque[3], along[3];
  aspi_subtract(load.point, torque_about_, arm);
  aspi_cross(arm, load.impulse, torque);
  aspi_add_scaled(torque, 1, load.couple, torque);
  for (int d = 0; d < 3; d++) {
    counters_[FORCE + d] += load.impulse[d];
    counters_[TORQUE + d] += torque[d];
    counters_[IMPULSE + d] += load.impulse[d];
    counters_[ANGULAR_IMPULSE + d] += torque[d];
  }
  if (aspi_dot(load.n, load.n) > 0) {
    const double normal = -aspi_dot(load.impulse, load.n);
    aspi_add_scaled(load.impulse, normal, load.n, along);
    const double values[] = {normal, aspi_length(along), load.dissipated, load.eroded};
    member.add(load.piece, SUM_NORMAL, 4, values);
    counters_[DISSIPATED] += load.dissipated;
    counters_[ERODED] += load.eroded;
  }
  if (member.measures)
    member.shape->take(load);
}

/* Load that holds a stuck particle: it had the velocity and the spin of `before`, and now has the
 * velocity of its wall. */
void Wall::add_held(const Spheres &s, int i, const Held &before) {
  const StuckPlace &stuck = place(i).stuck;
  const double none[3] = {0, 0, 0};
  const size_t at = 3 * static_cast<size_t>(i);
  double p[3];
  aspi_subtract(s.v + at, before.v, p);
  if (!(aspi_dot(p, p) + aspi_dot(before.spin, before.spin) > 0) || !(stuck.shape >= 1))
    return;
  ContactLoad load(s, i, static_cast<int>(stuck.piece), s.x + at, none, p, none);
  aspi_copy(before.spin, load.couple);
  aspi_scale(inertia(s, i), load.couple);
  add(static_cast<size_t>(stuck.shape) - 1, load);
}

void Wall::count(const Spheres &s, int i, const Event &event) {
  const asp_impact &impact = event.impact;
  const Contact &contact = event.contact;
  const bool stuck = impact.outcome == ASP_DEPOSIT;
  const double mass = s.mass[i], stuck_mass = stuck ? mass : 0;
  const double energy = 0.5 * mass * aspi_dot(event.v1, event.v1);
  counters_[N_IMPACTS]++;
  counters_[N_DEPOSITS] += stuck;
  counters_[DEPOSITED_MASS] += stuck_mass;
  counters_[N_LATER_HITS] += impact.hits - 1;
  counters_[N_CAPPED] += impact.capped;
  counters_[N_GUARDED] += contact.overlapped;
  Member &member = shapes_[event.shape];
  member.totals[SHAPE_DEPOSITS] += stuck;
  const double values[] = {1, stuck_mass, energy};
  member.add(contact.piece, SUM_IMPACTS, 3, values);
  double p[3];
  aspi_subtract(impact.v2, event.v1, p);
  ContactLoad load(s, i, contact.piece, contact.x, contact.n, p, event.v1);
  /* The faces that were hit are tilted, and a law may leave the spin alone: the wall gets what the
   * particle has lost. */
  double turn[3];
  aspi_subtract(impact.omega, event.omega1, turn);
  load.set_couple(s, i, contact.x, turn);
  load.dissipated =
      energy - 0.5 * mass * aspi_dot(impact.v2, impact.v2) +
      0.5 * inertia(s, i) *
          (aspi_dot(event.omega1, event.omega1) - aspi_dot(impact.omega, impact.omega));
  load.eroded = mass * impact.eroded;
  add(event.shape, load);
  if (ledger_)
    record(s, i, event, load);
}

void Wall::record(const Spheres &s, int i, const Event &event, const ContactLoad &load) {
  typedef Ledger L;
  const bool stuck = event.impact.outcome == ASP_DEPOSIT;
  L::Row row = impact_row(event.v1, load.n, event.impact);
  row[L::TAG] = static_cast<double>(event.key.tag);
  row[L::IMPACT] = event.key.impact;
  row[L::TIME] = event.time;
  row[L::MESH] = shapes_[event.shape].sums.size() > 0 ? static_cast<double>(event.shape) + 1 : 0;
  row[L::TRIANGLE] = event.contact.piece;
  aspi_copy(event.contact.x, &row[L::X]);
  row[L::D_P] = 2 * s.radius[i];
  row[L::OUTCOME] = !stuck ? 0 : model_.deposit() == Model::DELETE ? 2 : 1;
  row[L::STEP] = static_cast<double>(s.step);
  row[L::MASS] = s.mass[i];
  aspi_copy(event.omega1, &row[L::OMEGA1X]);
  aspi_copy(load.impulse, &row[L::IMPULSE_X]);
  row[L::ERODED_MASS] = load.eroded;
  ledger_->add(row);
}
