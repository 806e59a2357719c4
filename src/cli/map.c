/* asperity map: where a wall is hit, fouled and worn, face by face, from the ledger of a run and
 * the wall's mesh, or from the map that an engine writes: a table, a file for ParaView, a picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/map.h"
#include "cli/description.h"
#include "cli/scatter.h"
#include "contact/tree.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define AWAY_MOST 0.1 /* of the impacts: outside of the mesh's box by more than a diameter */

/* An impact of the ledger. */
typedef struct hit {
  double x[3], d_p, v1, mass, eroded;
  int mesh, triangle;
  bool stuck;
} hit;

typedef struct study {
  const char *ledger, *mesh;
  aspi_faces *faces;
  hit *hits;
  size_t n;
  double density, wall_density; /* NAN: unknown */
} study;

/* ---- the ledger ---- */

static void read_ledger(study *s) {
  static const int needed[] = {MESH, TRIANGLE, D_P, V1, OUTCOME, PLACE, PLACE + 1, PLACE + 2};
  double v[SCATTER_COLUMNS];
  cli_scatter ledger = cli_scatter_open(s->ledger, SCATTER_COLUMNS);
  for (size_t i = 0; i < sizeof needed / sizeof *needed; i++)
    cli_scatter_need(&ledger, needed[i], "; a ledger of a wall's impacts is expected");
  cli_ledger_densities(ledger.table->header, &s->density, &s->wall_density);
  while (cli_scatter_row(&ledger, v)) {
    double mass = isnan(v[MASS]) ? s->density * ASP_SPHERE_VOLUME(v[D_P]) : v[MASS];
    s->hits = cli_grow(s->hits, s->n, sizeof *s->hits);
    s->hits[s->n++] = (hit){.x = {v[PLACE], v[PLACE + 1], v[PLACE + 2]},
                            .d_p = v[D_P],
                            .v1 = v[V1],
                            .mass = mass,
                            .eroded = v[ERODED],
                            .mesh = (int)v[MESH],
                            .triangle = (int)v[TRIANGLE],
                            .stuck = v[OUTCOME] > 0};
  }
  if (s->n == 0)
    cli_bad_usage("%s: no impacts; there is nothing to draw", s->ledger);
}

/* Keeps the impacts on one mesh: that of the option, or the only one. */
static void choose_mesh(study *s, const cli_option *option) {
  int mesh = option->value ? (int)cli_whole(option, 0, 1000000000) : s->hits[0].mesh;
  size_t kept = 0;
  for (size_t i = 0; i < s->n; i++)
    if (s->hits[i].mesh == mesh)
      s->hits[kept++] = s->hits[i];
    else if (!option->value)
      cli_bad_usage("%s has impacts on mesh %d and mesh %d; choose that of %s by --mesh", s->ledger,
                    mesh, s->hits[i].mesh, s->mesh);
  if (kept == 0)
    cli_bad_usage("--mesh is %d; %s has no impact on it", mesh, s->ledger);
  s->n = kept;
}

/* ---- impacts on faces ---- */

/* Warns where the impacts are not in the box around the mesh. */
static void check_places(const study *s) {
  double box[2][3] = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
  size_t away = 0;
  for (size_t i = 0; i < 9 * s->faces->triangles; i++) {
    double x = s->faces->triangle[i / 9].node[i / 3 % 3][i % 3];
    box[0][i % 3] = fmin(box[0][i % 3], x);
    box[1][i % 3] = fmax(box[1][i % 3], x);
  }
  for (size_t i = 0; i < s->n; i++) {
    const hit *h = &s->hits[i];
    bool out = false;
    for (int k = 0; k < 3; k++)
      out = out || h->x[k] < box[0][k] - h->d_p || h->x[k] > box[1][k] + h->d_p;
    away += out;
  }
  if ((double)away > AWAY_MOST * (double)s->n)
    cli_warn("%zu of %zu impacts are outside of %s, x %.4g to %.4g m, y %.4g to %.4g m, z %.4g to "
             "%.4g m: is --scale right (1e-3 for a mesh in mm), and the mesh at rest?",
             away, s->n, s->mesh, box[0][0], box[1][0], box[0][1], box[1][1], box[0][2], box[1][2]);
}

/* True if the ledger has no numbers of triangles, as that of OpenFOAM. */
static bool lacks_numbers(const study *s) {
  for (size_t i = 0; i < s->n; i++)
    if (s->hits[i].triangle > 0)
      return false;
  return true;
}

