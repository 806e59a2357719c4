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

static asp_heights *profile;
static asp_surface *surface;

/* What an entry point gives: a code, or the code that goes with a NULL. */
typedef asp_code (*entry)(asp_error *error);

static asp_code code_of(const void *made, const asp_error *error) {
  return made ? ASP_OK : error->code;
}

static asp_code read_with(const char *path, aspi_profile_options options, asp_error *error) {
  asp_heights *made = aspi_read(NULL, path, false, &options, NULL, error);
  asp_heights_free(made);
  return code_of(made, error);
}

static asp_code read_columns(asp_error *error) {
  return read_with("even.csv", aspi_profile_options_default(), error);
}

static asp_code read_uneven(asp_error *error) {
  return read_with("uneven.csv", aspi_profile_options_default(), error);
}

static asp_code read_spikes(asp_error *error) {
  aspi_profile_options options = aspi_profile_options_default();
  options.form = 4;
  options.spikes = 8;
  options.fill = true;
  return read_with("even.csv", options, error);
}

static asp_code read_map(asp_error *error) {
  return read_with("map.sdf", aspi_profile_options_default(), error);
}

static asp_code read_pipe(asp_error *error) {
  int ends[2];
  char path[32];
  if (pipe(ends) != 0 || write(ends[1], "x_um,z_um\n1,1\n2,0\n3,5\n", 22) != 22)
    abort();
  snprintf(path, sizeof path, "/dev/fd/%d", ends[0]);
  close(ends[1]);
  asp_code code = read_with(path, aspi_profile_options_default(), error);
  close(ends[0]);
  return code;
}

static asp_code create_profile(asp_error *error) {
  asp_heights *made = aspi_profile_generate(1, 10, 1, 2000, 1, error);
  asp_heights_free(made);
  return code_of(made, error);
}

static asp_code copy_profile(asp_error *error) {
  asp_heights *made = asp_heights_create(profile->z, 500, 1, 1, 1, false, error);
  asp_heights_free(made);
  return code_of(made, error);
}

static asp_code describe(asp_error *error) {
  asp_heights_numbers description;
  return asp_heights_describe(profile, &description, error);
}

static asp_code describe_slopes(asp_error *error) {
  aspi_slopes slopes;
  return aspi_profile_describe_slopes(profile, 20, &slopes, error);
}

static double room[4000];

static asp_code close_profile(asp_error *error) {
  asp_heights *made = aspi_profile_closed(profile, 20, error);
  asp_heights_free(made);
  return code_of(made, error);
}

static asp_code slopes(asp_error *error) {
  size_t count;
  return aspi_profile_slopes(profile, 20, room, &count, error);
}

static asp_code field(asp_error *error) {
  aspi_field made;
  asp_code code = aspi_field_create(&made, profile, 20, NULL, error);
  if (!code)
    aspi_field_free(&made);
  return code;
}

static asp_heights *gauss_map(asp_error *error) {
  gauss_wall wall = {1, 5, 5, 0};
  return gauss_map_create(&wall, (const double[2]){1, 1}, 64, 64, 1, error);
}

static asp_code read_area(const char *path, asp_error *error) {
  aspi_profile_options options = aspi_profile_options_default();
  options.fill = true;
  options.spikes = 8;
  asp_heights *made = aspi_read(NULL, path, true, &options, NULL, error);
  asp_heights_free(made);
  return code_of(made, error);
}

static asp_code read_sdf_map(asp_error *error) {
  return read_area("map.sdf", error);
}

static asp_code read_matrix(asp_error *error) {
  return read_area("matrix.csv", error);
}

static asp_code read_triples(asp_error *error) {
  return read_area("triples.csv", error);
}

static asp_heights *gauss;

static asp_code copied_map(asp_error *error) {
  asp_heights *made = asp_heights_create(gauss->z, 32, 32, 1, 1, false, error);
  asp_heights_free(made);
  return code_of(made, error);
}

static asp_code described_map(asp_error *error) {
  return asp_heights_describe(gauss, &(asp_heights_numbers){0}, error);
}

static asp_code ball(asp_error *error) {
  aspi_ball *made = aspi_ball_create(gauss, 20, error);
  aspi_ball_free(made);
  return code_of(made, error);
}

static asp_code field_over_map(asp_error *error) {
  aspi_field made;
  const aspi_grid all = {1, {0, 0}, {64, 64}};
  asp_code code = aspi_field_create(&made, gauss, 10, &all, error);
  if (!code)
    aspi_field_free(&made);
  return code;
}

static asp_code map_surface(asp_error *error) {
  asp_heights_numbers numbers;
  if (asp_heights_describe(gauss, &numbers, error))
    return error->code;
  asp_surface *made = aspi_surface_create_map(gauss, &numbers, true, error);
  asp_surface_free(made);
  return code_of(made, error);
}

static asp_code give_surface(asp_surface *made, const asp_error *error) {
  asp_surface_free(made);
  return code_of(made, error);
}

