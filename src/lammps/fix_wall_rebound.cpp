/* fix wall/rebound; see fix_wall_rebound.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fix_wall_rebound.h"

#include <stdio.h>
#include <string.h>
#include <algorithm>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "modify.h"
#include "output.h"
#include "update.h"
#include "dem/error.h"
#include "dem/primitive.h"
#include "dem/text.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using asperity::Ledger;
using asperity::Model;
using asperity::text;
using asperity::Wall;
using asperity::Words;

/* How many numbers an atom takes along. */
static const int ROW = Wall::N_STATE + Wall::N_PLACE;

/* ---- making -----------------------------------------------------------------------------------
 */

FixWallRebound::FixWallRebound(LAMMPS *lammps, int narg, char **arg)
    : Fix(lammps, narg, arg), engine_(lammps, this), wall_(engine_), mesh_(NULL), region_(NULL),
      last_step_(update->ntimestep), steps_(false),
      from_restart_(modify->nfix_restart_global > 0 || modify->nfix_restart_peratom > 0),
      restarted_(false), stuck_(0) {
  check_units();
  check_particles();
  check_box();
  try {
    std::string geometry;
    Words words(narg - 3, arg + 3);
    read_geometry(words, geometry);
    Keywords own(this);
    wall_.parse(words, geometry, &own);
    if (engine_.units() == "lj" && wall_.model().needs_materials())
      throw asperity::Error("units are 'lj', in which materials have no constants; units must be " +
                            engine_.known_units() +
                            ", or the law one without materials, such as rebound constant");
  } catch (const std::exception &wrong) {
    fail(asperity::told(wrong));
  }
  scalar_flag = vector_flag = array_flag = 1;
  size_vector = Wall::N_COUNTERS;
  size_array_rows = static_cast<int>(wall_.shapes());
  size_array_cols = Wall::N_TOTALS;
  global_freq = 1;
  extscalar = extvector = extarray = 1;
  restart_global = restart_peratom = create_attribute = 1;
  wd_header = 1;
  maxexchange = ROW;
  nevery = 1;
  force_reneighbor = wall_.model().deposit() == Model::DELETE;
  next_reneighbor = -1;
  if (Ledger *ledger = wall_.ledger()) {
    local_flag = 1;
    local_freq = static_cast<int>(ledger->every());
    size_local_rows = 0;
    size_local_cols = ledger->columns();
  }
  FixWallRebound::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixWallRebound::~FixWallRebound() {
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

void FixWallRebound::fail(const std::string &what) const {
  error->all(FLERR, "Fix wall/rebound (id " + engine_.id() + "): " + what);
}

void FixWallRebound::read_geometry(Words &words, std::string &geometry) {
  const std::string primitives = "xplane yplane zplane xcylinder ycylinder zcylinder";
  const std::string shapes = primitives + " region stl";
  if (words.done())
    throw asperity::Error("the wall is missing; it must be one of " + shapes);
  if (words.take("region")) {
    const std::string name = words.word("the ID of a region");
    region_ = new RegionShape(lmp, name);
    std::unique_ptr<asperity::Shape> shape(region_);
    const int type = read_type(words);
    geometry = region_->description() + text(" type %d", type);
    wall_.add_shape(std::move(shape), type, 0, name); /* by name, so that its motion is saved */
  } else if (words.take("stl")) {
    int type;
    std::unique_ptr<asperity::DrivenMesh> mesh =
        asperity::read_driven_mesh(world, words, atom->ntypes, type, geometry);
    mesh_ = mesh.get();
    wall_.add_shape(std::move(mesh), type, mesh_->pieces(), "stl");
    report_mesh();
  } else if (words.is_one_of(primitives)) {
    std::unique_ptr<asperity::Shape> shape = asperity::read_primitive(words, geometry);
    const int type = read_type(words);
    geometry += text(" type %d", type);
    wall_.add_shape(std::move(shape), type, 0, "");
  } else
    throw asperity::Error("the wall is '" + words.word("the wall") + "'; it must be one of " +
                          shapes);
}

void FixWallRebound::report_mesh() const {
  asperity::Bounds box;
  for (int d = 0; d < 3; d++) {
    box.lo[d] = domain->triclinic ? domain->boxlo_bound[d] : domain->boxlo[d];
    box.hi[d] = domain->triclinic ? domain->boxhi_bound[d] : domain->boxhi[d];
  }
  engine_.print("fix " + engine_.id() + " wall/rebound: " + mesh_->describe());
  const std::string misfit = mesh_->misfit(box, engine_.box().period);
  if (!misfit.empty())
    engine_.warn(misfit);
}

/* The last type where the script names none. */
int FixWallRebound::read_type(Words &words) const {
  if (!words.take("type"))
    return atom->ntypes;
  return static_cast<int>(words.whole("the wall's type", 1, atom->ntypes));
}

std::string FixWallRebound::Keywords::keywords() const {
  return fix_->mesh_ ? "map" : "";
}

bool FixWallRebound::Keywords::parse(Words &words) {
  if (!fix_->mesh_ || !words.take("map"))
    return false;
  fix_->map_.parse(words);
  return true;
}

int FixWallRebound::setmask() {
  return POST_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | POST_NEIGHBOR | END_OF_STEP | POST_RUN;
}

/* ---- checks -----------------------------------------------------------------------------------
 */

void FixWallRebound::check_particles() const {
  if (!atom->radius_flag || !atom->rmass_flag || atom->ellipsoid_flag || atom->line_flag ||
      atom->tri_flag || atom->body_flag)
    fail(text("the atom style is '%s'; particles must be spheres with a radius and a density, by "
              "'atom_style sphere'",
              atom->atom_style));
  if (!atom->tag_enable)
    fail("particles have no tags, which the draws depend on; use 'atom_modify id yes'");
  if (lmp->kokkos)
    fail("the package KOKKOS is on; it keeps particles where this fix cannot reach them, so it "
         "must be off");
}

void FixWallRebound::check_units() const {
  const std::string units = engine_.units(), known = engine_.known_units();
  if (units != "si" && units != "cgs" && units != "micro" && units != "nano" && units != "lj")
    fail("units are '" + units + "'; they must be " + known + ", or lj without materials");
}

void FixWallRebound::check_box() const {
  if (domain->triclinic && (domain->xperiodic || domain->yperiodic || domain->zperiodic))
    fail("the box is triclinic and periodic; a periodic box must be orthogonal");
}

/* True if a particle of any rank is in both groups. */
bool FixWallRebound::shares_particles(const Fix *fix) const {
  int mine = 0, any;
  for (int i = 0; i < atom->nlocal; i++)
    mine |= (atom->mask[i] & fix->groupbit) && (atom->mask[i] & groupbit);
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  return any;
}

/* Fixes that put particles where they want would carry them through the wall. They may get
 * particles during a run, so each neighbor build looks; all ranks call. */
void FixWallRebound::check_movers() const {
  if (modify->check_rigid_group_overlap(groupbit))
    fail("particles that are tied to bodies (fix rigid) cannot rebound one by one");
  for (int i = 0; i < modify->nfix; i++) {
    const Fix *fix = modify->fix[i];
    const std::string name = text("fix %s (id %s)", fix->style, fix->id);
    if (strcmp(fix->style, "move") == 0 && shares_particles(fix))
      fail(name + " moves particles of this wall's group, which cannot rebound; the groups must "
                  "have no particle in common");
    const bool is_deform = strncmp(fix->style, "deform", 6) == 0;
    if ((fix->box_change & (BOX_CHANGE_SIZE | BOX_CHANGE_SHAPE)) &&
        !(is_deform && domain->deform_vremap))
      fail(name + " changes the box and moves particles with it, past the wall; " +
           (is_deform ? "it must be 'remap v', which leaves them where they are"
                      : "the box must keep its size"));
  }
}

/* True if a fix has changed the size of particles since the contacts of the step before. */
bool FixWallRebound::grows() const {
  for (int i = 0; i < modify->nfix; i++) {
    const Fix *fix = modify->fix[i];
    if (strncmp(fix->style, "adapt", 5) == 0 && fix->nevery > 0 &&
        (update->ntimestep - 1) % fix->nevery == 0)
      return true;
  }
  return false;
}

/* ---- a run ------------------------------------------------------------------------------------
 */

void FixWallRebound::init() {
  siblings_.clear();
  for (int i = 0; i < modify->nfix; i++)
    if (FixWallRebound *wall = dynamic_cast<FixWallRebound *>(modify->fix[i]))
      siblings_.push_back(wall);
  if (strstr(update->integrate_style, "respa"))
    fail("run_style respa is not supported; it must be run_style verlet");
  if (update->whichflag == 2)
    fail("minimize is not supported: a rebound is an event in time; use run");
  check_particles();
  check_box();
  if (from_restart_ && !restarted_)
    engine_.warn(
        "the restart file has no data of this wall; its impact numbers begin at 1, and no particle "
        "is stuck to it");
  from_restart_ = false;
  follow_step(update->ntimestep);
  stuck_ = wall_.stuck();
  try {
    if (region_)
      region_->init();
    wall_.init(update->ntimestep, update->dt);
  } catch (const std::exception &wrong) {
    fail(asperity::told(wrong));
  }
}

/* The command reset_timestep tells no fix, and a `run pre no` may follow it. */
void FixWallRebound::follow_step(bigint last) {
  if (last != last_step_)
    wall_.reset_step(last, last_step_);
  last_step_ = last;
}

/* Arrays of the atoms may have moved since the last step. */
void FixWallRebound::set_rows() {
  wall_.set_rows(state_.data(), place_.data());
}

void FixWallRebound::setup_pre_exchange() {
  pre_exchange();
}

void FixWallRebound::setup(int) {
  steps_ = false;
  check_movers();
  set_rows();
  try {
    if (region_)
      region_->setup();
    if (mesh_) {
      mesh_->set_periods(engine_.box().period);
      mesh_->setup(wall_.time(static_cast<double>(update->ntimestep)));
    }
    wall_.setup(engine_.spheres(), groupbit, engine_.box());
  } catch (const std::exception &wrong) {
    fail(asperity::told(wrong));
  }
}

void FixWallRebound::begin_step() {
  steps_ = true;
  follow_step(update->ntimestep - 1);
  wall_.set_box(engine_.box());
  if (grows())
    wall_.look_anew();
  if (region_)
    region_->begin_step();
  if (mesh_) {
    mesh_->set_periods(engine_.box().period);
    mesh_->begin_step(wall_.time(static_cast<double>(update->ntimestep)), update->dt);
  }
}

void FixWallRebound::post_integrate() {
  if (siblings_.front() != this)
    return;
  try {
    std::vector<Wall *> walls;
    for (FixWallRebound *fix : siblings_) {
      fix->set_rows();
      fix->begin_step();
      walls.push_back(&fix->wall_);
    }
    Wall::step(walls, engine_.spheres());
  } catch (const std::exception &wrong) {
    error->one(FLERR, "Fix wall/rebound: " + asperity::told(wrong));
  }
  for (FixWallRebound *fix : siblings_) {
    if (fix->wall_.model().deposit() != Model::DELETE)
      continue;
    int mine = fix->wall_.has_to_delete(), any; /* all ranks must agree to build lists anew */
    MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
    if (any)
      fix->next_reneighbor = update->ntimestep;
  }
}

void FixWallRebound::pre_exchange() {
  if (wall_.model().deposit() != Model::DELETE)
    return;
  set_rows();
  bigint mine = 0, all;
  for (int i = 0; i < atom->nlocal;) {
    if (wall_.is_to_delete(i)) {
      atom->avec->copy(atom->nlocal - 1, i, 1);
      atom->nlocal--;
      mine++;
    } else
      i++;
  }
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  atom->natoms -= all;
  if (all > 0 && atom->map_style) {
    atom->nghost = 0;
    atom->map_init();
    atom->map_set();
  }
}

void FixWallRebound::pre_neighbor() {
  set_rows();
  wall_.reorder(engine_.spheres());
}

void FixWallRebound::post_neighbor() {
  check_movers();
}

void FixWallRebound::end_of_step() {
  if (!steps_)
    fail("rerun is not supported: a rebound is an event in time; use run");
  set_rows();
  last_step_ = update->ntimestep;
  if (siblings_.front() == this) {
    std::vector<Wall *> walls;
    for (FixWallRebound *fix : siblings_) {
      fix->set_rows();
      walls.push_back(&fix->wall_);
    }
    Wall::hold(walls, engine_.spheres());
  }
  try {
    wall_.end_step(update->ntimestep, output->next == update->ntimestep);
    if (mesh_ && map_.is_due(update->ntimestep))
      map_.write(world, update->ntimestep, mesh_->triangles(), mesh_->motion().end(),
                 wall_.sums(0), wall_.worn_density(0));
  } catch (const std::exception &wrong) {
    fail(asperity::told(wrong));
  }
  if (Ledger *ledger = wall_.ledger()) { /* between two windows there are no rows to be read */
    const bool due = update->ntimestep % ledger->every() == 0;
    array_local = due ? ledger->rows() : NULL;
    size_local_rows = due ? ledger->size() : 0;
  }
}

void FixWallRebound::post_run() {
  stuck_ = wall_.stuck();
  try {
    wall_.end_run();
  } catch (const std::exception &wrong) {
    fail(asperity::told(wrong));
  }
}

void FixWallRebound::reset_dt() {
  wall_.reset_dt(update->ntimestep, update->dt);
}

/* ---- output and restart -----------------------------------------------------------------------
 */

double FixWallRebound::compute_scalar() {
  return wall_.counter(Wall::N_IMPACTS);
}

double FixWallRebound::compute_vector(int n) {
  return wall_.counter(n);
}

double FixWallRebound::compute_array(int row, int column) {
  return wall_.total(row, column);
}

double FixWallRebound::memory_usage() {
  return wall_.bytes() + (state_.capacity() + place_.capacity()) * sizeof(double);
}

void FixWallRebound::write_restart(FILE *file) {
  std::vector<char> record;
  try {
    record = wall_.save();
  } catch (const std::exception &wrong) {
    fail(asperity::told(wrong));
  }
  if (comm->me != 0)
    return;
  const int size = static_cast<int>(record.size());
  fwrite(&size, sizeof size, 1, file);
  fwrite(record.data(), 1, record.size(), file);
}

/* LAMMPS does not tell how long the buffer is; the record does. */
void FixWallRebound::restart(char *buffer) {
  try {
    wall_.restore(buffer);
  } catch (const std::exception &wrong) {
    fail(asperity::told(wrong));
  }
  restarted_ = true;
}

/* A data file is read before the wall is there, so that nothing of the wall can be in it. LAMMPS
 * calls rank 0 only. */
void FixWallRebound::write_data_header(FILE *, int) {
  if (stuck_ > 0)
    engine_.warn(text("%.0f particles are stuck to this wall, which a data file does not keep: a "
                      "script that reads it has them free; write_restart keeps them",
                      stuck_));
}

/* ---- numbers of each atom ---------------------------------------------------------------------
 */

void FixWallRebound::grow_arrays(int n) {
  const size_t atoms = static_cast<size_t>(n);
  state_.reserve(atoms * Wall::N_STATE); /* no more than that */
  place_.reserve(atoms * Wall::N_PLACE);
  state_.resize(atoms * Wall::N_STATE);
  place_.resize(atoms * Wall::N_PLACE);
}

void FixWallRebound::copy_arrays(int from, int to, int) {
  double row[ROW];
  pack_exchange(from, row);
  unpack_exchange(to, row);
}

void FixWallRebound::set_arrays(int i) {
  double none[ROW] = {0};
  unpack_exchange(i, none);
}

int FixWallRebound::pack_exchange(int i, double *buffer) {
  const double *state = &state_[static_cast<size_t>(i) * Wall::N_STATE];
  const double *place = &place_[static_cast<size_t>(i) * Wall::N_PLACE];
  std::copy(state, state + Wall::N_STATE, buffer);
  std::copy(place, place + Wall::N_PLACE, buffer + Wall::N_STATE);
  return ROW;
}

int FixWallRebound::unpack_exchange(int i, double *buffer) {
  std::copy(buffer, buffer + Wall::N_STATE, &state_[static_cast<size_t>(i) * Wall::N_STATE]);
  std::copy(buffer + Wall::N_STATE, buffer + ROW, &place_[static_cast<size_t>(i) * Wall::N_PLACE]);
  return ROW;
}

/* The first number is how many there are, with itself. */
int FixWallRebound::pack_restart(int i, double *buffer) {
  buffer[0] = ROW + 1;
  return pack_exchange(i, buffer + 1) + 1;
}

void FixWallRebound::unpack_restart(int i, int nth) {
  double *all = atom->extra[i];
  for (int before = 0; before < nth; before++)
    all += static_cast<int>(*all);
  if (static_cast<int>(*all) == ROW + 1)
    unpack_exchange(i, all + 1);
  else
    set_arrays(i);
}

int FixWallRebound::size_restart(int) {
  return ROW + 1;
}

int FixWallRebound::maxsize_restart() {
  return ROW + 1;
}
