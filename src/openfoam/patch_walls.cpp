/* The rough walls of a cloud; see patch_walls.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "openfoam/patch_walls.h"

#include <fenv.h>
#include <algorithm>
#include <sstream>

#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "Time.H"
#include "dem/error.h"
#include "dem/books/ledger_file.h"
#include "dem/text.h"
#include "openfoam/compatibility.h"
#include "processorPolyPatch.H"
#include "wallPolyPatch.H"

using namespace asperity;
using namespace Foam;

/* Parcels over this share of the mesh's least extent are in doubt. */
static const double LARGE = 0.1;

/* Ends the run. */
static void fail(const dictionary &dict, const std::string &what) {
  FatalIOErrorInFunction(dict) << what.c_str() << exit(FatalIOError);
}

/* An entry's value, or this one. */
template <class Value>
static Value value_of(const dictionary &dict, const word &name, Value value) {
  dict.readIfPresent(name, value);
  return value;
}

/* Those of the whole case, which come first on each rank. */
static label count_patches(const polyBoundaryMesh &patches) {
  label n = 0;
  for (const polyPatch &patch : patches)
    n += !isA<processorPolyPatch>(patch);
  return n;
}

PatchWalls::PatchWalls(const word &name, const Gas &gas, const Cloud &cloud,
                       const subModelBase &model)
    : mesh_(gas.U.mesh()), gas_(gas), cloud_(cloud), is_large_(false),
      every_(value_of<label>(model.coeffDict(), "ledger", 0)),
      columns_(value_of<Switch>(model.coeffDict(), "fullLedger", false) ? LedgerColumn::N_FULL
                                                                        : LedgerColumn::N_COLUMNS),
      of_patch_(mesh_.boundaryMesh().size(), NULL),
      sums_(count_patches(mesh_.boundaryMesh()) * N_SUMS, Zero), sums_before_(sums_) {
  const dictionary &coeffs = model.coeffDict();
  check_entries(model.dict(), coeffs);
  cloud_.d_least = value_of<scalar>(coeffs, "dMin", 0);
  cloud_.d_most = value_of<scalar>(coeffs, "dMax", 0);
  cloud_.is_flat = mesh_.nGeometricD() < 3;
  /* OpenFOAM traps floating-point exceptions. The core compares NaN (not given) where it reads
   * and writes words; an impact raises none. */
  fenv_t traps;
  feholdexcept(&traps);
  read(name, cloud_, coeffs.subDict("walls"));
  impacts_ = field<volScalarField>(name + ":impacts", dimless);
  deposited_ = field<volScalarField>(name + ":depositedMass", dimMass);
  energy_ = field<volScalarField>(name + ":energy", dimEnergy);
  impulse_ = field<volVectorField>(name + ":impulse", dimMass * dimVelocity);
  std::istringstream sums(model.getModelProperty<string>("sums", ""));
  for (scalar &sum : sums_before_)
    sums >> sum;
  const fileName folder = mesh_.time().globalPath() / "postProcessing/lagrangian" / name;
  for (const auto &wall : walls_) {
    if (wall->worn_density > 0 && !eroded_)
      eroded_ = field<volScalarField>(name + ":erodedDepth", dimLength);
    if (every_ > 0 && Pstream::master())
      open_ledger(*wall, folder / "asperityWall" / wall->name + ".csv",
                  model.getModelProperty<string>(wall->name, ""));
  }
  fesetenv(&traps);
}

void PatchWalls::check_entries(const dictionary &models, const dictionary &coeffs) const {
  const word collisions = value_of<word>(models, "collisionModel", "none");
  if (cloud_.can_collide && collisions != "none")
    fail(models, "collisionModel is '" + collisions +
                     "', whose wall model turns parcels back before their centers reach a wall, " +
                     "so that asperityWall would never act; it must be none");
  std::vector<std::string> entries = {"walls", "dMin", "dMax", "ledger", "fullLedger"};
  for (const char *entry : ENTRIES_OF_BASE)
    entries.push_back(entry);
  std::string there_are;
  for (const std::string &entry : entries)
    there_are += " " + entry;
  for (const word &name : coeffs.toc())
    if (name == "UrMax")
      fail(coeffs,
           "entry 'UrMax' has no effect: asperityWall removes no parcel because it is slow " +
               word("on a wall that moves; it must be left out"));
    else if (!std::count(entries.begin(), entries.end(), name))
      fail(coeffs, "entry '" + name + "' is unknown; there are" + there_are);
}