static asp_code closed_form(asp_error *error) {
  return give_surface(asp_surface_create(1, 10, error), error);
}

static asp_code size_table(asp_error *error) {
  return give_surface(asp_surface_create(5, 10, error), error);
}

static asp_code sphere(asp_error *error) {
  return give_surface(asp_surface_create_lay(1, 10, 30, error), error);
}

static asp_code measured_surface(asp_error *error) {
  return give_surface(asp_surface_create_profile(profile, 25, 50, 3, error), error);
}

static asp_code materials(asp_error *error) {
  aspi_materials *made = aspi_materials_read("materials.csv", error);
  aspi_materials_free(made);
  return code_of(made, error);
}

static asp_code table(asp_error *error) {
  aspi_cor_table *made = aspi_cor_table_read("table.csv", 1, error);
  aspi_cor_table_free(made);
  return code_of(made, error);
}

static asp_code smooth_wall(asp_error *error) {
  asp_wall *made = asp_wall_from_text("materials quartz steel", 0, 0, error);
  asp_wall_free(made);
  return code_of(made, error);
}

/* Walls of every model, with a measured profile and without one. */
static int model;
static bool measured;

static asp_code rough_wall(asp_error *error) {
  aspi_wall_choice choice = aspi_wall_choice_smooth();
  choice.surface = surface;
  choice.heights = measured ? profile : NULL;
  choice.spread = asp_spread_at(model);
  choice.sizes = (aspi_sizes){25, 40, 2};
  asp_wall *wall = aspi_wall_create(&choice, error);
  asp_wall_free(wall);
  return code_of(wall, error);
}

static asp_code pair(asp_error *error) {
  const asp_material *quartz = asp_material_at(0);
  asp_pair *made = asp_pair_create(quartz, quartz, error);
  asp_pair_free(made);
  return code_of(made, error);
}

static asp_code material(asp_error *error) {
  asp_material *made = asp_material_create("brass", error);
  asp_material_free(made);
  return code_of(made, error);
}

/* What a process found, as its exit status. */
enum { SUCCEEDED, NO_MEMORY, OTHER_CODE, NO_MESSAGE };

#define NEVER (1L << 40)

static int outcome_of(entry call, long first, long last) {
  asp_error error = {ASP_OK, ""};
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
enum { TRIED = 12 };

/* How often a failing allocation was reported; exits where it was not as it must be. Every second
 * one of a sample, and each of a few, fails alone; the others, and each of a few, with all after
 * it. */
static long try_all(const char *name, entry call, bool allocates) {
  if (outcome_of(call, NEVER, NEVER) != SUCCEEDED) {
    fprintf(stderr, "%s: does not work with all its memory\n", name);
    exit(1);
  }
  long total = seen, told = 0;
  long tries = total > TRIED ? TRIED : 2 * total;
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
  if (allocates && told == 0) {
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

int main(void) {
  static const struct {
    const char *name;
    entry call;
    bool allocates;
  } entries[] = {
      {"profile, columns", read_columns, true},
      {"profile, resampled", read_uneven, true},
      {"profile, form and spikes", read_spikes, true},
      {"profile, SDF", read_map, true},
      {"profile, from a pipe", read_pipe, true},
      {"profile, generated", create_profile, true},
      {"profile, from heights", copy_profile, true},
      {"profile described", describe, true},
      {"slopes described", describe_slopes, true},
      {"closing", close_profile, true},
      {"slopes", slopes, true},
      {"field over a profile", field, true},
      {"map, SDF", read_sdf_map, true},
      {"map, matrix", read_matrix, true},
      {"map, triples", read_triples, true},
      {"map, from heights", copied_map, true},
      {"map described", described_map, true},
      {"sphere on a map", ball, true},
      {"field over a map", field_over_map, true},
      {"surface of a map", map_surface, true},
      {"surface, closed form", closed_form, true},
      {"surface, table", size_table, true},
      {"surface, sphere", sphere, true},
      {"surface, measured", measured_surface, true},
      {"materials", materials, true},
      {"table", table, true},
      {"smooth wall", smooth_wall, true},
      {"pair", pair, true},
      {"material", material, true},
  };
  char folder[] = "/tmp/test_memory.XXXXXX", name[64];
  if (!mkdtemp(folder) || chdir(folder) != 0)
    return 1;
  write_files();
  profile = aspi_profile_generate(1, 10, 1, 3000, 1, NULL);
  surface = asp_surface_create(1, 10, NULL);
  gauss = gauss_map(NULL);
  long told = 0;
  for (size_t i = 0; i < sizeof entries / sizeof *entries; i++)
    told += try_all(entries[i].name, entries[i].call, entries[i].allocates);
  for (model = 0; model < asp_spread_count(); model++)
    for (int with = 0; with < 2; with++) {
      measured = with;
      snprintf(name, sizeof name, "wall, %s%s", asp_spread_name(asp_spread_at(model)),
               with ? " measured" : "");
      told += try_all(name, rough_wall, true);
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
