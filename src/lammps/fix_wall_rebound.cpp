/* fix wall/rebound; see fix_wall_rebound.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fix_wall_rebound.h"

#include "atom.h"
#include "atom_vec.h"
#include "citeme.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "group.h"
#include "input.h"
#include "library.h"
#include "memory.h"
#include "modify.h"
#include "output.h"
#include "update.h"
#include "variable.h"

#include "bodies_lammps.h"
#include "driven_mesh.h"
#include "map_file.h"
#include "region_shape.h"

#include "dem/error.h"
#include "dem/shapes/primitive.h"
#include "dem/text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

using namespace LAMMPS_NS;
using namespace FixConst;
using asperity::Books;
using asperity::text;
using asperity::Wall;
using asperity::Words;

static const int SAVED_MOST = 1 + Wall::N_STATE + asperity::PACKED_MOST;

static const char CITE[] =
    "fix wall/rebound command: doi:10.33737/jgpps/118624\n\n"
    "@Article{Altmeppen2020,\n"
    " author = {J. Altmeppen and H. Sommerfeld and C. Koch and S. Staudacher},\n"
    " title = {An analytical approach to estimate the effect of surface roughness on particle "
    "rebound},\n"
    " journal = {Journal of the Global Power and Propulsion Society},\n"
    " year = 2020\n"
    "}\n\n"
    "@Misc{asperity,\n"
    " author = {{The asperity developers}},\n"
    " title = {asperity: rough walls for particle simulation}\n"
    "}\n\n";

struct FixWallRebound::Parts : asperity::WallFix<EngineOfLammps> {
  asperity::MapFile map;
  asperity::DrivenMesh *mesh; /* the wall's shape, or NULL */
  RegionShape *region;        /* the same */
  BodiesOfLammps of_bodies;
  bigint last_step; /* that the wall knows of */
  bool steps;       /* this run has steps, which a rerun has not */
  bool from_restart;
  bool owes_bodies; /* the forces of walls, in the first step of a run */
  double stuck;     /* particles of all ranks, when a run began or ended */
  int type;         /* of the wall */

  Parts(LAMMPS *lammps, Fix *fix)
      : WallFix(lammps, fix), mesh(NULL), region(NULL), of_bodies(lammps, fix), last_step(0),
        steps(false), from_restart(false), owes_bodies(false), stuck(0), type(0) {}

  void fail(const std::string &what) const override {
    program_->error->all(FLERR, "Fix wall/rebound (id " + id() + "): " + what);
  }
  void fail_alone(const std::string &what) const override {
    program_->error->one(FLERR, "Fix wall/rebound (id " + id() + "): " + what);
  }
  void set_rows() override {
    wall.set_rows(fix_->array_atom ? fix_->array_atom[0] : NULL);
  }
  asperity::BodySource &bodies() override {
    return of_bodies;
  }
  std::string body_error(const Fix *fix) const override {
    return fix->rigid_flag ? BodiesOfLammps::error_of(fix) : "";
  }
  bool changes_box(const Fix *fix) const override {
    return fix->box_change & (BOX_CHANGE_SIZE | BOX_CHANGE_SHAPE);
  }
  void check_units() const {
    const std::string units = this->units();
    if (units != "si" && units != "cgs" && units != "micro" && units != "nano" && units != "lj")
      fail("units are '" + units + "'; they must be " + known_units() +
           ", or lj without materials");
  }
  void check_atoms() const {
    const Atom *atom = program_->atom;
    check_particles(atom->ellipsoid_flag || atom->line_flag || atom->tri_flag || atom->body_flag,
                    "sphere");
    if (program_->kokkos && !lammps_config_accelerator("KOKKOS", "precision", "double"))
      fail("the package KOKKOS was built with single or mixed precision; it must be double");
  }
  void begin_step() override;
  void follow_step(bigint last);
};

/* ---- making -----------------------------------------------------------------------------------
 */

