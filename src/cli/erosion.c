/* asperity erosion: what the impacts of a ledger wore off the wall, per triangle, per mesh and in
 * all: its own column added up, or a law applied to its rows.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/description.h"
#include "cli/cli.h"
#include "cli/scatter.h"
#include "description/description.h"

#include <math.h>
#include <string.h>

/* Impacts per block, at least. */
enum { CELLS_LEAST = 1 << 16 };

/* Eroded mass of one impact, or of all impacts on a triangle. */
typedef struct cell {
  int mesh, triangle;
  double impacts, mass;
} cell;

typedef struct wear {
  cell *cells;
  size_t count, most; /* cells, and how many before they are merged */
  const char *path;
  cli_scatter ledger;
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

static void add(void *fields, const void *with) {
  cell *to = fields;
  const cell *more = with;
  to->impacts += more->impacts;
  to->mass += more->mass;
}

/* Merges the cells of each triangle, and sorts them. */
static void merge(wear *w) {
  w->count = aspi_merge_equal(w->cells, w->count, sizeof *w->cells, by_place, add);
}

static double worn_by_law(const wear *w, const double fields[], double mass) {
  double alpha = aspi_radians(fields[ALPHA1]);
  return mass * aspi_erosion_ratio(w->law, w->wall_density, fields[V1], sin(alpha), cos(alpha),
                                   fields[D_P]);
}

static void add_row(wear *w, const double fields[]) {
  double mass = fields[MASS];
  w->has_mass = !isnan(mass);
  if (!w->has_mass)
    mass = w->density * ASP_SPHERE_VOLUME(fields[D_P]);
  if (w->law && isnan(mass))
    cli_bad_usage("%s: no column 'mass', which 'columns full' has: give the density of the "
                  "particles by --density or 'materials'",
                  w->path);
  double worn = w->law ? worn_by_law(w, fields, mass) : fields[ERODED];
  if (w->count == w->most) {
    merge(w);
    w->most = 2 * w->count > CELLS_LEAST ? 2 * w->count : CELLS_LEAST;
  }
  w->cells = cli_grow(w->cells, w->count, sizeof *w->cells);
  w->cells[w->count++] = (cell){(int)fields[MESH], (int)fields[TRIANGLE], 1, worn};
}

/* Adds up the rows of the ledger. */
static void read_ledger(wear *w) {
  static const int by_law[] = {MESH, TRIANGLE, ALPHA1, V1, D_P}, own[] = {MESH, TRIANGLE, ERODED};
  cli_scatter ledger = w->ledger;
  for (int i = 0; i < (w->law ? 5 : 3); i++)
    cli_scatter_need(&ledger, w->law ? by_law[i] : own[i],
                     w->law || i < 2 ? ""
                                     : "; a ledger has it with 'columns full', or state 'erosion "
                                       "LAW' behind it");
  const char *header = ledger.table->header;
  if (!w->law && *header == '#' && !strstr(header, " erosion "))
    cli_bad_usage("%s: its wall has no 'erosion', so its eroded mass is 0; state the law behind it",
                  w->path);
  double fields[SCATTER_COLUMNS];
  while (cli_scatter_row(&ledger, fields))
    add_row(w, fields);
  merge(w);
}

static void print_sum(FILE *out, const char *mesh, const char *triangle, const cell *sum) {
  fprintf(out, "%s,%s,%.0f,%.10g\n", mesh, triangle, sum->impacts, sum->mass);
}

static void print_all(FILE *out, const wear *w) {
  cell mesh = {.mesh = 0}, all = {.mesh = 0};
  fputs("mesh,triangle,impacts,eroded_mass_kg\n", out);
  for (const cell *c = w->cells, *end = c + w->count; c < end; c++) {
    char names[2][16];
    snprintf(names[0], sizeof names[0], "%d", c->mesh);
    snprintf(names[1], sizeof names[1], "%d", c->triangle);
    print_sum(out, names[0], names[1], c);
    add(&mesh, c);
    if (c + 1 < end && c[1].mesh == c->mesh)
      continue;
    print_sum(out, names[0], "all", &mesh);
    add(&all, &mesh);
    mesh = (cell){.mesh = 0};
  }
  print_sum(out, "all", "all", &all);
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
  if (isnan(w->density) && !d->has_default_materials)
    w->density = d->density;
  cli_description_doubt(d, 0, 0);
}

/* The clause of a canonical text that begins with a word. */
static const char *clause_of(char *text, const char *word) {
  while (strncmp(text, word, strlen(word)) != 0)
    text += asp_description_clause(text);
  size_t length = asp_description_clause(text);
  text[length - (length > 0 && text[length - 1] == ' ')] = '\0';
  return text;
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
  w.ledger = cli_scatter_open(w.path, PLACE);
  if (has_law) {
    char **words = call->words + 1;
    int count = cli_ledger_words(w.ledger.table->header, call->n_words - 1, &words);
    d = cli_description_read(count, words, false);
    take_law(&w, &d);
  }
  read_ledger(&w);
  if (density->value && w.has_mass)
    cli_bad_usage("--density has no effect: %s has the particles' mass", w.path);
  FILE *out = cli_output_open(call, "output", has_law ? clause_of(d.text, "erosion") : NULL);
  print_all(out, &w);
  cli_file_close(out);
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
    "or that of a sphere of --density. Densities that are not stated are those of the two\n"
    "materials in the ledger's heading. Ledgers are converted from their units to SI.\n";

const cli_command cli_erosion = {
    .name = "erosion",
    .arguments = "LEDGER [DESCRIPTION]",
    .summary = "the mass that the impacts of a ledger wore off the wall, per triangle",
    .detail = detail,
    .examples = "  $ asperity erosion impacts.csv -o eroded.csv\n"
                "  $ asperity erosion impacts.csv erosion oka 1.8GPa density 7850kg/m3 "
                "--density 2650kg/m3\n",
    .options = options,
    .run = run,
};
