/* fix wall/rebound; see fix_wall_rebound.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fix_wall_rebound.h"

#include <string.h>
#include <algorithm>

#include "fix_property_global.h"
#include "fix_template_sphere.h"
#include "fix_wall_gran.h"
#include "dem/error.h"
#include "dem/shapes/primitive.h"
#include "dem/text.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using asperity::text;
using asperity::Words;

/* ---- making ---- */

FixWallRebound::FixWallRebound(LAMMPS *engine, int narg, char **arg)
    : WallHooks(engine, narg, arg), WallFix(engine, this), wall_type_(), is_set_up_(false) {
  check_id();
  check_atoms();
  attempt([&] {
    std::string geometry;
    Words words(narg - 3, arg + 3);
    read_geometry(words, geometry);
    check_meshes();
    wall.parse(words, geometry);
  });
  set_flags();
  add_rows();
}

FixWallRebound::~FixWallRebound() {
  remove_rows();
}

void FixWallRebound::read_geometry(Words &words, std::string &geometry) {
  if (words.done())
    throw asperity::Error("the wall is missing; it must be 'mesh n_meshes N meshes id1 ...' or "
                          "'primitive type T style args'");
  refuse_model(words);
  if (words.take("primitive")) {
    if (!words.take("type") || words.left() < 2)
      throw asperity::Error("behind 'primitive', 'type T style args' is expected");
    const int type = static_cast<int>(words.whole("the wall's type", 1, atom->ntypes));
    std::string shape;
    wall.add_shape(asperity::read_primitive(words, shape), type, 0, "");
    geometry = text("primitive type %d ", type) + shape;
    wall_type_[0] = wall_type_[1] = type;
  } else if (words.take("mesh"))
    geometry = read_meshes(words);
  else
    throw asperity::Error("the wall is '" + words.word("the wall") +
                          "'; it must be 'mesh' or 'primitive'");
  refuse_model(words);
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
    wall.add_shape(std::unique_ptr<asperity::Shape>(meshes_.back()), type, meshes_.back()->pieces(),
                   name);
    if (meshes_.back()->wears())
      throw asperity::Error("mesh '" + name +
                            "' has 'wear finnie', which would stay 0; leave it "
                            "out, and use this wall's 'erosion finnie FLOW_STRESS'");
    mesh_ids_.push_back(name);
    wall_type_[0] = m == 0 ? type : std::min(wall_type_[0], type);
    wall_type_[1] = std::max(wall_type_[1], type);
    geometry += " " + name;
  }
  return geometry;
}

int FixWallRebound::setmask() {
  return PRE_INITIAL_INTEGRATE | POST_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | PRE_FORCE |
         END_OF_STEP | POST_RUN;
}

void FixWallRebound::post_create() {
  if (modify->fix_restart_in_progress() && !wall.is_restored())
    warn_of_no_restart();
  for (MeshOfLiggghts *mesh : meshes_)
    if (strstr(mesh->fix()->style, "servo")) /* it counts what is near, by LIGGGHTS's own list */
      mesh->fix()->createWallNeighList(igroup);
}

void FixWallRebound::pre_delete(bool unfixflag) {
  if (unfixflag)
    report_loss();
  for (size_t m = 0; unfixflag && m < meshes_.size(); m++)
    if (modify->find_fix_id(mesh_ids_[m].c_str()) == meshes_[m]->fix()) {
      meshes_[m]->remove_sums();
      if (strstr(meshes_[m]->fix()->style, "servo"))
        meshes_[m]->fix()->deleteWallNeighList();
    }
}

/* ---- what the wall asks ---- */

std::string FixWallRebound::known_units() const {
  return "si, cgs or micro";
}

std::string FixWallRebound::constants(const char *name, bool pairs,
                                      std::vector<double> &values) const {
  const int n = atom->ntypes;
  const char *kind = pairs ? "peratomtypepair" : "peratomtype";
  Fix *found =
      modify->find_fix_property(name, "property/global", kind, n, pairs ? n : 0, style, false);
  values.clear();
  FixPropertyGlobal *property = static_cast<FixPropertyGlobal *>(found);
  for (int i = 0; found && i < n; i++)
    for (int j = 0; j < (pairs ? n : 1); j++)
      values.push_back(pairs ? property->compute_array(i, j) : property->compute_vector(i));
  return text("fix %s all property/global %s %s", name, name, kind) + (pairs ? text(" %d", n) : "");
}

/* A property of one number, such as the one that fix heat/gran makes. */
const double *FixWallRebound::numbers(const std::string &name) const {
  Fix *found =
      modify->find_fix_property(name.c_str(), "property/atom", "scalar", 0, 0, style, false);
  if (!found)
    throw asperity::Error("the numbers '" + name + "' do not exist; they must be of a 'fix " +
                          name + " all property/atom " + name +
                          " scalar ...', or 'Temp' of fix heat/gran");
  return found->vector_atom;
}

/* Of the group's particles, and of all that fixes will insert: their groups are those of templates,
 * which insertions do not tell. */
void FixWallRebound::diameters(double &least, double &most) const {
  least = most = 0;
  for (int i = 0; i < modify->nfix; i++)
    for (int type = 1; type <= atom->ntypes; type++) {
      const double small = 2 * modify->fix[i]->min_rad(type),
                   large = 2 * modify->fix[i]->max_rad(type);
      if (!(large > 0))
        continue;
      least = most > 0 ? std::min(least, small) : small;
      most = std::max(most, large);
    }
  asperity::add_diameters(EngineOf::spheres(), groupbit, Fix::world, least, most);
}

