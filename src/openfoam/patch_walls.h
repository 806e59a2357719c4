/* The rough walls of a cloud: each in words, on patches of the case, with what impacts leave there:
 * fields on the patches, sums for the log, ledgers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <memory>
#include <set>
#include <vector>

#include "asperity.h"
#include "dem/books/ledger_file.h"
#include "subModelBase.H"
#include "volFields.H"

namespace asperity {

/* Properties of a cloud that the words do not state: diameters, 0 where they are not given; the
 * density of the parcels; whether they have a temperature, and can collide; whether the case has
 * two dimensions, and no time. */
struct Cloud {
  double d_least, d_most, density;
  bool has_temperature, can_collide, is_flat, is_steady;
};

/* A parcel that hits a face: it stands for `number` particles; v1 is relative to the wall, whose
 * normal n points off it; the key has tag and impact. */
struct Parcel {
  asp_particle sphere;
  asp_key key;
  double number, x[3], v1[3], n[3], time, step;
  int patch, face;
};

/* An impact, and what it counts for all particles of the parcel; energy is that before it. */
struct Hit : asp_impact {
  double mass, energy, eroded_mass, impulse[3];
};

/* One entry of `walls`. */
class PatchWall {
public:
  /* Throws an Error. `name` is that of its ledger. */
  PatchWall(const std::string &name, const std::string &key, const std::string &words,
            const Cloud &cloud);

  /* Adds a row to `rows`, if it is asked for. */
  Hit hit(const Parcel &parcel, bool with_row);
  /* True if the flow takes a deposit away within this time. */
  bool removes(const Parcel &parcel, double dt) const;
  std::string heading() const;           /* the canonical text */
  std::string notes(const Cloud &cloud); /* doubts that are new, a line each */

  const std::string name;
  std::vector<LedgerRow> rows;      /* that the file does not have yet */
  std::unique_ptr<LedgerFile> file; /* on the first rank */
  bool deletes;                     /* what sticks */
  bool has_flow;                    /* which takes deposits away */
  double worn_density;              /* of the wall; 0: it is not worn */

private:
  void check(const Cloud &cloud) const;
  asp_key key_of(const Parcel &parcel) const;

  std::unique_ptr<asp_description, void (*)(asp_description *)> words_;
  std::unique_ptr<asp_wall, void (*)(asp_wall *)> wall_;
  uint32_t key_;
  double temperature_;         /* of parcels that have none; 0: unknown */
  std::set<std::string> said_; /* doubts */
};

/* The gas that carries the parcels. */
struct Gas {
  const Foam::volVectorField &U;
  const Foam::volScalarField &rho, &mu;
};

class PatchWalls {
public:
  /* `model` has the entries, and what a restart needs. A fault ends the run and names its entry. */
  PatchWalls(const Foam::word &name, const Gas &gas, const Cloud &cloud,
             const Foam::subModelBase &model);

  /* The wall of a patch; NULL: the patch is none. */
  const PatchWall *at(int patch) const {
    return of_patch_[patch];
  }
  Hit hit(const Parcel &parcel);
  /* True if the flow takes a deposit away in this time step; it is counted. */
  bool removes(Parcel &parcel);

  /* On all ranks: warns of what is odd about parcels of these diameters, those of this rank, once;
   * d_most 0: it has none. */
  void meet(double d_least, double d_most);

  /* At the end of a time step, on all ranks: sums to the log and to a line of `table`, rows to the
   * ledgers, and at the time of writing what a restart needs. */
  void info(Foam::Ostream &os, Foam::Ostream &table, Foam::subModelBase &model);
  void write_header(Foam::Ostream &table) const;

private:
  enum { REBOUND, REBOUND_MASS, STICK, STICK_MASS, REMOVED, REMOVED_MASS, ERODED_MASS, N_SUMS };

  void check_entries(const Foam::dictionary &models, const Foam::dictionary &coeffs) const;
  void read(const Foam::word &name, const Cloud &cloud, const Foam::dictionary &entries);
  template <class Field>
  std::unique_ptr<Field> field(const Foam::word &name, const Foam::dimensionSet &units) const;
  void open_ledger(PatchWall &wall, const Foam::fileName &path, const Foam::string &state) const;
  double u_tau(const Parcel &parcel) const;
  void flush(PatchWall &wall) const;

  const Foam::fvMesh &mesh_;
  const Gas gas_;
  Cloud cloud_;             /* with the diameters that there have been */
  bool is_large_;           /* for the mesh: was said */
  const Foam::label every_; /* time steps between writes of the ledgers; 0: there are none */
  const int columns_;
  std::vector<std::unique_ptr<PatchWall>> walls_;
  std::vector<PatchWall *> of_patch_;
  Foam::scalarList sums_, sums_before_; /* of this rank, in this run; of all, before a restart */
  std::unique_ptr<Foam::volScalarField> impacts_, deposited_, energy_;
  std::unique_ptr<Foam::volScalarField> eroded_; /* NULL: no wall is worn */
  std::unique_ptr<Foam::volVectorField> impulse_;
};

} // namespace asperity