static int nearest_face(const study *s, const ContactTree *tree, const hit *h) {
  int place;
  aspi_tree_distance(tree, h->x, INFINITY, &place);
  return s->faces->face[aspi_tree_id(tree, place)];
}

static ContactTree *tree_of(const aspi_faces *faces) {
  ContactTree *tree = cli_made(aspi_tree_begin());
  for (size_t i = 0; i < faces->triangles; i++)
    if (!aspi_tree_add(tree, &faces->triangle[i], (int)i))
      cli_fail("out of memory for %zu triangles", faces->triangles);
  if (!aspi_tree_finish(tree))
    cli_fail("out of memory for %zu triangles", faces->triangles);
  return tree;
}

/* Adds up the impacts on each face, in place of what the map lacks. */
static void add_up(study *s) {
  aspi_faces *f = s->faces;
  ContactTree *tree = lacks_numbers(s) ? tree_of(f) : NULL;
  double(*sum)[ASPI_FACE_FIELDS] = cli_allocate(f->count, sizeof *sum);
  double no_mass = 0, no_wear = 0;
  for (size_t i = 0; i < s->n; i++) {
    const hit *h = &s->hits[i];
    int at = tree ? nearest_face(s, tree, h) : h->triangle;
    if (at < 0 || (size_t)at >= f->count)
      cli_bad_usage(
          "%s has an impact on triangle %d; %s has the triangles 0 to %zu: it must be the "
          "mesh of the run",
          s->ledger, at, s->mesh, f->count - 1);
    sum[at][ASPI_FACE_IMPACTS]++;
    sum[at][ASPI_FACE_DEPOSITED] += h->stuck ? h->mass : 0;
    sum[at][ASPI_FACE_ERODED] += h->eroded;
    sum[at][ASPI_FACE_SPEED] += h->v1;
    no_mass += h->stuck ? 0 * h->mass : 0; /* NAN where a mass is unknown */
    no_wear += 0 * h->eroded;
  }
  for (size_t i = 0; i < f->count; i++) {
    sum[i][ASPI_FACE_DEPOSITED] += no_mass;
    sum[i][ASPI_FACE_ERODED] += no_wear;
    sum[i][ASPI_FACE_DEPTH] = sum[i][ASPI_FACE_ERODED] / (s->wall_density * f->area[i]);
    sum[i][ASPI_FACE_SPEED] /= sum[i][ASPI_FACE_IMPACTS];
    for (int k = 0; k < ASPI_FACE_FIELDS; k++)
      f->value[i][k] = isnan(f->value[i][k]) ? sum[i][k] : f->value[i][k];
  }
  free(sum);
  aspi_tree_free(tree);
}

/* ---- output ---- */

static bool is_vtk(const char *path) {
  const char *ending = path ? strrchr(path, '.') : NULL;
  if (ending && strcmp(ending, ".vtp") == 0)
    cli_bad_usage("--output is '%s'; for ParaView it must end in .vtk", path);
  return ending && strcmp(ending, ".vtk") == 0;
}

static bool is_known(const aspi_faces *f, int field) {
  for (size_t i = 0; i < f->count; i++)
    if (isfinite(f->value[i][field]))
      return true;
  return false;
}

/* The triangles and their faces' values as VTK's legacy PolyData. */
static void write_vtk(FILE *out, const aspi_faces *f) {
  fprintf(out,
          "# vtk DataFile Version 3.0\nasperity map\nASCII\nDATASET POLYDATA\nPOINTS %zu double\n",
          3 * f->triangles);
  for (size_t i = 0; i < 3 * f->triangles; i++) {
    const double *node = f->triangle[i / 3].node[i % 3];
    fprintf(out, "%.9g %.9g %.9g\n", node[0], node[1], node[2]);
  }
  fprintf(out, "POLYGONS %zu %zu\n", f->triangles, 4 * f->triangles);
  for (size_t i = 0; i < f->triangles; i++)
    fprintf(out, "3 %zu %zu %zu\n", 3 * i, 3 * i + 1, 3 * i + 2);
  fprintf(out, "CELL_DATA %zu\nSCALARS id int 1\nLOOKUP_TABLE default\n", f->triangles);
  for (size_t i = 0; i < f->triangles; i++)
    fprintf(out, "%d\n", f->face[i]);
  for (int k = 0; k < ASPI_FACE_FIELDS; k++) {
    if (!is_known(f, k))
      continue;
    fprintf(out, "SCALARS %s double 1\nLOOKUP_TABLE default\n", aspi_face_names[k][0]);
    for (size_t i = 0; i < f->triangles; i++)
      fprintf(out, "%.9g\n", f->value[f->face[i]][k]);
  }
}