std::vector<asperity::Engine::Kind> FixWallRebound::kinds() const {
  std::vector<double> present(static_cast<size_t>(atom->ntypes), 0.);
  for (int i = 0; i < modify->nfix; i++)
    if (FixTemplateSphere *grain = dynamic_cast<FixTemplateSphere *>(modify->fix[i]))
      present[static_cast<size_t>(grain->maxtype() - 1)] = 1;
  return asperity::kinds_of(EngineOf::spheres(), groupbit, present, Fix::world);
}

int FixWallRebound::min_type() {
  return wall_type_[0];
}

int FixWallRebound::max_type() {
  return wall_type_[1];
}

/* ---- checks ---- */

/* In the place of a fix that is defined anew LIGGGHTS has nothing by now, and it has left the old
 * one's properties of atoms and meshes. */
void FixWallRebound::check_id() const {
  if (std::find(modify->fix, modify->fix + modify->nfix, static_cast<Fix *>(NULL)) !=
      modify->fix + modify->nfix)
    error->all(
        FLERR,
        "Fix wall/rebound: a wall with this ID exists; 'unfix' it before it is defined anew");
}

void FixWallRebound::check_atoms() const {
  check_particles(atom->ellipsoid_flag || atom->superquadric_flag || atom->shapetype_flag,
                  "granular' or 'sphere");
}

std::string FixWallRebound::body_error(const Fix *fix) const {
  if (strncmp(fix->style, "rigid", 5) != 0)
    return "";
  return text("fix %s (id %s) ties particles to bodies that cannot rebound; fix multisphere makes "
              "bodies that do",
              fix->style, fix->id);
}

/* Bodies rebound as a whole. */
void FixWallRebound::check_bodies() {
  bodies_.reset(new BodiesOfLiggghts(lmp));
  if (!bodies_->any())
    return;
  if (modify->n_fixes_style("multisphere") > 1 ||
      modify->n_fixes_style("multisphere/nointegration") > 0)
    fail("bodies must be those of one fix multisphere");
  wall.setup.check_bodies();
}

/* Fixes and meshes that the wall uses may have been deleted since. */
void FixWallRebound::check_meshes() const {
  for (size_t m = 0; m < meshes_.size(); m++)
    if (modify->find_fix_id(mesh_ids_[m].c_str()) != meshes_[m]->fix())
      fail("mesh '" + mesh_ids_[m] +
           "' has been deleted while this wall uses it; unfix the wall first");
  for (MeshOfLiggghts *mesh : meshes_)
    check_owner(mesh->fix());
}

/* A mesh of two walls would turn its particles round twice. */
void FixWallRebound::check_owner(const FixMeshSurface *mesh) const {
  for (int i = 0; i < modify->nfix; i++) {
    std::vector<FixMeshSurface *> theirs;
    if (FixWallRebound *other = dynamic_cast<FixWallRebound *>(modify->fix[i]))
      for (size_t k = 0; other != this && k < other->meshes_.size(); k++)
        theirs.push_back(other->meshes_[k]->fix());
    if (FixWallGran *other = dynamic_cast<FixWallGran *>(modify->fix[i]))
      theirs.assign(other->mesh_list(), other->mesh_list() + other->n_meshes());
    if (std::find(theirs.begin(), theirs.end(), mesh) != theirs.end())
      fail("mesh '" + std::string(mesh->id) + "' is already used by fix '" + modify->fix[i]->id +
           "'; there must be one wall for each mesh");
  }
}

/* ---- a run ---- */

void FixWallRebound::prepare() {
  check_meshes();
  check_bodies();
  for (MeshOfLiggghts *mesh : meshes_)
    if (mesh->fix()->triMesh()->prop().getGlobalProperty<ScalarContainer<double>>("Temp"))
      warn("mesh '" + std::string(mesh->fix()->id) +
           "' has a temperature; this wall conducts no heat, by 'fix heat/gran' or otherwise");
}

void FixWallRebound::set_up_shapes() {
  for (MeshOfLiggghts *mesh : meshes_) {
    const std::string report = mesh->setup(box());
    mesh->set_images(box());
    if (!report.empty())
      print("fix " + id() + " wall/rebound: " + report);
  }
}

void FixWallRebound::setup(int) {
  WallHooks::setup(0);
  is_set_up_ = true;
  show_maps();
}

/* All fixes have set up their forces. */
void FixWallRebound::pre_initial_integrate() {
  if (!is_set_up_)
    return;
  is_set_up_ = false;
  push_spheres();
  attempt([this] { push_bodies(); });
}

void FixWallRebound::begin_step() {
  for (MeshOfLiggghts *mesh : meshes_) {
    mesh->begin_step(update->dt);
    if (mesh->set_images(box()))
      wall.clear_ahead();
  }
}

/* Meshes that measure: LIGGGHTS has cleared their sums by now, and will use them after the forces.
 */
void FixWallRebound::pre_force(int) {
  for (MeshOfLiggghts *mesh : meshes_)
    if (mesh->measures())
      mesh->hand_over(update->dt);
}

void FixWallRebound::end_of_step() {
  WallHooks::end_of_step();
  if (is_output())
    show_maps();
}

void FixWallRebound::post_run() {
  show_maps();
  WallHooks::post_run();
}

void FixWallRebound::show_maps() {
  for (size_t m = 0; m < meshes_.size(); m++)
    wall.books.show_sums(m, [this, m](size_t first, const std::vector<double> &sums) {
      meshes_[m]->show(first, sums, wall.worn_density(m));
    });
}

void FixWallRebound::reset_timestep(bigint now, bigint before) {
  wall.setup.clock.step += static_cast<double>(now - before);
}
