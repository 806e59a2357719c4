/* Memory that runs out ends no caller: every allocation of every entry point that allocates is made
 * to fail in turn, in a process of its own, and the answer is the code ASP_ENOMEM with a message,
 * or the same result where the C library did without that piece of memory. GSL keeps its default
 * error handler, which aborts.
 *
 * The allocation functions are defined here in place of the C library's (glibc's names), so that
 * those of GSL and of stdio fail, too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "gauss_map.h"
#include "spread/flight.h"
#include "wall/wall.h"
#include "surface/ball.h"
#include "surface/rolling.h"
#include "surface/describe.h"
#include "readers/read.h"
#include "rebound/cor_table.h"
#include "rebound/materials.h"
#include "surface/size_law.h"
#include "surface/slopes.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *memory, size_t size);

/* While armed, allocations are counted, and those of numbers first_bad to last_bad fail. */
static volatile int armed;
static long seen, first_bad, last_bad;

static int fails(void) {
  if (!armed || ++seen < first_bad || seen > last_bad)
    return 0;
  errno = ENOMEM;
  return 1;
}

void *malloc(size_t size) {
  return fails() ? NULL : __libc_malloc(size);
}

void *calloc(size_t count, size_t size) {
  return fails() ? NULL : __libc_calloc(count, size);
}

void *realloc(void *memory, size_t size) {
  return fails() ? NULL : __libc_realloc(memory, size);
}

static asp_heights *profile, *gauss; /* a profile, and a map */
static asp_surface *surface;

/* What an entry point gives: a code, or the code that goes with a NULL. */
typedef asp_code (*entry)(asp_error *error);

typedef struct listed {
  const char *name;
  entry call;
} listed;
static listed entries[64];
static size_t count;

/* Defines and lists one; MAKES one that gives the code of what an expression with `error` makes. */
#define ENTRY(name)                                                                                \
  static asp_code name(asp_error *error);                                                          \
  __attribute__((constructor)) static void list_##name(void) {                                     \
    entries[count++] = (listed){#name, name};                                                      \
  }                                                                                                \
  static asp_code name(asp_error *error)
#define MAKES(name, type, made, release)                                                           \
  ENTRY(name) {                                                                                    \
    type *is = made;                                                                               \
    asp_code code = is ? ASP_OK : error->code;                                                     \
    release(is);                                                                                   \
    return code;                                                                                   \
  }

static asp_heights *read_mended(const char *path, bool map, int form, asp_error *error) {
  aspi_profile_options options = aspi_profile_options_default();
  options.form = form;
  options.spikes = 8;
  options.fill = true;
  return aspi_read(NULL, path, map, &options, NULL, error);
}

static asp_heights *read_plain(const char *path, asp_error *error) {
  return aspi_read(NULL, path, false, NULL, NULL, error);
}

static asp_heights *read_from_pipe(asp_error *error) {
  int ends[2];
  char path[32];
  if (pipe(ends) != 0 || write(ends[1], "x_um,z_um\n1,1\n2,0\n3,5\n", 22) != 22)
    abort();
  snprintf(path, sizeof path, "/dev/fd/%d", ends[0]);
  close(ends[1]);
  asp_heights *made = read_plain(path, error);
  close(ends[0]);
  return made;
}

MAKES(read_columns, asp_heights, read_plain("even.csv", error), asp_heights_free)
MAKES(read_uneven, asp_heights, read_plain("uneven.csv", error), asp_heights_free)
MAKES(read_spikes, asp_heights, read_mended("even.csv", false, 4, error), asp_heights_free)
MAKES(read_sdf, asp_heights, read_plain("map.sdf", error), asp_heights_free)
MAKES(read_pipe, asp_heights, read_from_pipe(error), asp_heights_free)
MAKES(create_profile, asp_heights, aspi_profile_generate(1, 10, 1, 2000, 1, error),
      asp_heights_free)
MAKES(copy_profile, asp_heights, asp_heights_create(profile->z, 500, 1, 1, 1, false, error),
      asp_heights_free)
MAKES(close_profile, asp_heights, aspi_profile_closed(profile, 20, error), asp_heights_free)
MAKES(read_sdf_map, asp_heights, read_mended("map.sdf", true, 1, error), asp_heights_free)
MAKES(read_matrix, asp_heights, read_mended("matrix.csv", true, 1, error), asp_heights_free)
MAKES(read_triples, asp_heights, read_mended("triples.csv", true, 1, error), asp_heights_free)
MAKES(copy_map, asp_heights, asp_heights_create(gauss->z, 32, 32, 1, 1, false, error),
      asp_heights_free)