FixWallRebound::FixWallRebound(LAMMPS *lammps, int narg, char **arg)
    : WallHooks(lammps, narg, arg), p_(new Parts(lammps, this)) {
  if (lammps->citeme)
    lammps->citeme->add(CITE);
  p_->last_step = update->ntimestep;
  p_->from_restart = modify->nfix_restart_global > 0 || modify->nfix_restart_peratom > 0;
  p_->check_units();
  p_->check_atoms();
  p_->attempt([&] {
    std::string geometry;
    Words words(narg - 3, arg + 3);
    read_geometry(words, geometry);
    p_->wall.parse(words, geometry, "map", [this](Words &next) {
      if (!p_->mesh || !next.take("map"))
        return false;
      p_->map.parse(next);
      return true;
    });
    if (p_->units() == "lj" && p_->wall.setup.model.needs_materials())
      throw asperity::Error("units are 'lj', in which materials have no constants; units must be " +
                            p_->known_units() +
                            ", or the law one without materials, such as rebound constant");
  });
  p_->set_flags();
  wd_header = 1;
  maxexchange = Wall::N_STATE + asperity::PACKED_MOST;
  comm_forward = BodiesOfLammps::SENT;
  peratom_flag = peratom_freq = 1;
  size_peratom_cols = Wall::N_STATE;
  FixWallRebound::grow_arrays(atom->nmax);
  for (int i = 0; i < atom->nlocal; i++)
    FixWallRebound::set_arrays(i);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixWallRebound::~FixWallRebound() {
  /* By a command of the script that names this fix, and not with all others at the end. */
  if (update && input->narg > 0 && strcmp(input->arg[0], id) == 0)
    p_->report_loss();
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
  memory->destroy(array_atom);
  delete p_;
}

void FixWallRebound::read_geometry(Words &words, std::string &geometry) {
  const std::string primitives = "xplane yplane zplane xcylinder ycylinder zcylinder";
  const std::string shapes = primitives + " region stl";
  if (words.done())
    throw asperity::Error("the wall is missing; it must be one of " + shapes);
  p_->refuse_model(words);
  if (words.take("region")) {
    const std::string name = words.word("the ID of a region");
    p_->region = new RegionShape(lmp, name);
    std::unique_ptr<asperity::Shape> shape(p_->region);
    p_->type = read_type(words);
    geometry = p_->region->description() + text(" type %d", p_->type);
    p_->wall.add_shape(std::move(shape), p_->type, 0,
                       name); /* by name, so that its motion is saved */
  } else if (words.take("stl")) {
    std::unique_ptr<asperity::DrivenMesh> mesh =
        asperity::read_driven_mesh(world, words, atom->ntypes, p_->type, geometry,
                                   [this](const std::string &name) { return value_of(name); });
    p_->mesh = mesh.get();
    p_->wall.add_shape(std::move(mesh), p_->type, p_->mesh->pieces(), "stl");
    p_->print("fix " + p_->id() + " wall/rebound: " + p_->mesh->describe());
  } else if (words.is_one_of(primitives)) {
    static const char MOVES[] =
        "; a wall that moves is a region of style block or plane with 'move', or 'stl FILE' with "
        "'move'";
    if (words.left() > 1 && strncmp(words.rest()[1], "v_", 2) == 0)
      throw asperity::Error(
          text("the place of '%s' is '%s'; it must be a number", words.rest()[0], words.rest()[1]) +
          MOVES);
    std::unique_ptr<asperity::Shape> shape = asperity::read_primitive(words, geometry);
    if (words.is_one_of("wiggle move rotate"))
      throw asperity::Error("'" + words.word("") + "' is unknown behind '" + geometry + "'" +
                            MOVES);
    p_->type = read_type(words);
    geometry += text(" type %d", p_->type);
    if (!words.done() && (words.is("NULL") || isdigit(words.rest()[0][0])))
      throw asperity::Error("'" + words.word("") + "' stands behind '" + geometry +
                            "'; a fix of this style is one plane, so that a second one needs a fix "
                            "of its own, and NULL is left out");
    p_->wall.add_shape(std::move(shape), p_->type, 0, "");
  } else
    throw asperity::Error("the wall is '" + words.word("the wall") + "'; it must be one of " +
                          shapes);
}

/* Of a variable that moves the wall. */
double FixWallRebound::value_of(const std::string &name) const {
  const int at = input->variable->find(name.c_str());
  if (at < 0 || !input->variable->equalstyle(at))
    throw asperity::Error("variable '" + name + "' of 'move variable' " +
                          (at < 0 ? "does not exist" : "is not of equal style"));
  const double value = input->variable->compute_equal(at);
  if (!std::isfinite(value))
    throw asperity::Error(
        text("variable '%s' of 'move variable' is %g; it must be finite", name.c_str(), value));
  return value;
}

/* The last type where the script names none. */
int FixWallRebound::read_type(Words &words) const {
  if (!words.take("type"))
    return atom->ntypes;
  return static_cast<int>(words.whole("the wall's type", 1, atom->ntypes));
}

asperity::WallFix<EngineOfLammps> &FixWallRebound::wall_fix() {
  return *p_;
}

int FixWallRebound::setmask() {
  return POST_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | POST_NEIGHBOR | END_OF_STEP | POST_RUN;
}

/* ---- a run ------------------------------------------------------------------------------------
 */

void FixWallRebound::init() {
  p_->find_walls([](Fix *fix) {
    FixWallRebound *wall = dynamic_cast<FixWallRebound *>(fix);
    return wall ? wall->p_ : NULL;
  });
  p_->check_run();
  p_->check_atoms();
  if (p_->from_restart && !p_->wall.is_restored())
    p_->warn_of_no_restart();
  p_->from_restart = false;
  p_->follow_step(update->ntimestep);
  p_->stuck = p_->wall.stuck();
  p_->attempt([this] {
    if (p_->region)
      p_->region->init();
    p_->of_bodies.init();
    p_->owes_bodies = !p_->of_bodies.stand_before(this);
    int &stages = modify->fmask[modify->find_fix(id)];
    stages = p_->owes_bodies ? stages | INITIAL_INTEGRATE : stages & ~INITIAL_INTEGRATE;
    if (p_->of_bodies.any())
      p_->wall.setup.check_bodies();
    p_->wall.init(update->ntimestep, update->dt);
  });
}

/* The command reset_timestep tells no fix, and a `run pre no` may follow it. */
void FixWallRebound::Parts::follow_step(bigint last) {
  if (last != last_step)
    wall.setup.clock.step += static_cast<double>(last - last_step);
  last_step = last;
}

void FixWallRebound::setup(int) {
  p_->steps = false;
  p_->check_movers();
  p_->attempt([this] {
    const double off = p_->region ? p_->region->setup() : 0;
    if (off > 0)
      p_->warn(
          text("the region stands %.4g from where the last step has left it; what lies between "
               "is passed without a contact. Its variables must go on from run to run: by "
               "'time', not by 'step*dt' behind the command timestep",
               off));
    if (p_->mesh) {
      p_->mesh->setup(p_->wall.setup.time(static_cast<double>(update->ntimestep)));
      p_->mesh->set_images(p_->box());
    }
  });
  p_->begin(true);
  p_->push_spheres();
  if (!p_->owes_bodies)
    p_->attempt([this] { p_->push_bodies(); });
}

/* Fixes of bodies behind this one have set up their forces later. Otherwise init() leaves this
 * stage out, since KOKKOS copies all arrays of particles for each stage of a fix. */
void FixWallRebound::initial_integrate(int) {
  if (!p_->owes_bodies)
    return;
  p_->owes_bodies = false;
  p_->attempt([this] { p_->push_bodies(); });
}

void FixWallRebound::Parts::begin_step() {
  const Update *update = program_->update;
  steps = true;
  follow_step(update->ntimestep - 1);
  wall.setup.box = box();
  if (region)
    region->begin_step();
  if (mesh) {
    mesh->begin_step(wall.setup.time(static_cast<double>(update->ntimestep)), update->dt);
    if (mesh->set_images(box()))
      wall.stepper.clear_ahead();
  }
}

void FixWallRebound::pre_exchange() {
  atom->natoms -= p_->delete_particles();
}

void FixWallRebound::pre_neighbor() {
  p_->set_rows();
  p_->list_bodies(false);
  p_->wall.reorder(p_->spheres());
}

void FixWallRebound::post_neighbor() {
  p_->check_movers();
}

void FixWallRebound::end_of_step() {
  if (!p_->steps)
    p_->fail("rerun is not supported: a rebound is an event in time; use run");
  p_->last_step = update->ntimestep;
  p_->hold();
  p_->end_step();
  if (p_->mesh && p_->map.is_due(update->ntimestep))
    p_->attempt([this] {
      p_->map.write(world, update->ntimestep, p_->time(), p_->mesh->triangles(),
                    p_->mesh->motion().end(), p_->wall.books.sums(0), p_->wall.worn_density(0));
    });
}

void FixWallRebound::post_run() {
  p_->stuck = p_->wall.stuck();
  p_->end();
}

/* ---- output and restart -----------------------------------------------------------------------
 */

double FixWallRebound::memory_usage() {
  return p_->wall.bytes() + static_cast<double>(atom->nmax * sizeof(double) * Wall::N_STATE);
}

/* A data file is read before the wall is there, so that nothing of the wall can be in it. LAMMPS
 * calls rank 0 only. */
void FixWallRebound::write_data_header(FILE *, int) {
  if (p_->stuck > 0)
    p_->warn(text("%.0f particles are stuck to this wall, which a data file does not keep: a "
                  "script that reads it has them free; write_restart keeps them",
                  p_->stuck));
}

int FixWallRebound::pack_forward_comm(int n, int *list, double *buffer, int, int *) {
  return p_->of_bodies.pack(n, list, buffer);
}

void FixWallRebound::unpack_forward_comm(int n, int first, double *buffer) {
  p_->of_bodies.unpack(n, first, buffer);
}

/* ---- numbers of each atom: in rows, which LAMMPS shows, and in memories
 * --------------------------
 */

void FixWallRebound::grow_arrays(int n) {
  memory->grow(array_atom, n, Wall::N_STATE, "wall/rebound:array_atom");
  p_->wall.stepper.rows.grow(n);
  p_->set_rows();
}

void FixWallRebound::copy_arrays(int from, int to, int) {
  std::copy_n(array_atom[from], int{Wall::N_STATE}, array_atom[to]);
  p_->wall.stepper.rows.copy(from, to);
}

void FixWallRebound::set_arrays(int i) {
  std::fill_n(array_atom[i], int{Wall::N_STATE}, 0.0);
  p_->wall.stepper.rows.clear(i);
}

int FixWallRebound::pack_exchange(int i, double *buffer) {
  std::copy_n(array_atom[i], int{Wall::N_STATE}, buffer);
  return Wall::N_STATE + p_->wall.stepper.rows.pack(i, buffer + Wall::N_STATE);
}

int FixWallRebound::unpack_exchange(int i, double *buffer) {
  std::copy_n(buffer, int{Wall::N_STATE}, array_atom[i]);
  return Wall::N_STATE + p_->wall.stepper.rows.unpack(i, buffer + Wall::N_STATE);
}

/* LAMMPS restart format: the length first, which counts itself. */
int FixWallRebound::pack_restart(int i, double *buffer) {
  const int count = 1 + pack_exchange(i, buffer + 1);
  buffer[0] = count;
  return count;
}

void FixWallRebound::unpack_restart(int i, int nth) {
  const double *saved = asperity::Memories::part(atom->extra[i], nth);
  unpack_exchange(i, const_cast<double *>(saved) + 1);
}

int FixWallRebound::size_restart(int i) {
  double packed[SAVED_MOST];
  return pack_restart(i, packed);
}

int FixWallRebound::maxsize_restart() {
  return SAVED_MOST;
}
