/* fix wall/rebound; see fix_wall_rebound.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fix_wall_rebound.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <algorithm>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_property_atom.h"
#include "fix_property_global.h"
#include "fix_template_sphere.h"
#include "fix_wall_gran.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "update.h"
#include "dem/error.h"
#include "dem/primitive.h"
#include "dem/text.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using asperity::Ledger;
using asperity::Model;
using asperity::Spheres;
using asperity::text;
using asperity::Wall;
using asperity::Words;

/* ---- making -----------------------------------------------------------------------------------
 */

FixWallRebound::FixWallRebound(LAMMPS *engine, int narg, char **arg)
    : Fix(engine, narg, arg), wall_(*this), wall_type_(), fix_state_(NULL), fix_place_(NULL),
      restarted_(false) {
  check_particles();
  check_box();
  try {
    std::string geometry;
    Words words(narg - 3, arg + 3);
    read_geometry(words, geometry);
    check_meshes();
    wall_.parse(words, geometry);
  } catch (const std::exception &wrong) {
    fail(asperity::message_of(wrong));
  }
  scalar_flag = vector_flag = array_flag = 1;
  size_vector = Wall::N_COUNTERS;
  size_array_rows = static_cast<int>(wall_.shapes());
  size_array_cols = Wall::N_TOTALS;
  global_freq = 1;
  extscalar = extvector = extarray = 1;
  restart_global = 1;
  nevery = 1;
  force_reneighbor = wall_.model().deposit() == Model::DELETE;
  next_reneighbor = -1;
  if (Ledger *ledger = wall_.ledger()) {
    local_flag = 1;
    local_freq = static_cast<int>(ledger->every());
    size_local_rows = 0;
    size_local_cols = ledger->columns();
  }
}

FixWallRebound::~FixWallRebound() {}

void FixWallRebound::fail(const std::string &what) const {
  error->fix_error(FLERR, const_cast<FixWallRebound *>(this), what.c_str());
}

void FixWallRebound::read_geometry(Words &words, std::string &geometry) {
  if (words.done())
    throw asperity::Error("the wall is missing; it must be 'mesh n_meshes N meshes id1 ...' or "
                          "'primitive type T style args'");
  if (words.take("model"))
    throw asperity::Error(
        "takes no model: 'model hertz' and the like belong to 'fix wall/gran'; here 'rebound' "
        "states the law");
  if (words.take("primitive")) {
    if (!words.take("type") || words.left() < 2)
      throw asperity::Error("behind 'primitive', 'type T style args' is expected");
    const int type = static_cast<int>(words.whole("the wall's type", 1, atom->ntypes));
    std::string shape;
    wall_.add_shape(asperity::read_primitive(words, shape), type, 0, "");
    geometry = text("primitive type %d ", type) + shape;
    wall_type_[0] = wall_type_[1] = type;
  } else if (words.take("mesh"))
    geometry = read_meshes(words);
  else
    throw asperity::Error("the wall is '" + words.word("the wall") +
                          "'; it must be 'mesh' or 'primitive'");
  if (words.is("model"))
    throw asperity::Error(
        "takes no model: 'model hertz' and the like belong to 'fix wall/gran'; here 'rebound' "
        "states the law");
}