/* Each wall takes the entry of its name, else the last regular expression that fits. */
void PatchWalls::read(const word &cloud, const Cloud &of, const dictionary &entries) {
  for (const entry &e : entries)
    if (!e.isStream() || e.stream().size() != 1 || !e.stream()[0].isString())
      fail(entries, "walls, entry " + e.keyword() + ": it must be one string, the words of a wall");
  for (const entry &e : entries) {
    std::string name = e.keyword();
    const std::string place = "walls, entry " + name + ": ";
    bool is_idle = true;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !isalnum(c) && c != '-'; }, '_');
    try {
      walls_.emplace_back(
          new PatchWall(name, cloud + ":" + e.keyword(), e.stream()[0].stringToken(), of));
    } catch (const Error &error) {
      fail(entries, place + error.what());
    }
    Info << "    asperityWall " << e.keyword() << ": " << walls_.back()->heading().c_str()
         << walls_.back()->notes(of).c_str() << endl;
    for (const polyPatch &patch : mesh_.boundaryMesh())
      if (isA<wallPolyPatch>(patch) && entries.found(patch.name()) &&
          &entries.lookup(patch.name()) == &e.stream()) {
        of_patch_[patch.index()] = walls_.back().get();
        is_idle = false;
      }
    if (is_idle)
      fail(entries, place + "no patch of type wall takes it");
  }
  for (const polyPatch &patch : mesh_.boundaryMesh())
    if (isA<wallPolyPatch>(patch) && !of_patch_[patch.index()])
      fail(entries, "walls has no entry for '" + patch.name() + "', a patch of type wall");
}

/* The contact is that of a parcel's center, so a large one goes into the wall. */
void PatchWalls::meet(double d_least, double d_most) {
  reduce(d_least, minOp<scalar>());
  reduce(d_most, maxOp<scalar>());
  const bool is_known = cloud_.d_most >= d_most && cloud_.d_least > 0 && cloud_.d_least <= d_least;
  if (!(d_most > 0) || is_known)
    return;
  cloud_.d_most = std::max(cloud_.d_most, d_most);
  cloud_.d_least = cloud_.d_least > 0 ? std::min(cloud_.d_least, d_least) : d_least;
  double across = GREAT;
  for (direction k = 0; k < 3; k++)
    if (mesh_.geometricD()[k] > 0)
      across = std::min(across, mesh_.bounds().span()[k]);
  if (!is_large_ && d_most > LARGE * across) {
    is_large_ = true;
    Info
        << text(
               "    asperityWall warning: there are parcels of %.4g m in diameter, and the mesh is "
               "%.4g m across; a parcel hits a wall only when its center reaches it",
               d_most, across)
               .c_str()
        << endl;
  }
  fenv_t traps;
  feholdexcept(&traps);
  for (const auto &wall : walls_) {
    const std::string notes = wall->notes(cloud_);
    if (!notes.empty())
      Info << "    asperityWall " << wall->heading().c_str() << notes.c_str() << endl;
  }
  fesetenv(&traps);
}

template <class Field>
std::unique_ptr<Field> PatchWalls::field(const word &name, const dimensionSet &units) const {
  const IOobject io(name, mesh_.time().timePath().name(), mesh_, IOobject::READ_IF_PRESENT,
                    IOobject::AUTO_WRITE);
  return std::unique_ptr<Field>(
      new Field(io, mesh_, dimensioned<typename Field::value_type>(units, Zero)));
}

/* A restart goes on behind the rows that it counts: `state` has rows, bytes and checksum. */
void PatchWalls::open_ledger(PatchWall &wall, const fileName &path, const string &state) const {
  LedgerState saved = {path, 0, 0, 0};
  long rows = 0, bytes = 0;
  sscanf(state.c_str(), "%ld %ld %u", &rows, &bytes, &saved.tail);
  saved.rows = rows;
  saved.bytes = bytes;
  mkDir(path.path());
  if (!isFile(path) || bytes == 0)
    saved.path.clear();
  try {
    wall.file.reset(new LedgerFile(path, columns_));
    Info << wall.file->open(saved, wall.heading()).c_str() << endl;
  } catch (const Error &error) {
    FatalErrorInFunction << error.what() << exit(FatalError);
  }
}

/* The friction velocity at a face: the root of nu + nu_t times the velocity's slope. */
double PatchWalls::u_tau(const Parcel &parcel) const {
  const fvPatch &patch = mesh_.boundary()[parcel.patch];
  const label face = parcel.face;
  const vector n = patch.Sf()[face] / patch.magSf()[face];
  const auto at_face = [&](const volScalarField &field) {
    return field.boundaryField()[parcel.patch][face];
  };
  const vector slip = gas_.U[patch.faceCells()[face]] - gas_.U.boundaryField()[parcel.patch][face];
  scalar nu = at_face(gas_.mu) / at_face(gas_.rho);
  const word nut = IOobject::groupName("nut", gas_.U.group());
  if (mesh_.foundObject<volScalarField>(nut))
    nu += at_face(mesh_.lookupObject<volScalarField>(nut));
  return std::sqrt(nu * patch.deltaCoeffs()[face] * mag(slip - (slip & n) * n));
}

bool PatchWalls::removes(Parcel &parcel) {
  parcel.sphere.u_tau = u_tau(parcel);
  parcel.sphere.gas = ASP_GAS_FLOWS;
  if (!of_patch_[parcel.patch]->removes(parcel, mesh_.time().deltaTValue()))
    return false;
  const double mass = parcel.number * parcel.sphere.density * ASP_SPHERE_VOLUME(parcel.sphere.d_p);
  sums_[parcel.patch * N_SUMS + REMOVED]++;
  sums_[parcel.patch * N_SUMS + REMOVED_MASS] += mass;
  deposited_->boundaryFieldRef()[parcel.patch][parcel.face] -= mass;
  return true;
}

