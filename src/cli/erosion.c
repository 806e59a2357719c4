/* asperity erosion: what the impacts of a ledger wore off the wall, per triangle, per mesh and in
 * all: its own column added up, or a law applied to its rows.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/description.h"
#include "cli/plot.h"
#include "cli/scatter.h"
#include "description/description.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A triangle and its sums. */
typedef struct cell {
  int mesh, triangle;
  double impacts, mass;
} cell;

typedef struct wear {
  cell *cells;
  size_t count, room;
  const char *path;
  const aspi_erosion *law; /* NULL: the ledger's own column */
  double wall_density;     /* 0: the law has it */
  double density;          /* of the particles; NAN: the ledger has their mass */
  bool has_mass;
} wear;

static int by_place(const void *left, const void *right) {
  const cell *a = left, *b = right;
  return a->mesh != b->mesh ? (a->mesh > b->mesh) - (a->mesh < b->mesh)
                            : (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

/* Sorts the cells and makes one of those of a triangle. */
static void merge(wear *w) {
  size_t last = 0;
  if (w->count == 0)
    return;
  qsort(w->cells, w->count, sizeof *w->cells, by_place);
  for (size_t i = 1; i < w->count; i++)
    if (by_place(&w->cells[last], &w->cells[i]) == 0) {
      w->cells[last].impacts += w->cells[i].impacts;
      w->cells[last].mass += w->cells[i].mass;
    } else {
      w->cells[++last] = w->cells[i];
    }
  w->count = last + 1;
}

/* Room for one more cell: by merging, and twice as much where that frees less than half. */
static void make_room(wear *w) {
  if (w->count < w->room)
    return;
  merge(w);
  if (2 * w->count < w->room)
    return;
  size_t room = w->room ? 2 * w->room : 4096;
  cell *cells = cli_allocate(room, sizeof *cells);
  if (w->count)
    memcpy(cells, w->cells, w->count * sizeof *cells);
  free(w->cells);
  w->cells = cells;
  w->room = room;
}

static double worn_by_law(const wear *w, const double of[], double mass) {
  double alpha = aspi_radians(of[ALPHA1]);
  return mass *
         aspi_erosion_ratio(w->law, w->wall_density, of[V1], sin(alpha), cos(alpha), of[D_P]);
}

static void add_row(wear *w, const double of[]) {
  double mass = of[MASS], d = of[D_P];
  w->has_mass = !isnan(mass);
  if (!w->has_mass)
    mass = w->density * ASP_PI / 6 * d * d * d;
  if (w->law && isnan(mass))
    cli_bad_usage("%s: no column 'mass', which 'columns full' has: give the density of the "
                  "particles by --density or 'materials'",
                  w->path);
  double worn = w->law ? worn_by_law(w, of, mass) : of[ERODED];
  make_room(w);
  w->cells[w->count++] = (cell){(int)of[MESH], (int)of[TRIANGLE], 1, worn};
}

/* Adds up the rows of the ledger. */
static void read_ledger(wear *w) {
  static const int by_law[] = {MESH, TRIANGLE, ALPHA1, V1, D_P}, own[] = {MESH, TRIANGLE, ERODED};
  cli_scatter ledger = cli_scatter_open(w->path, SCATTER_COLUMNS);
  for (int i = 0; i < (w->law ? 5 : 3); i++)
    cli_scatter_need(&ledger, w->law ? by_law[i] : own[i],
                     w->law || i < 2 ? ""
                                     : "; a ledger has it with 'columns full', or state 'erosion "
                                       "LAW' behind it");
  if (!w->law && *ledger.csv->comment && !strstr(ledger.csv->comment, " erosion "))
    cli_bad_usage("%s: its wall has no 'erosion', so its eroded mass is 0; state the law behind it",
                  w->path);
  double of[SCATTER_COLUMNS];
  while (cli_scatter_row(&ledger, of))
    add_row(w, of);
  merge(w);
}

static void print_sum(FILE *out, const cell *sum) {
  fprintf(out, "%.0f,%.10g\n", sum->impacts, sum->mass);
}

static void print_all(FILE *out, const wear *w) {
  cell mesh = {.mesh = 0}, all = {.mesh = 0};
  fputs("mesh,triangle,impacts,eroded_mass_kg\n", out);
  for (size_t i = 0; i < w->count; i++) {
    const cell *c = &w->cells[i];
    fprintf(out, "%d,%d,", c->mesh, c->triangle);
    print_sum(out, c);
    mesh.impacts += c->impacts;
    mesh.mass += c->mass;
    if (i + 1 < w->count && c[1].mesh == c->mesh)
      continue;
    fprintf(out, "%d,all,", c->mesh);
    print_sum(out, &mesh);
    all.impacts += mesh.impacts;
    all.mass += mesh.mass;
    mesh = (cell){.mesh = 0};
  }
  fputs("all,all,", out);
  print_sum(out, &all);
}

/* The law, and what it needs besides the rows. */
static void take_law(wear *w, cli_description *d) {
  cli_description_allow(d, "erosion materials", "the law of erosion is applied to a ledger's rows");
  w->law = &d->words->choice.erosion;
  if (!w->law->law)
    cli_bad_usage("erosion: 'erosion LAW' is expected among the words behind LEDGER; see 'asperity "
                  "help wall'");
  if (w->law->tilted)
    cli_bad_usage("face is 'tilted'; it must be mean: a ledger does not have every face that was "
                  "hit, but in its column 'eroded_mass'");
  w->wall_density = asp_material_get(d->target, "density");
  if (isnan(w->density) && !d->has_standard_materials)
    w->density = d->density;
  cli_description_doubt(d, 0, 0);
}

static void run(cli_call *call) {
  if (call->n_words < 1)
    cli_bad_usage("erosion: LEDGER is expected, a file; see 'asperity erosion --help'");
  const cli_option *density = cli_get(call, "density");
  wear w = {.path = call->words[0], .density = NAN};
  bool has_law = call->n_words > 1;
  if (density->value && !has_law)
    cli_bad_usage("--density has no effect without 'erosion LAW'");
  if (density->value)
    w.density = cli_quantity(density, "density", 1e-9, 1e9);
  cli_description d = {.wall = NULL};
  if (has_law) {
    d = cli_description_read(call->n_words - 1, call->words + 1, false);
    take_law(&w, &d);
  }
  read_ledger(&w);
  if (density->value && w.has_mass)
    cli_bad_usage("--density has no effect: %s has the particles' mass", w.path);
  FILE *out = cli_table_open(call, d.text);
  print_all(out, &w);
  cli_table_close(call, out, "erosion");
}

static const cli_option options[] = {
    {"density", "DENSITY",
     "density of the particles, if the ledger has no mass; else that of 'materials'", NULL},
    {.name = NULL}};

static const char detail[] =
    "LEDGER is the ledger of a wall. The output has a row per triangle that was hit, a "
    "row per mesh\n"
    "(triangle `all`), and one for all meshes; a primitive wall is mesh 0. Without a\n"
    "description the command adds up the ledger's column eroded_mass; a wall with `erosion`\n"
    "and `ledger ... columns full` writes it. With `erosion LAW ...` it applies the law to\n"
    "impact angle, speed and diameter of the rows, on the mean wall: a ledger has only the\n"
    "first of the faces that `face tilted` needs. The particles' mass is the column mass,\n"
    "or that of a sphere of --density. Ledgers are converted from their units to SI.\n";

const cli_command cli_erosion = {
    .name = "erosion",
    .arguments = "LEDGER [DESCRIPTION]",
    .summary = "the mass that the impacts of a ledger wore off the wall, per triangle",
    .detail = detail,
    .examples = "  $ asperity erosion impacts.csv -o eroded.csv\n"
                "  $ asperity erosion impacts.csv erosion oka 1.8GPa density 7850kg/m3 "
                "--density 2650kg/m3\n",
    .options = options,
    .picture = "draw the mass worn off each triangle; .png, .svg or .pdf",
    .run = run,
};
