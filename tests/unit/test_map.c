/* Maps from files of every kind, what is done to them, and what they are. The numbers of the
 * description are those of SciPy 1.10.1 for the same heights: numpy's mean and std, scipy.stats
 * skew and kurtosis, scipy.signal.fftconvolve over the number of products for the autocorrelation,
 * and numpy.linalg.lstsq for the ellipse.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "readers/read.h"
#include "surface/heights.h"

#include <stdlib.h>
#include <unistd.h>

enum { COLUMNS = 96, ROWS = 80 };

/* Sixty waves, with crests made higher and troughs shallower; from their mean. Lengths in um. */
static double heights[ROWS][COLUMNS];

static void make_heights(void) {
  unsigned r = 12345;
  double wave[60][3], mean = 0;
  for (int k = 0; k < 60; k++)
    for (int i = 0; i < 3; i++) {
      r = (r * 1103515245u + 12345u) % 2147483648u;
      wave[k][i] = r / 2147483648.;
    }
  for (int j = 0; j < ROWS; j++)
    for (int i = 0; i < COLUMNS; i++) {
      double z = 0, x = 0.5 * i, y = 0.7 * j;
      for (int k = 0; k < 60; k++) {
        double a = 2 * wave[k][0] - 1, b = 2 * wave[k][1] - 1;
        z += cos(2.2 * a * x + 0.7 * b * y + 0.8 * a * y + 2 * ASP_PI * wave[k][2]);
      }
      heights[j][i] = z + 0.02 * z * z;
      mean += heights[j][i] / (ROWS * COLUMNS);
    }
  for (int j = 0; j < ROWS; j++)
    for (int i = 0; i < COLUMNS; i++)
      heights[j][i] -= mean;
}

static FILE *begin(const char *path) {
  FILE *file = fopen(path, "wb");
  assert_non_null(file);
  return file;
}

static void write_matrix(const char *path, const char *head, const char *separator) {
  FILE *file = begin(path);
  fputs(head, file);
  for (int j = 0; j < ROWS; j++)
    for (int i = 0; i < COLUMNS; i++)
      fprintf(file, "%.9g%s", heights[j][i], i + 1 < COLUMNS ? separator : "\n");
  fclose(file);
}

static aspi_profile_options how;
static aspi_profile_report report;

static asp_heights *read_map(const char *path) {
  asp_error error;
  asp_heights *map = aspi_read(NULL, path, true, &how, &report, &error);
  if (!map)
    fail_msg("%s", error.text);
  return map;
}

static void refuse(const char *path, const char *words) {
  asp_error error;
  assert_null(aspi_read(NULL, path, true, &how, &report, &error));
  assert_says(error.text, words);
}

static int setup(void **state) {
  (void)state;
  how = aspi_profile_options_default();
  how.meter = 1e6;
  how.form = 0;
  return 0;
}

static int teardown(void **state) {
  (void)state;
  unlink("map");
  return 0;
}

static void check_map(asp_heights *map, double tolerance) {
  assert_int_equal(map->columns, COLUMNS);
  assert_int_equal(map->rows, ROWS);
  assert_near(map->step[0], 0.5, 1e-9);
  assert_near(map->step[1], 0.7, 1e-9);
  for (int j = 0; j < ROWS; j++)
    for (int i = 0; i < COLUMNS; i++)
      assert_near(map->z[j * COLUMNS + i], heights[j][i], tolerance);
  asp_heights_free(map);
}

TEST_BETWEEN(matrices_are_read, setup, teardown) {
  const char *const separators[] = {",", ", ", ";", "\t", " ", "   "};
  const char *head = "# Channel: Height\n# Width: 48 \xc2\xb5m\n# Height: 56 \xc2\xb5m\n"
                     "# Value units: um\n";
  for (size_t k = 0; k < sizeof separators / sizeof *separators; k++) {
    write_matrix("map", head, separators[k]);
    check_map(read_map("map"), 1e-4);
  }
  how.step[0] = 0.5e-6;
  how.step[1] = 0.7e-6;
  how.unit_z = 1e-6;
  write_matrix("map", "", ",");
  check_map(read_map("map"), 1e-4);
}