std::string FixWallRebound::read_meshes(Words &words) {
  std::string geometry = "mesh";
  if (!words.take("n_meshes"))
    throw asperity::Error("behind 'mesh', 'n_meshes N meshes id1 ...' is expected");
  const int count = static_cast<int>(words.whole("n_meshes", 1, 1e6));
  if (!words.take("meshes"))
    throw asperity::Error("behind 'mesh', 'n_meshes N meshes id1 ...' is expected");
  if (words.left() < static_cast<size_t>(count))
    throw asperity::Error(
        text("n_meshes is '%d', with %d words behind 'meshes'; there must be as many mesh ids",
             count, static_cast<int>(words.left())));
  for (int m = 0; m < count; m++) {
    const std::string name = words.word("a mesh id");
    FixMeshSurface *mesh = NULL;
    for (int i = 0; i < modify->nfix; i++)
      if (modify->fix[i]->id == name)
        mesh = dynamic_cast<FixMeshSurface *>(modify->fix[i]);
    if (!mesh)
      throw asperity::Error(
          text("mesh '%s' does not exist; define it before the wall, by 'fix %s all "
               "mesh/surface file FILE.stl type T'",
               name.c_str(), name.c_str()));
    if (std::find(mesh_ids_.begin(), mesh_ids_.end(), name) != mesh_ids_.end())
      throw asperity::Error("mesh '" + name + "' is named twice; each mesh must be named once");
    if (strstr(mesh->style, "deform"))
      throw asperity::Error("mesh '" + name + "' is of style '" + mesh->style +
                            "'; meshes must be rigid, and this one can change its form");
    check_owner(mesh);
    const int type = mesh->atomTypeWall();
    meshes_.push_back(new MeshOfLiggghts(Fix::world, mesh));
    wall_.add_shape(std::unique_ptr<asperity::Shape>(meshes_.back()), type,
                    meshes_.back()->pieces(), name);
    mesh_ids_.push_back(name);
    wall_type_[0] = m == 0 ? type : std::min(wall_type_[0], type);
    wall_type_[1] = std::max(wall_type_[1], type);
    geometry += " " + name;
  }
  return geometry;
}

int FixWallRebound::setmask() {
  return POST_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | PRE_FORCE | END_OF_STEP | POST_RUN;
}

std::string FixWallRebound::state_id() const {
  return std::string("rebound_") + Fix::id;
}

std::string FixWallRebound::place_id() const {
  return std::string("stuck_") + Fix::id;
}

/* Zeros for each particle, which go with it and into restart files. */
FixPropertyAtom *FixWallRebound::add_property(const std::string &name, int columns) {
  std::vector<std::string> words = {name, "all", "property/atom", name, "vector", "yes",
                                    "no", "no"};
  words.resize(words.size() + columns, "0.");
  std::vector<char *> arg;
  for (std::string &word : words)
    arg.push_back(&word[0]);
  return modify->add_fix_property_atom(static_cast<int>(arg.size()), arg.data(), style);
}

void FixWallRebound::post_create() {
  if (modify->fix_restart_in_progress() && !restarted_)
    warn(
        "the restart file has no data of this wall; its impact numbers begin at 1, and no particle "
        "is stuck to it");
  fix_state_ = add_property(state_id(), Wall::N_STATE);
  fix_place_ = add_property(place_id(), Wall::N_PLACE);
  for (MeshOfLiggghts *mesh : meshes_)
    if (strstr(mesh->fix()->style, "servo")) /* it counts what is near, by LIGGGHTS's own list */
      mesh->fix()->createWallNeighList(igroup);
}

void FixWallRebound::pre_delete(bool unfixflag) {
  for (const std::string &name : {state_id(), place_id()})
    if (unfixflag && modify->find_fix_id(name.c_str()))
      modify->delete_fix(name.c_str());
  for (size_t m = 0; unfixflag && m < meshes_.size(); m++)
    if (modify->find_fix_id(mesh_ids_[m].c_str()) == meshes_[m]->fix()) {
      meshes_[m]->remove_sums();
      if (strstr(meshes_[m]->fix()->style, "servo"))
        meshes_[m]->fix()->deleteWallNeighList();
    }
}

/* ---- what the wall asks -----------------------------------------------------------------------
 */

MPI_Comm FixWallRebound::world() const {
  return Fix::world;
}

std::string FixWallRebound::id() const {
  return Fix::id;
}

std::string FixWallRebound::units() const {
  return update->unit_style;
}

std::string FixWallRebound::known_units() const {
  return "si, cgs or micro";
}

int FixWallRebound::types() const {
  return atom->ntypes;
}

