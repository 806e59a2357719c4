/* The columns of the ledger of impacts in order, for writer, readers, and the table on the fix
 * page: COLUMN(ID, name in files, type, meaning). Type: i for whole numbers, f for floating point.
 * C and C++.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#define LEDGER_COLUMNS(COLUMN)                                                                     \
  COLUMN(TAG, "tag", "i", "tag of the particle")                                                   \
  COLUMN(IMPACT, "impact", "i", "number of its impact on this wall, from 1")                       \
  COLUMN(TIME, "time", "f", "time of contact")                                                     \
  COLUMN(MESH, "mesh", "i", "mesh, from 1; 0 for a primitive wall")                                \
  COLUMN(TRIANGLE, "triangle", "i",                                                                \
         "triangle id, on an edge the lowest of those that meet; 0 for a primitive wall")          \
  COLUMN(X, "x", "f", "x of the center at contact")                                                \
  COLUMN(Y, "y", "f", "y of the center at contact")                                                \
  COLUMN(Z, "z", "f", "z of the center at contact")                                                \
  COLUMN(D_P, "d_p", "f", "diameter")                                                              \
  COLUMN(V1, "v1", "f", "speed before the impact, relative to the wall")                           \
  COLUMN(ALPHA1, "alpha1_deg", "f", "impact angle, 0 to 90 degrees")                               \
  COLUMN(DELTA_ALPHA, "delta_alpha_deg", "f", "tilt of the first hit")                             \
  COLUMN(TILT_OUT, "tilt_out_deg", "f",                                                            \
         "out-of-plane tilt of the first hit, positive along n x t")                               \
  COLUMN(HITS, "hits", "i", "number of faces hit")                                                 \
  COLUMN(V2, "v2", "f", "speed after the impact, in space, relative to the wall")                  \
  COLUMN(ALPHA2, "alpha2_deg", "f", "rebound angle in the plane of incidence, 0 to 180 degrees")   \
  COLUMN(COR_N, "cor_n", "f",                                                                      \
         "CoR_N about the mean wall; empty for a deposit and where v1 has no normal part")         \
  COLUMN(COR_T, "cor_t", "f", "CoR_T, signed; empty for a deposit and above 89.99 degrees")        \
  COLUMN(OUTCOME, "outcome", "i", "0 rebound, 1 deposited, 2 deleted")

/* Further columns of a ledger with `columns full`. */
#define LEDGER_MORE_COLUMNS(COLUMN)                                                                \
  COLUMN(MASS, "mass", "f", "mass of the particle")                                                \
  COLUMN(NX, "nx", "f", "outward normal of the mean wall, x")                                      \
  COLUMN(NY, "ny", "f", "the same, y")                                                             \
  COLUMN(NZ, "nz", "f", "the same, z")                                                             \
  COLUMN(V1X, "v1x", "f", "velocity before the impact, relative to the wall, x")                   \
  COLUMN(V1Y, "v1y", "f", "the same, y")                                                           \
  COLUMN(V1Z, "v1z", "f", "the same, z")                                                           \
  COLUMN(V2X, "v2x", "f", "velocity after the impact, relative to the wall, x")                    \
  COLUMN(V2Y, "v2y", "f", "the same, y")                                                           \
  COLUMN(V2Z, "v2z", "f", "the same, z")                                                           \
  COLUMN(OMEGA1X, "omega1x", "f", "angular velocity before the impact, x")                         \
  COLUMN(OMEGA1Y, "omega1y", "f", "the same, y")                                                   \
  COLUMN(OMEGA1Z, "omega1z", "f", "the same, z")                                                   \
  COLUMN(OMEGA2X, "omega2x", "f", "angular velocity after the impact, x")                          \
  COLUMN(OMEGA2Y, "omega2y", "f", "the same, y")                                                   \
  COLUMN(OMEGA2Z, "omega2z", "f", "the same, z")                                                   \
  COLUMN(IMPULSE_X, "impulse_x", "f", "impulse on the wall, x")                                    \
  COLUMN(IMPULSE_Y, "impulse_y", "f", "the same, y")                                               \
  COLUMN(IMPULSE_Z, "impulse_z", "f", "the same, z")                                               \
  COLUMN(ERODED_MASS, "eroded_mass", "f", "mass that the impact wears off the wall")               \
  COLUMN(BODY, "body", "i", "number of the body that the particle is part of, from 1; 0: none")    \
  COLUMN(LEVER_X, "lever_x", "f", "from the body's center of mass to the particle's center, x")    \
  COLUMN(LEVER_Y, "lever_y", "f", "the same, y")                                                   \
  COLUMN(LEVER_Z, "lever_z", "f", "the same, z")                                                   \
  COLUMN(TEMPERATURE, "temperature", "f", "temperature of the particle, K; 0: unknown")

/* Places in a row, from 0: LEDGER_TAG, ... */
#define LEDGER_PLACE(ID, name, type, text) LEDGER_##ID,
enum {
  LEDGER_COLUMNS(LEDGER_PLACE) LEDGER_N_COLUMNS,
  LEDGER_LAST = LEDGER_N_COLUMNS - 1,
  LEDGER_MORE_COLUMNS(LEDGER_PLACE) LEDGER_N_FULL
};
#undef LEDGER_PLACE
