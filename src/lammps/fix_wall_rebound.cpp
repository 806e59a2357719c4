/* fix wall/rebound; see fix_wall_rebound.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fix_wall_rebound.h"

#include "citeme.h"
#include "input.h"
#include "library.h"
#include "variable.h"

#include "bodies_lammps.h"
#include "driven_mesh.h"
#include "map_file.h"
#include "region_shape.h"

#include "contact/tolerances.h"
#include "contact/vector.h"
#include "dem/error.h"
#include "dem/shapes/primitive.h"
#include "dem/text.h"

#include <cctype>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

using namespace LAMMPS_NS;
using namespace FixConst;
using asperity::text;
using asperity::Words;

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
  bool from_restart;
  bool owes_bodies; /* the forces of walls, in the first step of a run */
  double stuck;     /* particles of all ranks, when a run began or ended */
  int type;         /* of the wall */

  Parts(LAMMPS *lammps, Fix *fix)
      : WallFix(lammps, fix), mesh(NULL), region(NULL), of_bodies(lammps, fix), last_step(0),
        from_restart(false), owes_bodies(false), stuck(0), type(0) {}

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
  void check_atoms() const override {
    const Atom *atom = program_->atom;
    check_particles(atom->ellipsoid_flag || atom->line_flag || atom->tri_flag || atom->body_flag,
                    "sphere");
    if (program_->kokkos && !lammps_config_accelerator("KOKKOS", "precision", "double"))
      fail("the package KOKKOS was built with single or mixed precision; it must be double");
  }
  void prepare() override;
  void set_up_shapes() override;
  void begin_step() override;
  void follow_step(bigint last);
};

/* ---- making ---- */

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
  maxexchange = SENT_MOST;
  comm_forward = BodiesOfLammps::SENT;
  add_rows();
}

FixWallRebound::~FixWallRebound() {
  /* By a command of the script that names this fix, and not with all others at the end. */
  if (update && input->narg > 0 && strcmp(input->arg[0], id) == 0)
    p_->report_loss();
  remove_rows();
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
    if (words.left() > 1 && strncmp(words.left_over()[1], "v_", 2) == 0)
      throw asperity::Error(text("the place of '%s' is '%s'; it must be a number",
                                 words.left_over()[0], words.left_over()[1]) +
                            MOVES);
    std::unique_ptr<asperity::Shape> shape = asperity::read_primitive(words, geometry);
    if (words.is_one_of("wiggle move rotate"))
      throw asperity::Error("'" + words.word("") + "' is unknown behind '" + geometry + "'" +
                            MOVES);
    p_->type = read_type(words);
    geometry += text(" type %d", p_->type);
    if (!words.done() && (words.is("NULL") || isdigit(words.left_over()[0][0])))
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
  return POST_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | END_OF_STEP | POST_RUN;
}

/* ---- a run ---- */

void FixWallRebound::Parts::prepare() {
  const Update *update = program_->update;
  if (from_restart && !wall.is_restored())
    warn_of_no_restart();
  from_restart = false;
  follow_step(update->ntimestep);
  stuck = wall.stuck();
  if (region)
    region->init();
  of_bodies.init();
  owes_bodies = !of_bodies.stand_before(fix_);
  int &stages = program_->modify->fmask[program_->modify->find_fix(fix_->id)];
  stages = owes_bodies ? stages | INITIAL_INTEGRATE : stages & ~INITIAL_INTEGRATE;
  if (of_bodies.any())
    wall.setup.check_bodies();
}

/* The command reset_timestep tells no fix, and a `run pre no` may follow it. */
void FixWallRebound::Parts::follow_step(bigint last) {
  if (last != last_step)
    wall.setup.clock.step += static_cast<double>(last - last_step);
  last_step = last;
}

void FixWallRebound::Parts::set_up_shapes() {
  const double now = wall.setup.time(static_cast<double>(program_->update->ntimestep));
  const double off = region ? region->setup() : mesh ? mesh->setup(now) : 0;
  const asperity::Bounds all = bounds();
  double size[3];
  aspi_subtract(all.hi, all.lo, size);
  if (off > asperity::ROUNDING * aspi_length(size))
    warn(text("the %s stands %.4g from where the last step has left it; what lies between "
              "is passed without a contact. Its variables must go on from run to run: by "
              "'time', not by 'step*dt' behind the command timestep",
              region ? "region" : "mesh", off));
  if (mesh)
    mesh->set_images(box());
}

void FixWallRebound::setup(int) {
  WallHooks::setup(0);
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
  follow_step(update->ntimestep - 1);
  last_step = update->ntimestep;
  wall.setup.box = box();
  if (region)
    region->begin_step();
  if (mesh) {
    mesh->begin_step(wall.setup.time(static_cast<double>(update->ntimestep)), update->dt);
    if (mesh->set_images(box()))
      wall.clear_ahead();
  }
}

void FixWallRebound::end_of_step() {
  WallHooks::end_of_step();
  if (p_->mesh && p_->map.is_due(update->ntimestep))
    p_->attempt([this] {
      p_->map.write(world, update->ntimestep, p_->time(), p_->mesh->triangles(),
                    p_->mesh->motion().end(), p_->wall.books.sums(0), p_->wall.worn_density(0));
    });
}

void FixWallRebound::post_run() {
  p_->stuck = p_->wall.stuck();
  WallHooks::post_run();
}

/* ---- output and restart ---- */

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