int FixWallRebound::dimension() const {
  return domain->dimension;
}

double FixWallRebound::time() const {
  return update->get_cur_time();
}

void FixWallRebound::warn(const std::string &what) const {
  if (comm->me == 0)
    error->warning(FLERR, ("Fix wall/rebound (id " + id() + "): " + what).c_str());
}

void FixWallRebound::print(const std::string &what) const {
  if (comm->me != 0)
    return;
  for (FILE *to : {screen, logfile})
    if (to)
      fprintf(to, "%s\n", what.c_str());
}

bool FixWallRebound::constants(const char *name, bool pairs, std::vector<double> &values) const {
  const int n = atom->ntypes;
  Fix *found =
      modify->find_fix_property(name, "property/global", pairs ? "peratomtypepair" : "peratomtype",
                                n, pairs ? n : 0, style, false);
  values.clear();
  if (!found)
    return false;
  FixPropertyGlobal *property = static_cast<FixPropertyGlobal *>(found);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < (pairs ? n : 1); j++)
      values.push_back(pairs ? property->compute_array(i, j) : property->compute_vector(i));
  return true;
}

std::string FixWallRebound::how_to_state(const char *name, bool pairs,
                                         const std::string &values) const {
  return text("fix %s all property/global %s %s %s", name, name,
              pairs ? text("peratomtypepair %d", atom->ntypes).c_str() : "peratomtype",
              values.c_str());
}

/* Those that there are, and those of the templates. */
void FixWallRebound::diameters(double &least, double &most) const {
  modify->max_min_rad(most, least);
  least = most > 0 ? 2 * least : 0;
  most *= 2;
}

std::vector<asperity::Engine::Kind> FixWallRebound::kinds() const {
  std::vector<double> present(static_cast<size_t>(atom->ntypes), 0.);
  for (int i = 0; i < modify->nfix; i++)
    if (FixTemplateSphere *grain = dynamic_cast<FixTemplateSphere *>(modify->fix[i]))
      present[static_cast<size_t>(grain->maxtype() - 1)] = 1;
  return asperity::kinds_of(spheres(), groupbit, present, Fix::world);
}

int FixWallRebound::min_type() {
  return wall_type_[0];
}

int FixWallRebound::max_type() {
  return wall_type_[1];
}

/* ---- checks -----------------------------------------------------------------------------------
 */

void FixWallRebound::check_particles() const {
  if (!atom->radius_flag || !atom->rmass_flag || atom->ellipsoid_flag || atom->superquadric_flag ||
      atom->shapetype_flag)
    fail("particles must be spheres with a radius and a density, by 'atom_style granular' or "
         "'sphere'");
  if (modify->n_fixes_style("multisphere") > 0 || modify->n_fixes_style("rigid") > 0)
    fail(
        "particles that are tied to bodies (fix multisphere, fix rigid) cannot rebound one by one");
  if (!atom->tag_enable)
    fail("particles have no tags, which the draws depend on; use 'atom_modify id yes'");
}

void FixWallRebound::check_box() const {
  if (domain->triclinic && (domain->xperiodic || domain->yperiodic || domain->zperiodic))
    fail("the box is triclinic and periodic; a periodic box must be orthogonal");
}

/* What the wall uses may have been taken away since. */
void FixWallRebound::check_meshes() const {
  for (size_t m = 0; m < meshes_.size(); m++)
    if (modify->find_fix_id(mesh_ids_[m].c_str()) != meshes_[m]->fix())
      fail("mesh '" + mesh_ids_[m] +
           "' has been deleted while this wall uses it; unfix the wall first");
  if (fix_state_ && modify->find_fix_id(state_id().c_str()) != fix_state_)
    fail("fix property/atom '" + state_id() + "' has been deleted while this wall uses it");
  if (fix_place_ && modify->find_fix_id(place_id().c_str()) != fix_place_)
    fail("fix property/atom '" + place_id() + "' has been deleted while this wall uses it");
  for (MeshOfLiggghts *mesh : meshes_)
    check_owner(mesh->fix());
}