MAKES(ball, aspi_ball, aspi_ball_create(gauss, 20, error), aspi_ball_free)
MAKES(closed_form, asp_surface, asp_surface_create(1, 10, error), asp_surface_free)
MAKES(size_table, asp_surface, asp_surface_create(5, 10, error), asp_surface_free)
MAKES(sphere, asp_surface, asp_surface_create_lay(1, 10, 30, error), asp_surface_free)
MAKES(measured_surface, asp_surface, asp_surface_create_profile(profile, 25, 50, 3, error),
      asp_surface_free)
MAKES(materials, aspi_materials, aspi_materials_read("materials.csv", error), aspi_materials_free)
MAKES(table, aspi_cor_table, aspi_cor_table_read("table.csv", 1, error), aspi_cor_table_free)
MAKES(smooth_wall, asp_wall, asp_wall_from_text("materials quartz steel", 0, 0, error),
      asp_wall_free)
MAKES(pair, asp_pair, asp_pair_create(asp_material_at(0), asp_material_at(0), error), asp_pair_free)
MAKES(material, asp_material, asp_material_create("brass", error), asp_material_free)

ENTRY(describe) {
  return asp_heights_describe(profile, &(asp_heights_numbers){0}, error);
}

ENTRY(describe_map) {
  return asp_heights_describe(gauss, &(asp_heights_numbers){0}, error);
}

ENTRY(describe_slopes) {
  aspi_slopes slopes;
  return aspi_profile_describe_slopes(profile, 20, &slopes, error);
}

ENTRY(slopes) {
  static double room[4000];
  size_t found;
  return aspi_profile_slopes(profile, 20, room, &found, error);
}

static asp_code field_of(const asp_heights *of, double d_p, const aspi_grid *grid,
                         asp_error *error) {
  aspi_field made;
  asp_code code = aspi_field_create(&made, of, d_p, grid, error);
  if (!code)
    aspi_field_free(&made);
  return code;
}

ENTRY(field) {
  return field_of(profile, 20, NULL, error);
}

ENTRY(field_over_map) {
  return field_of(gauss, 10, &(aspi_grid){1, {0, 0}, {64, 64}}, error);
}

static asp_surface *make_map_surface(asp_error *error) {
  asp_heights_numbers numbers;
  if (asp_heights_describe(gauss, &numbers, error))
    return NULL;
  return aspi_surface_create_map(&numbers, true, error);
}
MAKES(map_surface, asp_surface, make_map_surface(error), asp_surface_free)

/* Walls of every model, with a measured profile and without one. */
static int model;
static bool measured;

static asp_wall *make_rough_wall(asp_error *error) {
  aspi_wall_choice choice = aspi_wall_choice_smooth();
  choice.surface = surface;
  choice.heights = measured ? profile : NULL;
  choice.spread = asp_spread_at(model);
  choice.sizes = (aspi_sizes){25, 40, 2};
  return aspi_wall_create(&choice, error);
}
MAKES(rough_wall, asp_wall, make_rough_wall(error), asp_wall_free)

/* What a process found, as its exit status. */
enum { SUCCEEDED, NO_MEMORY, OTHER_CODE, NO_MESSAGE };

#define NEVER (1L << 40)

static int outcome_of(entry call, long first, long last) {
  asp_error error = {.code = ASP_OK};
  first_bad = first;
  last_bad = last;
  seen = 0;
  armed = 1;
  asp_code code = call(&error);
  armed = 0;
  if (code == ASP_OK)
    return SUCCEEDED;
  if (code != ASP_ENOMEM || error.code != code)
    return OTHER_CODE;
  return *error.text ? NO_MEMORY : NO_MESSAGE;
}

/* Most allocations of one entry point that are made to fail: all, or that many spread evenly. */
static long most = 4;

/* How often a failing allocation was reported; exits where it was not as it must be. Every second
 * one of a sample, and each of a few, fails alone; the others, and each of a few, with all after
 * it. */