Hit PatchWalls::hit(const Parcel &parcel) {
  const int patch = parcel.patch, face = parcel.face;
  PatchWall &wall = *of_patch_[patch];
  Hit hit;
  try {
    hit = wall.hit(parcel, every_ > 0);
  } catch (const Error &error) {
    FatalErrorInFunction << "asperityWall " << wall.name << ": " << error.what()
                         << exit(FatalError);
  }
  const bool sticks = hit.outcome == ASP_DEPOSIT;
  sums_[patch * N_SUMS + (sticks ? STICK : REBOUND)]++;
  sums_[patch * N_SUMS + (sticks ? STICK_MASS : REBOUND_MASS)] += hit.mass;
  sums_[patch * N_SUMS + ERODED_MASS] += hit.eroded_mass;
  impacts_->boundaryFieldRef()[patch][face] += parcel.number;
  deposited_->boundaryFieldRef()[patch][face] += sticks ? hit.mass : 0;
  energy_->boundaryFieldRef()[patch][face] += hit.energy;
  for (direction k = 0; k < 3; k++)
    impulse_->boundaryFieldRef()[patch][face][k] += hit.impulse[k];
  if (wall.worn_density > 0)
    eroded_->boundaryFieldRef()[patch][face] +=
        hit.eroded_mass / (wall.worn_density * mesh_.boundary()[patch].magSf()[face]);
  return hit;
}

/* The items of all ranks, one rank's behind another's, on the first one. */
template <class Item> static std::vector<Item> gather(const std::vector<Item> &mine) {
  List<List<Item>> lists(Pstream::nProcs());
  List<Item> &own = lists[Pstream::myProcNo()];
  own.setSize(static_cast<label>(mine.size()));
  std::copy(mine.begin(), mine.end(), own.begin());
  Pstream::gatherList(lists);
  std::vector<Item> all;
  for (const List<Item> &list : lists)
    all.insert(all.end(), list.begin(), list.end());
  return all;
}

/* The rows of all ranks to the file, in an order that does not depend on the number of ranks. */
void PatchWalls::flush(PatchWall &wall) const {
  PrintedRows mine;
  for (const LedgerRow &row : wall.rows)
    mine.add(row.data(), columns_, row[LedgerColumn::STEP]);
  wall.rows.clear();
  const PrintedRows all = {gather(mine.keys), gather(mine.bytes)};
  const std::string why = wall.file ? all.commit(*wall.file) : "";
  if (!why.empty())
    FatalErrorInFunction << "writing the ledger of entry " << wall.name.c_str()
                         << " failed: " << why.c_str() << exit(FatalError);
}

/* In the order of the sums. */
static const char *const COLUMNS[] = {"nRebound", "massRebound", "nStick",    "massStick",
                                      "nRemoved", "massRemoved", "massEroded"};

void PatchWalls::write_header(Ostream &table) const {
  for (const fvPatch &patch : mesh_.boundary())
    if (patch.index() < sums_.size() / N_SUMS && of_patch_[patch.index()])
      for (const char *column : COLUMNS)
        table << tab << word(patch.name() + "_" + column);
}

void PatchWalls::info(Ostream &os, Ostream &table, subModelBase &model) {
  const Time &time = mesh_.time();
  const bool ends = time.value() > time.endTime().value() - 0.5 * time.deltaTValue();
  for (const auto &wall : walls_) {
    if (every_ > 0 && (time.writeTime() || ends || time.timeIndex() % every_ == 0))
      flush(*wall);
    if (!time.writeTime() || !wall->file)
      continue;
    wall->file->sync();
    const LedgerState state = wall->file->state();
    model.setModelProperty<string>(wall->name, std::to_string(state.rows) + " " +
                                                   std::to_string(state.bytes) + " " +
                                                   std::to_string(state.tail));
  }
  scalarList sums(sums_);
  Pstream::listCombineGather(sums, plusEqOp<scalar>());
  std::ostringstream text;
  text.precision(17);
  forAll(sums, i) text << (sums[i] += sums_before_[i]) << ' ';
  for (label patch = 0; patch < sums.size() / N_SUMS; patch++) {
    const scalar *sum = &sums[patch * N_SUMS];
    if (!of_patch_[patch])
      continue;
    for (int k = 0; k < N_SUMS; k++)
      table << tab << sum[k];
    os << "    Parcel fate: patch " << mesh_.boundary()[patch].name() << " (number, mass)" << nl
       << "      - rebound                     = " << static_cast<int64_t>(sum[REBOUND]) << ", "
       << sum[REBOUND_MASS] << nl
       << "      - stick                       = " << static_cast<int64_t>(sum[STICK]) << ", "
       << sum[STICK_MASS] << nl
       << "      - removed by the flow         = " << static_cast<int64_t>(sum[REMOVED]) << ", "
       << sum[REMOVED_MASS] << nl << "      - eroded from the wall (mass) = " << sum[ERODED_MASS]
       << nl;
  }
  if (time.writeTime())
    model.setModelProperty<string>("sums", text.str());
}