TEST_BETWEEN(triples_are_read_in_any_order, setup, teardown) {
  for (int order = 0; order < 3; order++) {
    FILE *file = begin("map");
    fputs("x_um,y_um,z_nm\n", file);
    for (int k = 0; k < ROWS * COLUMNS; k++) {
      int at = order == 0 ? k : (k * 7919) % (ROWS * COLUMNS); /* 7919 and 7680 have no divisor */
      int i = order == 2 ? at / ROWS : at % COLUMNS, j = order == 2 ? at % ROWS : at / COLUMNS;
      double off = i % (COLUMNS - 1) ? 0.004 * (k % 3 - 1) : 0; /* rounding, but not at the ends */
      fprintf(file, "%.6g,%.6g,%.9g\n", 100 + 0.5 * i + off, 0.7 * j - 30, 1e3 * heights[j][i]);
    }
    fclose(file);
    check_map(read_map("map"), 1e-4);
  }
}

/* The columns that the header names are taken, each with its unit, in whatever order they stand. */
TEST_BETWEEN(columns_are_chosen_by_their_names, setup, teardown) {
  static const struct {
    const char *head, *row; /* %1$ is x, %2$ y, %3$ z, in um, mm and nm; %4$ counts */
  } all[] = {{"x [um],y [mm],z [nm]\n", "%1$.6g,%2$.9g,%3$.9g\n"},
             {"Point;Z [nm];X [um];Y [mm]\n", "%4$d;%3$.9g;%1$.6g;%2$.9g\n"},
             {"X\tY\tHeight\tQuality\num\tmm\tnm\t\n", "%1$.6g\t%2$.9g\t%3$.9g\t%4$d\n"},
             {"\"X [um]\",\"Y [mm]\",\"Z [nm]\"\n", "\"%1$.6g\",\"%2$.9g\",\"%3$.9g\"\n"},
             {"\xEF\xBB\xBFx [um] y [mm] z [nm]\r", "%1$.6g %2$.9g %3$.9g\r"}};
  for (size_t form = 0; form < sizeof all / sizeof *all; form++) {
    FILE *file = begin("map");
    fputs(all[form].head, file);
    for (int k = 0; k < ROWS * COLUMNS; k++)
      fprintf(file, all[form].row, 0.5 * (k % COLUMNS), 0.7e-3 * (k / COLUMNS),
              1e3 * heights[k / COLUMNS][k % COLUMNS], k + 1);
    fputs("\nend of data\n", file);
    fclose(file);
    check_map(read_map("map"), 1e-4);
  }
  how.step[0] = 1e-6;
  refuse("map", "has the positions of its points");
}

/* Decimal commas beside commas; the mark that is stated. */
TEST_BETWEEN(what_is_no_height_is_refused, setup, teardown) {
  const char *head = "# Width: 48 um\n# Height: 56 um\n# Value units: um\n";
  FILE *file = begin("map");
  fputs(head, file);
  for (int k = 0; k < ROWS * COLUMNS; k++) {
    double z = heights[k / COLUMNS][k % COLUMNS];
    fprintf(file, "%d,%04d%s", (int)z, (int)fabs(1e4 * (z - (int)z)),
            k % COLUMNS + 1 < COLUMNS ? "," : "\n");
  }
  fclose(file);
  refuse("map", "zero: are there decimal commas");
  how.missing = -770;
  how.fill = true;
  file = begin("map");
  fputs(head, file);
  for (int k = 0; k < ROWS * COLUMNS; k++)
    fprintf(file, "%g%s", k % 700 == 350 ? -770 : heights[k / COLUMNS][k % COLUMNS],
            k % COLUMNS + 1 < COLUMNS ? "\t" : "\n");
  fclose(file);
  asp_heights_free(read_map("map"));
  assert_says(report.text, ", 11 bad");
}

/* As the standard has it, in little-endian order, whatever this machine has. */
static void put(FILE *file, uint64_t value, int bytes) {
  for (int k = 0; k < bytes; k++)
    putc((int)(value >> (8 * k) & 255), file);
}

static void put_double(FILE *file, double value) {
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  put(file, bits, 8);
}