static long try_all(const char *name, entry call) {
  if (outcome_of(call, NEVER, NEVER) != SUCCEEDED) {
    fprintf(stderr, "%s: does not work with all its memory\n", name);
    exit(1);
  }
  long total = seen, told = 0;
  long tries = total > most ? most : 2 * total;
  for (long k = 0; k < tries; k++) {
    long at = 1 + k * total / tries;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0)
      _exit(outcome_of(call, at, k % 2 ? NEVER : at));
    int status;
    if (child < 0 || waitpid(child, &status, 0) != child)
      abort();
    if (!WIFEXITED(status) || WEXITSTATUS(status) > NO_MEMORY) {
      fprintf(stderr, "%s: allocation %ld of %ld fails: %s %d\n", name, at, total,
              WIFEXITED(status) ? "exit" : "signal",
              WIFEXITED(status) ? WEXITSTATUS(status) : WTERMSIG(status));
      exit(1);
    }
    told += WEXITSTATUS(status) == NO_MEMORY;
  }
  printf("%-28s %3ld allocations, %3ld told\n", name, total, told);
  if (told == 0) {
    fprintf(stderr, "%s: no failing allocation was told\n", name);
    exit(1);
  }
  return told;
}

static FILE *begin(const char *path) {
  FILE *file = fopen(path, "w");
  if (!file)
    abort();
  return file;
}

static void write_files(void) {
  FILE *even = begin("even.csv"), *uneven = begin("uneven.csv"), *map = begin("map.sdf");
  fputs("x_um,z_um\n", even);
  fputs("x_um,z_um\n", uneven);
  fputs("aISO-1.0\nNumPoints = 100\nNumProfiles = 50\nXscale = 1e-6\nYscale = 1e-6\n"
        "Zscale = 1e-6\n*\n",
        map);
  for (int i = 0; i < 5000; i++) {
    double z = sin(0.3 * i) + 0.5 * sin(0.071 * i * i);
    fprintf(even, "%d,%.9g\n", i, i == 77 ? 90 : z);
    fprintf(uneven, "%.9g,%.9g\n", i + 0.3 * sin(i), z);
    fprintf(map, "%.9g\n", z);
  }
  fclose(even);
  fclose(uneven);
  fclose(map);
  FILE *matrix = begin("matrix.csv"), *triples = begin("triples.csv");
  fputs("# Width: 40 um\n# Height: 50 um\n# Value units: um\n", matrix);
  fputs("x_um,y_um,z_um\n", triples);
  for (int i = 0; i < 2000; i++) {
    double z = sin(0.3 * i) + 0.5 * sin(0.071 * i * i);
    fprintf(matrix, "%.9g%s", i == 77 ? 90 : z, i % 40 < 39 ? "," : "\n");
    if (i != 77)
      fprintf(triples, "%d,%d,%.9g\n", i % 40, i / 40, z);
  }
  fclose(matrix);
  fclose(triples);
  FILE *materials_file = begin("materials.csv"), *table_file = begin("table.csv");
  fputs("name,youngs_modulus_pa,poissons_ratio,density_kg_m3\n", materials_file);
  for (int i = 0; i < 40; i++)
    fprintf(materials_file, "m%d,7e10,0.2,2000\n", i);
  fputs("alpha1_deg,v1_m_s,cor_n,cor_t\n", table_file);
  for (int i = 0; i < 90; i++)
    fprintf(table_file, "%d,%d,0.5,0.5\n", i % 9 * 10, i / 9);
  fclose(materials_file);
  fclose(table_file);
}

/* test_memory [MOST] */
int main(int argc, char **argv) {
  char folder[] = "/tmp/test_memory.XXXXXX", name[64];
  if (!mkdtemp(folder) || chdir(folder) != 0)
    return 1;
  if (argc > 1)
    most = atol(argv[1]);
  write_files();
  profile = aspi_profile_generate(1, 10, 1, 3000, 1, NULL);
  surface = asp_surface_create(1, 10, NULL);
  gauss = gauss_map_create(&(gauss_wall){1, 5, 5, 0}, (const double[2]){1, 1}, 64, 64, 1, NULL);
  long told = 0;
  for (size_t i = 0; i < count; i++)
    told += try_all(entries[i].name, entries[i].call);
  for (model = 0; model < asp_spread_count(); model++)
    for (int with = 0; with < 2; with++) {
      measured = with;
      snprintf(name, sizeof name, "wall, %s%s", asp_spread_name(asp_spread_at(model)),
               with ? " measured" : "");
      told += try_all(name, rough_wall);
    }
  asp_heights_free(gauss);
  asp_surface_free(surface);
  asp_heights_free(profile);
  const char *const files[] = {"even.csv",    "uneven.csv",    "map.sdf",  "matrix.csv",
                               "triples.csv", "materials.csv", "table.csv"};
  for (size_t i = 0; i < sizeof files / sizeof *files; i++)
    unlink(files[i]);
  rmdir(folder);
  printf("%ld failing allocations were told\n", told);
  return 0;
}