static void write_table(FILE *out, const aspi_faces *f) {
  double(*x)[3] = cli_allocate(f->count, sizeof *x);
  for (size_t i = 0; i < f->triangles; i++)
    for (int k = 0; k < 9; k++)
      x[f->face[i]][k % 3] += f->triangle[i].node[k / 3][k % 3] / 3 *
                              aspi_triangle_area(&f->triangle[i]) / f->area[f->face[i]];
  fputs("triangle,x_m,y_m,z_m,area_m2,impacts,deposited_mass_kg,eroded_mass_kg,erosion_depth_m,"
        "impact_speed_m_s\n",
        out);
  for (size_t i = 0; i < f->count; i++)
    cli_row(out, "%zu,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", i, x[i][0], x[i][1], x[i][2],
            f->area[i], f->value[i][0], f->value[i][1], f->value[i][2], f->value[i][3],
            f->value[i][4]);
  free(x);
}

/* ---- the picture ---- */

/* A field that a picture shows, per area or not, in the first of its units in which the largest
 * value is LEGIBLE or more. `hint`: why it may be unknown. */
#define LEGIBLE 0.1
enum { UNITS_MOST = 5 };
typedef struct quantity {
  aspi_of_face field;
  bool per_area;
  const char *label;
  struct {
    const char *name;
    double factor;
  } units[UNITS_MOST];
  const char *hint;
} quantity;

static const quantity quantities[] = {
    {ASPI_FACE_IMPACTS, true, "impacts", {{"/ mm^2", 1e-6}, {"/ cm^2", 1e-4}, {"/ m^2", 1}}, ""},
    {ASPI_FACE_DEPOSITED,
     true,
     "deposits in",
     {{"kg/m^2", 1}, {"g/m^2", 1e3}, {"mg/m^2", 1e6}, {"µg/m^2", 1e9}},
     "state the density of the particles by --density"},
    {ASPI_FACE_ERODED,
     true,
     "wear in",
     {{"kg/m^2", 1}, {"g/m^2", 1e3}, {"mg/m^2", 1e6}, {"µg/m^2", 1e9}},
     "the wall has no erosion, or the ledger not its 'columns full'"},
    {ASPI_FACE_SPEED, false, "mean speed of impact in", {{"m/s", 1}}, "a ledger has it"},
    {ASPI_FACE_DEPTH,
     false,
     "depth of wear in",
     {{"mm", 1e3}, {"µm", 1e6}, {"nm", 1e9}, {"pm", 1e12}, {"fm", 1e15}},
     ""}};

/* The quantity of the option `of`; wear is a depth where the wall's density is known. */
static const quantity *quantity_of(const cli_call *call, const aspi_faces *f) {
  const quantity *q = &quantities[cli_choice(cli_get(call, "of"))];
  q = q->field == ASPI_FACE_ERODED && is_known(f, ASPI_FACE_DEPTH) ? &quantities[4] : q;
  if (!is_known(f, q->field))
    cli_bad_usage("--of is '%s', which is not known: %s", cli_value(call, "of"), q->hint);
  return q;
}

/* The values of the faces in the best unit. */
static void scale_values(cli_map *map, const quantity *q) {
  const aspi_faces *f = map->faces;
  double most = 0;
  int unit = 0;
  map->value = cli_allocate(f->count, sizeof *map->value);
  for (size_t i = 0; i < f->count; i++) {
    double value = f->value[i][q->field] / (q->per_area ? f->area[i] : 1);
    map->value[i] = isfinite(value) ? value : NAN;
    most = fmax(most, map->value[i]);
  }
  while (unit + 1 < UNITS_MOST && q->units[unit + 1].name && most * q->units[unit].factor < LEGIBLE)
    unit++;
  for (size_t i = 0; i < f->count; i++)
    map->value[i] *= q->units[unit].factor;
  snprintf(map->label, sizeof map->label, "%s %s", q->label, q->units[unit].name);
}