static void write_binary(int type, const char *version, bool bad) {
  FILE *file = begin("map");
  double scale = type == 0 || type == 4 ? 0.5e-6 : 1e-9, zero = type < 3 ? 13e-6 : 0;
  int wide = version[5] == '2' ? 4 : 2;
  fprintf(file, "%s%-10s%s%s", version, "test", "010120260000", "010120260000");
  put(file, COLUMNS, wide);
  put(file, ROWS, wide);
  put_double(file, 0.5e-6);
  put_double(file, 0.7e-6);
  put_double(file, type == 3 || type == 7 ? 1e-6 : scale);
  put_double(file, -1);
  put(file, 0, 1);
  put(file, (uint64_t)type, 1);
  put(file, 0, 1);
  for (int j = 0; j < ROWS; j++)
    for (int i = 0; i < COLUMNS; i++) {
      static const int size[] = {1, 2, 4, 4, 1, 2, 4, 8};
      int64_t value = llround((heights[j][i] * 1e-6 + zero) / scale);
      float real = (float)heights[j][i];
      uint32_t bits;
      memcpy(&bits, &real, sizeof bits);
      bool mark = bad && i == 40 && j == 20;
      if (type == 7)
        put_double(file, mark ? NAN : heights[j][i]);
      else if (type == 3)
        put(file, mark ? 0xff7fffff : bits, 4); /* the least float */
      else if (mark)
        put(file, type < 3 ? UINT64_MAX : (uint64_t)1 << (8 * size[type] - 1), size[type]);
      else
        put(file, (uint64_t)value, size[type]);
    }
  fclose(file);
}

TEST_BETWEEN(binary_files_are_read, setup, teardown) {
  for (int type = 0; type < 8; type++) {
    write_binary(type, type % 2 ? "bISO-1.0" : "bISO-2.0", false);
    check_map(read_map("map"), type == 0 || type == 4 ? 0.3 : 1e-3);
    if (type == 0 || type == 4)
      continue; /* have no mark for a bad height */
    write_binary(type, "bISO-1.0", true);
    how.fill = 0;
    refuse("map", "1 of 7680 points are bad");
    how.fill = 1;
    asp_heights *map = read_map("map");
    double mean = 0.25 * (heights[20][39] + heights[20][41] + heights[19][40] + heights[21][40]);
    assert_near(map->z[20 * COLUMNS + 40], mean, 0.02);
    assert_says(report.text, ", 1 points filled in");
    asp_heights_free(map);
  }
}

TEST_BETWEEN(text_of_the_standard_is_read, setup, teardown) {
  FILE *file = begin("map");
  fputs("\xEF\xBB\xBF" /* the mark of UTF-8 */
        "aISO-1.0\n\nNumPoints = 7\nNumProfiles = 4\nXscale = 1.0E-6\nYscale = 2.0E-6\n"
        "Zscale = 1.0E-6\n*\n",
        file);
  for (int k = 0; k < 28; k++)
    fprintf(file, "%d ", k * k % 11);
  fputs("\n*\ntrailer\n*", file);
  fclose(file);
  asp_heights *map = read_map("map");
  assert_int_equal(map->columns, 7);
  assert_int_equal(map->rows, 4);
  assert_near(map->step[1], 2, 1e-9);
  assert_near(map->z[9] - map->z[0], 81 % 11, 1e-5);
  asp_heights_free(map);
}

TEST_BETWEEN(form_and_spikes_are_taken_out, setup, teardown) {
  double kept[ROWS][COLUMNS];
  memcpy(kept, heights, sizeof kept);
  const char *head = "# Width: 48 um\n# Height: 56 um\n# Value units: um\n";
  how.form = 2;
  write_matrix("map", head, ",");
  asp_heights *plain = read_map("map");
  assert_string_equal(report.warnings, "");
  for (int j = 0; j < ROWS; j++)
    for (int i = 0; i < COLUMNS; i++)
      heights[j][i] += 300 + 2.5 * i - 1.5 * j + 0.01 * i * j + 0.02 * i * i;
  write_matrix("map", head, ",");
  asp_heights *bent = read_map("map");
  for (size_t i = 0; i < ROWS * COLUMNS; i++)
    assert_near(bent->z[i], plain->z[i], 2e-3);
  heights[33][44] += 400;
  heights[70][3] -= 400;
  write_matrix("map", head, ",");
  asp_heights_free(read_map("map"));
  assert_says(report.warnings, "2 of 7680 points lie over 20");
  how.spikes = 15;
  refuse("map",
         "is the first of 2 spikes; fill the gaps (asperity surface --gaps fill --save FILE)");
  how.fill = 1;
  asp_heights *mended = read_map("map");
  for (size_t i = 0; i < ROWS * COLUMNS; i++)
    assert_near(mended->z[i], plain->z[i], 7);
  assert_near(mended->z[0], plain->z[0], 0.1);
  asp_heights_free(plain);
  asp_heights_free(bent);
  asp_heights_free(mended);
  memcpy(heights, kept, sizeof kept);
}

/* Gaussian heights of a ground wall: rough across a lay of any direction, smooth along it. Nothing
 * of it is dust; a grain on it still is. */