/* A mesh of two walls would turn its particles round twice. */
void FixWallRebound::check_owner(const FixMeshSurface *mesh) const {
  for (int i = 0; i < modify->nfix; i++) {
    std::vector<FixMeshSurface *> theirs;
    if (FixWallRebound *wall = dynamic_cast<FixWallRebound *>(modify->fix[i]))
      for (size_t k = 0; wall != this && k < wall->meshes_.size(); k++)
        theirs.push_back(wall->meshes_[k]->fix());
    if (FixWallGran *wall = dynamic_cast<FixWallGran *>(modify->fix[i]))
      theirs.assign(wall->mesh_list(), wall->mesh_list() + wall->n_meshes());
    if (std::find(theirs.begin(), theirs.end(), mesh) != theirs.end())
      fail("mesh '" + std::string(mesh->id) + "' is already used by fix '" + modify->fix[i]->id +
           "'; there must be one wall for each mesh");
  }
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
  check_meshes();
  for (MeshOfLiggghts *mesh : meshes_)
    if (mesh->fix()->triMesh()->prop().getGlobalProperty<ScalarContainer<double>>("Temp"))
      warn("mesh '" + std::string(mesh->fix()->id) +
           "' has a temperature; this wall conducts no heat, by 'fix heat/gran' or otherwise");
  try {
    wall_.init(update->ntimestep, update->dt);
  } catch (const std::exception &wrong) {
    fail(asperity::message_of(wrong));
  }
}

Spheres FixWallRebound::spheres() const {
  Spheres s;
  s.step = update->ntimestep;
  s.dt = update->dt;
  s.n = atom->nlocal;
  s.mask = atom->mask;
  s.type = atom->type;
  s.tag = atom->tag;
  s.tag_bytes = sizeof *atom->tag;
  s.x = atom->x ? atom->x[0] : NULL;
  s.v = atom->v ? atom->v[0] : NULL;
  s.omega = atom->omega_flag && atom->omega ? atom->omega[0] : NULL;
  s.f = atom->f ? atom->f[0] : NULL;
  s.radius = atom->radius;
  s.mass = atom->rmass;
  return s;
}

/* Arrays of the atoms may have moved since the last step. */
void FixWallRebound::set_rows() {
  double **state = fix_state_->array_atom, **place = fix_place_->array_atom;
  wall_.set_rows(state ? state[0] : NULL, place ? place[0] : NULL);
}

void FixWallRebound::setup_pre_exchange() {
  pre_exchange();
}

void FixWallRebound::setup(int) {
  asperity::Box box;
  const int periodic[3] = {domain->xperiodic, domain->yperiodic, domain->zperiodic};
  for (int d = 0; d < 3; d++)
    box.period[d] = periodic[d] ? domain->prd[d] : 0;
  asperity::Bounds here;
  for (int d = 0; d < 3; d++) {
    here.lo[d] = domain->triclinic ? domain->boxlo[d] : domain->sublo[d];
    here.hi[d] = domain->triclinic ? domain->boxhi[d] : domain->subhi[d];
  }
  here.widen(neighbor->cutneighmax);
  try {
    for (MeshOfLiggghts *mesh : meshes_) {
      mesh->set_periods(box.period);
      const std::string report = mesh->setup(here);
      if (!report.empty())
        print("fix " + id() + " wall/rebound: " + report);
    }
    set_rows();
    wall_.setup(spheres(), groupbit, box);
  } catch (const std::exception &wrong) {
    fail(asperity::message_of(wrong));
  }
  show_maps();
}