static void draw(const cli_call *call, const study *s) {
  cli_map map = {.faces = s->faces, .deposits = NULL};
  for (size_t i = 0; i < s->n; i++)
    if (s->hits[i].stuck) {
      map.deposits = cli_grow(map.deposits, map.n_deposits, sizeof *map.deposits);
      cli_deposit *to = &map.deposits[map.n_deposits++];
      memcpy(to->x, s->hits[i].x, sizeof to->x);
      to->d_p = s->hits[i].d_p;
    }
  scale_values(&map, quantity_of(call, s->faces));
  cli_map_draw(call, &map);
}

static void run(cli_call *call) {
  if (call->n_words < 1 || call->n_words > 2)
    cli_bad_usage("map: LEDGER and MESH are expected, or MAP alone; see 'asperity map --help'");
  const char *output = cli_value(call, "output");
  const cli_option *density = cli_get(call, "density");
  const bool vtk = is_vtk(output);
  study s = {.ledger = call->n_words > 1 ? call->words[0] : NULL,
             .mesh = call->words[call->n_words - 1],
             .density = NAN,
             .wall_density = NAN};
  double scale = cli_number(cli_get(call, "scale"), 1e-12, 1e12);
  s.faces = cli_made(aspi_faces_read(s.mesh, scale, &cli_error));
  if (s.ledger) {
    if (density->value)
      s.density = cli_quantity(density, "density", 1e-9, 1e9);
    read_ledger(&s);
    if (cli_value(call, "mesh") || !lacks_numbers(&s))
      choose_mesh(&s, cli_get(call, "mesh"));
    check_places(&s);
    add_up(&s);
  } else if (!is_known(s.faces, ASPI_FACE_IMPACTS) && !is_known(s.faces, ASPI_FACE_DEPOSITED)) {
    cli_bad_usage("%s has no map of impacts; a ledger is expected before it", s.mesh);
  }
  if (output || !cli_value(call, "plot")) {
    FILE *out = vtk ? cli_file_open(output) : cli_output_open(call, "output", NULL);
    (vtk ? write_vtk : write_table)(out, s.faces);
    cli_file_close(out);
  }
  if (cli_value(call, "plot"))
    draw(call, &s);
}

static const cli_option options[] = {
    {"of", "impacts|deposits|wear|speed", "what the picture shows", "impacts"},
    {"scale", "S", "meters of one unit of the mesh: 1e-3 for mm", "1"},
    {"mesh", "N", "number of the mesh in a ledger of several", NULL},
    {"density", "DENSITY", "of the particles; else that of the ledger's materials", NULL},
    {"most", "VALUE", "end of the color bar, in its unit; else the largest value", NULL},
    {"view", "AZ,EL", "from where the picture is taken, in degrees: around z from x, and above it",
     "-60,30"},
    {"clip", "AXIS:FROM:TO", "shows what lies between, as y:0: or z:-1mm:1mm", "x::"},
    {.name = NULL}};

static const char detail[] =
    "LEDGER is the ledger of a wall, MESH its STL file. A ledger of OpenFOAM has no\n"
    "numbers of triangles: an impact counts for the nearest one. MAP is what an engine\n"
    "writes, as text: a .vtp of LAMMPS's `map`, a .vtk of LIGGGHTS's `dump mesh/vtk` or of\n"
    "OpenFOAM's surfaces. With a ledger before it, its deposits are drawn on it.\n"
    "The output has a row per triangle; with a name that ends in .vtk it is a file for\n"
    "ParaView. The picture has a color by area, and deposits as dots, larger for larger\n"
    "particles; faces hide those behind them. Cut a closed wall open by --clip.\n";

const cli_command cli_map_command = {
    .name = "map",
    .arguments = "LEDGER MESH | MAP",
    .takes_files = true,
    .summary = "where a wall is hit, fouled and worn: a picture, a table, a file for ParaView",
    .detail = detail,
    .examples = "  $ asperity map impacts.csv blade.stl --plot map.png\n"
                "  $ asperity map impacts.csv bend.stl --scale 1e-3 --of wear --clip y:0: \\\n"
                "    --view -90,0 --plot wear.png -o wear.vtk\n"
                "  $ asperity map map.30000.vtk --of deposits --plot deposits.png\n",
    .options = options,
    .picture = "draw the wall in space",
    .run = run,
};