TEST_BETWEEN(ground_walls_are_not_dust, setup, teardown) {
  const char *head = "# Width: 48 um\n# Height: 56 um\n# Value units: um\n";
  for (int degrees = 0; degrees < 180; degrees += 15) {
    double c = cos(degrees * ASP_PI / 180), s = sin(degrees * ASP_PI / 180);
    unsigned r = 54321;
    memset(heights, 0, sizeof heights);
    for (int wave = 0; wave < 60; wave++) {
      double u[3];
      for (int i = 0; i < 3; i++) {
        r = (r * 1103515245u + 12345u) % 2147483648u;
        u[i] = r / 2147483648.;
      }
      for (int j = 0; j < ROWS; j++)
        for (int i = 0; i < COLUMNS; i++)
          heights[j][i] += cos(0.5 * (2 * u[0] - 1) * (c * i + s * j) +
                               0.01 * (2 * u[1] - 1) * (c * j - s * i) + 2 * ASP_PI * u[2]);
    }
    write_matrix("map", head, ",");
    asp_heights_free(read_map("map"));
    if (*report.warnings)
      fail_msg("lay at %d degrees: %s", degrees, report.warnings);
    heights[40][50] += 100;
    write_matrix("map", head, ",");
    asp_heights_free(read_map("map"));
    assert_says(report.warnings, "1 of 7680 points lie");
  }
  make_heights();
}

TEST(numbers_agree_with_scipy) {
  static double z[ROWS * COLUMNS];
  for (int i = 0; i < ROWS * COLUMNS; i++)
    z[i] = heights[i / COLUMNS][i % COLUMNS];
  asp_heights *map = asp_heights_create(z, COLUMNS, ROWS, 0.5, 0.7, false, NULL);
  asp_heights_numbers numbers;
  assert_int_equal(asp_heights_describe(map, &numbers, NULL), ASP_OK);
  const struct {
    double is, value, tolerance;
  } all[] = {{numbers.s_q, 5.218929344, 1e-5},
             {numbers.s_a, 4.127026078, 1e-5},
             {numbers.s_sk, 0.6612207961, 1e-5},
             {numbers.s_ku, 3.658883847, 1e-5},
             {numbers.s_p, 24.53239247, 1e-5},
             {numbers.s_v, 11.73003999, 1e-5},
             {numbers.s_z, 36.26243246, 1e-5},
             {numbers.s_dq, 7.171598943, 1e-5},
             {numbers.s_al, 1.105, 0.006},
             {numbers.s_tr, 0.28117, 0.003},
             {numbers.lambda_1, 0.93604, 0.003},
             {numbers.lambda_2, 3.32846, 0.012},
             {numbers.lay, 111.82688 * ASP_PI / 180, 0.002}};
  for (size_t i = 0; i < sizeof all / sizeof *all; i++)
    assert_near(all[i].is, all[i].value, all[i].tolerance);
  asp_heights_free(map);
}

/* A line of any length is one row. */
TEST_BETWEEN(long_lines_are_read, setup, teardown) {
  enum { LONG = 3000 };
  FILE *file = begin("map");
  fputs("# Width: 3 mm\n# Height: 4 um\n# Value units: um\n", file);
  for (int k = 0; k < 4 * LONG; k++)
    fprintf(file, "%.5f%s", sin(k), (k + 1) % LONG ? " " : "\n");
  fclose(file);
  how.form = -1;
  asp_heights *map = read_map("map");
  assert_int_equal(map->columns, LONG);
  assert_int_equal(map->rows, 4);
  const double *z = map->z;
  assert_near(z[4 * LONG - 1] - z[0], sin(4 * LONG - 1), 1e-4);
  asp_heights_free(map);
}

static void refuses_text(char *row[]) {
  FILE *file = begin("map");
  fputs(row[0], file);
  fclose(file);
  refuse("map", row[1]);
}

TEST_BETWEEN(bad_files_are_refused, setup, teardown) {
  CHECK_ROWS("tables.txt", refuses_text);
#ifdef ASPI_X3P
  const char *says = "binary, a zip that cannot be opened";
#else
  const char *says = "binary, a zip; this build reads no X3P";
#endif
  refuses_text((char *[]){"PK\x03\x04", (char *)says});
  refuse("none", "none");
}

int main(void) {
  char folder[] = "/tmp/test_map.XXXXXX";
  if (!mkdtemp(folder) || chdir(folder) != 0)
    return 1;
  make_heights();
  int failed = run_listed_tests(NULL, NULL);
  rmdir(folder);
  return failed;
}