void FixWallRebound::post_integrate() {
  if (siblings_.front() != this)
    return;
  try {
    std::vector<Wall *> walls;
    for (FixWallRebound *fix : siblings_) {
      fix->set_rows();
      for (MeshOfLiggghts *mesh : fix->meshes_)
        mesh->begin_step(update->dt);
      walls.push_back(&fix->wall_);
    }
    Wall::step(walls, spheres());
  } catch (const std::exception &wrong) {
    error->one(FLERR, ("Fix wall/rebound: " + asperity::message_of(wrong)).c_str());
  }
  for (FixWallRebound *fix : siblings_) {
    if (fix->wall_.model().deposit() != Model::DELETE)
      continue;
    int mine = fix->wall_.has_to_delete(), any; /* all ranks must agree to build lists anew */
    MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, Fix::world);
    if (any)
      fix->next_reneighbor = update->ntimestep;
  }
}

/* Comm::exchange, which follows, counts the atoms anew. */
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
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, Fix::world);
  if (all > 0 && atom->tag_enable && atom->map_style) {
    atom->nghost = 0;
    atom->map_init();
    atom->map_set();
  }
}

void FixWallRebound::pre_neighbor() {
  set_rows();
  wall_.reorder(spheres());
}

/* Meshes that measure: LIGGGHTS has cleared their sums by now, and will use them after the forces.
 */
void FixWallRebound::pre_force(int) {
  for (MeshOfLiggghts *mesh : meshes_) {
    if (!mesh->measures())
      continue;
    const double *const *k_finnie = NULL;
    if (mesh->wears())
      k_finnie = static_cast<FixPropertyGlobal *>(
                     modify->find_fix_property("k_finnie", "property/global", "peratomtypepair",
                                               atom->ntypes, atom->ntypes, style))
                     ->get_array();
    mesh->hand_over(update->dt, k_finnie);
  }
}

void FixWallRebound::end_of_step() {
  set_rows();
  if (siblings_.front() == this) {
    std::vector<Wall *> walls;
    for (FixWallRebound *fix : siblings_) {
      fix->set_rows();
      walls.push_back(&fix->wall_);
    }
    Wall::hold(walls, spheres());
  }
  const bool is_output = output->next == update->ntimestep;
  if (is_output)
    show_maps();
  try {
    wall_.end_step(update->ntimestep, is_output);
  } catch (const std::exception &wrong) {
    fail(asperity::message_of(wrong));
  }
  if (Ledger *ledger = wall_.ledger()) { /* between two windows there are no rows to be read */
    const bool due = update->ntimestep % ledger->every() == 0;
    array_local = due ? ledger->rows() : NULL;
    size_local_rows = due ? ledger->size() : 0;
  }
}

void FixWallRebound::post_run() {
  show_maps();
  try {
    wall_.end_run();
  } catch (const std::exception &wrong) {
    fail(asperity::message_of(wrong));
  }
}

void FixWallRebound::show_maps() {
  for (size_t m = 0; m < meshes_.size(); m++)
    wall_.show_sums(m, [this, m](size_t first, const std::vector<double> &sums) {
      meshes_[m]->show(first, sums, wall_.worn_density(m));
    });
}

void FixWallRebound::reset_dt() {
  wall_.reset_dt(update->ntimestep, update->dt);
}

void FixWallRebound::reset_timestep(bigint now, bigint before) {
  wall_.reset_step(now, before);
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
  return wall_.bytes();
}

void FixWallRebound::write_restart(FILE *file) {
  std::vector<char> record;
  try {
    record = wall_.save();
  } catch (const std::exception &wrong) {
    fail(asperity::message_of(wrong));
  }
  if (comm->me != 0)
    return;
  const int size = static_cast<int>(record.size());
  fwrite(&size, sizeof size, 1, file);
  fwrite(record.data(), 1, record.size(), file);
}

/* LIGGGHTS does not tell how long the buffer is; the record does. */
void FixWallRebound::restart(char *buffer) {
  try {
    wall_.restore(buffer);
  } catch (const std::exception &wrong) {
    fail(asperity::message_of(wrong));
  }
  restarted_ = true;
}
