/* Profiles that are made, described, and read, with the traps of files that users have.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "base/stream.h"
#include "base/units.h"
#include "surface/describe.h"
#include "surface/heights.h"
#include "readers/read.h"

#include <stdlib.h>
#include <unistd.h>

/* ---- made and described ---- */

/* Sample R_q, lambda_c and rms slope come back within some sd of their sampling errors, for any
 * number of points, and the mean over seeds closer. */
TEST(generated_profile_has_its_numbers) {
  static const size_t points[] = {65536, 99991, 65537};
  double r_q = 0, lambda_c = 0, slope = 0;
  for (uint32_t seed = 0; seed < 12; seed++) {
    asp_heights *p = aspi_profile_generate(3, 20, 0.5, points[seed % 3], seed, NULL);
    asp_heights_numbers d;
    assert_int_equal(asp_heights_describe(p, &d, NULL), ASP_OK);
    assert_near(d.s_q, 3, 0.15);
    assert_near(d.lambda_1, 20, 1.5);
    assert_near(d.s_dq, sqrt(2) * 3 / 20, 0.006);
    r_q += d.s_q / 12;
    lambda_c += d.lambda_1 / 12;
    slope += d.s_dq / 12;
    asp_heights_free(p);
  }
  assert_near(r_q, 3, 0.03);
  assert_near(lambda_c, 20, 0.3);
  assert_near(slope, sqrt(2) * 3 / 20, 0.0015);
}

/* The weighted mean of the noise around each point, also where blocks of the filter meet, and the
 * end and the beginning. */
TEST(noise_is_filtered_everywhere) {
  enum { N = 5000, REACH = 80 };
  double noise[N], weight[2 * REACH + 1], squares = 0;
  aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = 5, .wall = asp_key_wall("profile")});
  for (int i = 0; i < N; i++)
    noise[i] = aspi_stream_normal(&stream);
  for (int k = 0; k <= 2 * REACH; k++) {
    weight[k] = exp(-2 * pow((k - REACH) / 20., 2));
    squares += weight[k] * weight[k];
  }
  asp_heights *p = aspi_profile_generate(3, 20, 1, N, 5, NULL);
  for (int i = 0; i < N; i++) {
    double sum = 0;
    for (int k = 0; k <= 2 * REACH; k++)
      sum += weight[k] * noise[(i + k - REACH + N) % N];
    assert_near(p->z[i], 3 * sum / sqrt(squares), 1e-12);
  }
  asp_heights_free(p);
}

TEST(the_seed_decides) {
  asp_heights *a = aspi_profile_generate(1, 1, 0.1, 1000, 7, NULL);
  asp_heights *b = aspi_profile_generate(1, 1, 0.1, 1000, 7, NULL);
  asp_heights *c = aspi_profile_generate(1, 1, 0.1, 1000, 8, NULL);
  assert_memory_equal(a->z, b->z, 1000 * sizeof(double));
  assert_memory_not_equal(a->z, c->z, 1000 * sizeof(double));
  asp_heights_free(a);
  asp_heights_free(b);
  asp_heights_free(c);
}

/* No step where the end meets the beginning: it is as steep there as elsewhere. */
TEST(generated_profile_is_periodic) {
  double square = 0;
  for (uint32_t seed = 0; seed < 200; seed++) {
    asp_heights *p = aspi_profile_generate(1, 1, 0.05, 401, seed, NULL);
    const double *z = p->z;
    square += pow((z[0] - z[400]) / 0.05, 2) / 200;
    asp_heights_free(p);
  }
  assert_near(sqrt(square), sqrt(2), 0.25);
}

/* A wave of known R_q, R_a, slope and correlation, whole and cut out of a longer one. */
TEST(description_of_a_wave) {
  enum { N = 2400 };
  static double z[N];
  for (int i = 0; i < N; i++)
    z[i] = 5 + sqrt(2) * sin(2 * ASP_PI * i / 100);
  for (int periodic = 0; periodic < 2; periodic++) {
    asp_heights *p = asp_heights_create(z, N, 1, 0.1, 0, periodic, NULL);
    asp_heights_numbers d;
    assert_int_equal(asp_heights_describe(p, &d, NULL), ASP_OK);
    assert_near(d.s_q, 1, 1e-9);
    assert_near(d.s_a, sqrt(2) * 2 / ASP_PI, 1e-3);
    assert_near(d.lambda_1, 10 * acos(exp(-1)) / (2 * ASP_PI), periodic ? 2e-3 : 2e-2);
    assert_near(d.s_dq, 2 * ASP_PI / 10, 1e-3);
    asp_heights_free(p);
  }
}

/* Three periods of a wave: r(x) = cos(2 pi x/L) at each lag, however few products it has; divided
 * by the number of points, lambda_c would be 2 % smaller. (Beginning at an eighth of a period, the
 * ends add nothing.) */
TEST(lags_of_a_short_wave_are_not_damped) {
  enum { N = 300 };
  double z[N];
  for (int i = 0; i < N; i++)
    z[i] = sin(2 * ASP_PI * ((i + 0.5) / 100 + 0.125));
  asp_heights *p = asp_heights_create(z, N, 1, 0.1, 0, false, NULL);
  asp_heights_numbers d;
  assert_int_equal(asp_heights_describe(p, &d, NULL), ASP_OK);
  assert_near(d.lambda_1, 10 * acos(exp(-1)) / (2 * ASP_PI), 5e-3);
  asp_heights_free(p);
}

TEST(bad_profiles_are_refused) {
  asp_error e;
  assert_null(aspi_profile_generate(1, 1, 0.3, 1000, 1, &e));
  assert_says(e.text, "lambda_c/4");
  assert_null(aspi_profile_generate(1, 1, 0.1, 199, 1, &e));
  assert_says(e.text, "over 20 lambda_c");
  double z[4] = {1, 1, 1, 1};
  assert_null(asp_heights_create(z, 2, 1, 1, 1, false, &e));
  assert_null(asp_heights_create(z, 4, 1, -1, -1, false, &e));
  asp_heights *flat = asp_heights_create(z, 4, 1, 1, 1, false, &e);
  asp_heights_numbers d;
  assert_int_equal(asp_heights_describe(flat, &d, &e), ASP_EDATA);
  assert_says(e.text, "constant");
  asp_heights_free(flat);
}

/* ---- read ---- */

#define SDF_HEAD                                                                                   \
  "\n aISO-1.0\r\nManufacID = X\r\nNumPoints = 4\r\nNumProfiles=3\r\nXscale = 2.0E-6\r\n"          \
  "Yscale=3.0E-6\r\nZscale = 1.0E-6\r\nCompression = 0\r\n"

static asp_error error;
static aspi_profile_report report;

/* Writes a file, reads it, removes it. */
static asp_heights *read_bytes(const char *bytes, size_t length,
                               const aspi_profile_options *options) {
  char path[] = "/tmp/asperity_test_XXXXXX";
  int file = mkstemp(path);
  assert_true(file >= 0);
  assert_int_equal(write(file, bytes, length), length);
  close(file);
  error = (asp_error){.code = ASP_OK};
  asp_heights *p = aspi_read(NULL, path, false, options, &report, &error);
  unlink(path);
  return p;
}

static asp_heights *read_text(const char *text, const aspi_profile_options *options) {
  return read_bytes(text, strlen(text), options);
}

static void expect(const char *text, const aspi_profile_options *options, size_t points,
                   double spacing, double third) {
  asp_heights *p = read_text(text, options);
  if (!p)
    fail_msg("%s: %s", text, error.text);
  assert_int_equal(p->columns, points);
  assert_near(p->step[0], spacing, 1e-9 * spacing);
  assert_near(p->z[2], third, 1e-9 * fabs(third));
  assert_false(p->periodic);
  asp_heights_free(p);
}

static void expect_error(const char *text, const aspi_profile_options *options,
                         const char *message) {
  assert_null(read_text(text, options));
  assert_int_equal(error.code, ASP_EDATA);
  assert_says(error.text, message);
  assert_says(error.text, "/tmp/asperity_test_");
}

/* The text of a file, behind SDF_HEAD if it begins with a star; words and values of options; the
 * number of points, their spacing and the third height, none where the file is refused; and what is
 * said, twice, '-' before what is not. A form is taken out where it is asked for or nothing is. */
static void check_file(char *row[]) {
  aspi_profile_options o = aspi_profile_options_default();
  const struct {
    const char *name;
    double *number;
    const char **text;
  } all[] = {{"unit_x", &o.unit_x, NULL},    {"unit_z", &o.unit_z, NULL},
             {"meter", &o.meter, NULL},      {"missing", &o.missing, NULL},
             {"step", o.step, NULL},         {"column", NULL, &o.column},
             {"x_column", NULL, &o.x_column}};
  char text[400];
  size_t points;
  double spacing, third;
  snprintf(text, sizeof text, "%s%s", *row[0] == '*' ? SDF_HEAD : "", row[0]);
  if (*row[1] || *row[2])
    o.form = -1;
  for (char *name = strtok(row[1], " "); name; name = strtok(NULL, " ")) {
    const char *value = strtok(NULL, " ");
    if (strcmp(name, "fill") == 0)
      o.fill = atoi(value);
    else if (strcmp(name, "row") == 0)
      o.row = atoi(value);
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
      if (strcmp(name, all[i].name) != 0)
        continue;
      else if (all[i].text)
        *all[i].text = value;
      else
        *all[i].number = atof(value);
  }
  if (sscanf(row[2], "%zu %lf %lf", &points, &spacing, &third) == 3)
    expect(text, &o, points, spacing, third);
  else
    expect_error(text, &o, row[3]);
  for (int i = 3; *row[2] && i < 5; i++)
    if (*row[i] != '-')
      assert_says(report.text, row[i]);
    else if (strstr(report.text, row[i] + 1))
      fail_msg("%s: %s", text, report.text);
  char filled[40];
  snprintf(filled, sizeof filled, "%zu points filled in", report.filled);
  assert_int_equal(*row[2] && strstr(report.text, filled), *row[2] && report.filled > 0);
}

/* Heights that are no numbers, or whose squares would not be, at any spacing. */
TEST(heights_and_spacings_are_numbers) {
  static const double spacings[] = {5e-324, 1e-101, 1e-100, 1, 1e100, 1e101, 1e300, 1e308};
  static const double bad[] = {INFINITY, -INFINITY, NAN, 1.7e308};
  asp_error wrong;
  for (size_t i = 0; i < sizeof spacings / sizeof *spacings; i++) {
    double z[] = {0, spacings[i], 0, 2 * spacings[i]};
    bool good = spacings[i] > 9e-101 && spacings[i] < 2e100;
    asp_heights *p = asp_heights_create(z, 4, 1, spacings[i], spacings[i], true, &wrong);
    assert_int_equal(p != NULL, good);
    asp_heights_free(p);
    if (!good)
      assert_says(wrong.text, "step_x is");
    for (size_t k = 0; good && k < sizeof bad / sizeof *bad; k++) {
      z[2] = bad[k];
      assert_null(asp_heights_create(z, 4, 1, spacings[i], spacings[i], true, &wrong));
      assert_int_equal(wrong.code, ASP_EARG);
      assert_says(wrong.text, "height 2 is");
    }
  }
}

TEST(separators_and_decimal_commas) {
  CHECK_ROWS("profiles.txt", check_file);
}

TEST(units_as_instruments_write_them) {
  CHECK_ROWS("profiles.txt", check_file);
  assert_near(aspi_unit_meters("mm", 2), 1e-3, 0);
  assert_near(aspi_unit_meters("parsec", 6), 0, 0);
}

TEST(units_that_must_be_asked_for) {
  CHECK_ROWS("profiles.txt", check_file);
}

/* A header of parameters, positions rounded to less than the spacing, empty columns at the end. */
TEST(an_instruments_own_file) {
  enum { N = 4000 };
  char *text = malloc(N * 32 + 400), *end = text;
  assert_non_null(text);
  end += sprintf(end, "Scan Parameters\r\nStylus,Radius: 2.5 \xB5m\r\nLength,625.0 um\r\nID,0\r\n"
                      "Location,0.0 um, 0.0 um\r\n\r\nScan Data\r\nLateral um,Raw Micrometer,\r\n");
  for (int i = 0; i < N; i++)
    end += sprintf(end, "%.1f,%.5f,,\r\n", i * 0.15625, 4 + 0.01 * i + sin(i / 50.));
  asp_heights *p = read_text(text, NULL);
  assert_non_null(p);
  assert_int_equal(p->columns, N);
  assert_near(p->step[0], 0.15625e-6, 2e-12);
  assert_null(strstr(report.text, "resampled"));
  asp_heights_numbers d;
  assert_int_equal(asp_heights_describe(p, &d, NULL), ASP_OK);
  assert_near(d.s_q, sqrt(0.5) * 1e-6, 0.02e-6);
  asp_heights_free(p);
  free(text);
}

/* Data on the first line behind a mark, read twice for their uneven spacing: a wave keeps its R_q.
 */
TEST(the_mark_of_utf8_is_no_data) {
  enum { N = 2000 };
  char *text = malloc(N * 32), *end = text;
  assert_non_null(text);
  end += sprintf(end, "\xEF\xBB\xBF");
  for (int i = 0; i < N; i++)
    end += sprintf(end, "%.5f;%.6f\n", i + 0.3 * sin(i), sqrt(2) * 0.25 * sin(i / 50.));
  aspi_profile_options o = aspi_profile_options_default();
  o.unit_x = o.unit_z = 1e-6;
  for (int k = 0; k < 2; k++) {
    asp_heights *p = read_text(text + (k ? 3 : 0), &o);
    assert_non_null(p);
    assert_says(report.text, "resampled");
    assert_says(report.text, "points read, 0 bad");
    asp_heights_numbers d;
    assert_int_equal(asp_heights_describe(p, &d, NULL), ASP_OK);
    assert_near(d.s_q, 0.25e-6, 0.003e-6);
    asp_heights_free(p);
  }
  free(text);
  CHECK_ROWS("profiles.txt", check_file);
}

/* A profile along a line in X and Y: its position is the distance along the line. */
TEST(lines_in_x_and_y) {
  CHECK_ROWS("profiles.txt", check_file);
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  char uneven[8000] = "x_um,y_um,z_um\n", *end = uneven + strlen(uneven);
  for (int i = 0; i < 200; i++) {
    double at = 5 * i + 2 * sin(i);
    end += sprintf(end, "%.4f,%.4f,%.4f\n", 7 - 0.6 * at, 0.8 * at - 9, at);
  }
  asp_heights *p = read_text(uneven, &o);
  assert_non_null(p);
  assert_says(report.text, "unequal spacing of 3.082e-06 to 6.918e-06 m resampled");
  for (int i = 0; i < 190; i++)
    assert_near(p->z[i], i * p->step[0], 1e-9);
  asp_heights_free(p);
}

/* Of text with more columns than anybody has names for. */
TEST(columns_far_to_the_right) {
  char text[2000] = "", *end = text;
  for (int line = 0; line < 4; line++)
    for (int i = 0; i < 100; i++)
      end += sprintf(end, "%d%c", i == 80 ? 1 << line : line + 1, i < 99 ? '\t' : '\n');
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  o.unit_x = o.unit_z = 1e-6;
  o.column = "81";
  expect(text, &o, 4, 1e-6, 4e-6);
  o.column = "101";
  expect_error(text, &o, "column '101' is asked for; none of the 100 columns has that");
}

/* Columns by their header: counters and times are no positions, whatever their place. */
TEST(columns_are_chosen_by_their_header) {
  CHECK_ROWS("profiles.txt", check_file);
}

/* What instruments and spreadsheets write, and what their numbers may look like. */
TEST(files_of_all_kinds) {
  CHECK_ROWS("profiles.txt", check_file);
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  o.fill = true;
  asp_heights *p = read_text("x_um,z_um\n0.00,1\n1.00,2\n1.00,3\n2.00,4\n3.00,5\n", &o);
  assert_near(p->z[1], 2.5e-6, 1e-12);
  asp_heights_free(p);
  static const char utf16[] = "\xFF\xFEx\0_\0\xB5\0m\0,\0z\0_\0\xB5\0m\0\r\0\n\0"
                              "0\0,\0001\0\r\0\n\0001\0,\0002\0\r\0\n\0002\0,\0004\0";
  p = read_bytes(utf16, sizeof utf16 - 1, &o);
  if (!p)
    fail_msg("%s", error.text);
  assert_int_equal(p->columns, 3);
  assert_near(p->z[2], 4e-6, 1e-12);
  asp_heights_free(p);
}

/* Columns of depths are turned over, by any order of the columns, and said so. */
TEST(depths_become_heights) {
  CHECK_ROWS("profiles.txt", check_file);
}

/* What cannot be what it was read as is refused with the way out. */
TEST(suspicious_numbers_are_refused) {
  CHECK_ROWS("profiles.txt", check_file);
}

/* A parabola with a ripple: degree 2 leaves the ripple. */
TEST(form_is_taken_out) {
  enum { N = 1000 };
  char *text = malloc(N * 40 + 40), *end = text;
  assert_non_null(text);
  end += sprintf(end, "x_um,z_um\n");
  for (int i = 0; i < N; i++)
    end += sprintf(end, "%d,%.9f\n", i, 3 + 0.1 * i + 1e-4 * i * i + sqrt(2) * cos(i * 0.5));
  aspi_profile_options o = aspi_profile_options_default();
  static const double r_q[] = {58.19, 7.52, 1, 1};
  for (o.form = 0; o.form < 4; o.form++) {
    asp_heights *p = read_text(text, &o);
    asp_heights_numbers d;
    assert_int_equal(asp_heights_describe(p, &d, NULL), ASP_OK);
    assert_near(d.s_q * 1e6, r_q[o.form], 0.01 * r_q[o.form]);
    asp_heights_free(p);
  }
  free(text);
}

TEST(gaps_are_refused_or_filled) {
  CHECK_ROWS("profiles.txt", check_file);
}

/* Rows that are not there are a gap, too. */
TEST(missing_rows_are_a_gap) {
  CHECK_ROWS("profiles.txt", check_file);
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  o.fill = true;
  const char *text = "x_m,z_m\n0,1\n1,2\n2,4\n3,1\n8,6\n9,2\n10,1\n11,5\n";
  asp_heights *p = read_text(text, &o);
  assert_int_equal(report.longest_gap, 4);
  for (int i = 3; i <= 8; i++)
    assert_near(p->z[i], 1 + (i - 3), 1e-12);
  asp_heights_free(p);
}

TEST(unequal_spacing_is_resampled) {
  CHECK_ROWS("profiles.txt", check_file);
}

TEST(spikes_are_marked_where_asked) {
  char text[4000] = "x_um,z_um\n", *end = text + strlen(text);
  for (int i = 0; i < 200; i++)
    end += sprintf(end, "%d,%.6f\n", i, i == 77 ? 50 : sin(i * 0.2) + 0.01 * (i % 3));
  aspi_profile_options o = aspi_profile_options_default();
  asp_heights *p = read_text(text, &o);
  assert_true(p->z[77] > 40e-6);
  asp_heights_free(p);
  o.spikes = 10;
  expect_error(text, &o,
               "point 78 is the first of 1 spikes; fill the gaps (asperity surface --gaps fill "
               "--save FILE)");
  o.fill = true;
  p = read_text(text, &o);
  assert_near(p->z[77], sin(77 * 0.2) * 1e-6, 0.2e-6);
  assert_int_equal(report.spikes, 1);
  assert_int_equal(report.filled, 1);
  asp_heights_free(p);
}

/* Dust, heights in steps and heights that are cut off are each called what they are. */
TEST(warnings_have_their_names) {
  enum { N = 3000 };
  static const struct {
    double quantum, low, high, dust;
    const char *name; /* NULL: no doubt */
  } all[] = {{1e-3, -99, 99, 0, NULL},
             {0.05, -99, 99, 0, NULL}, /* rounded, most neighbors are equal */
             {1e-3, -99, 99, 30, "of 3000 points lie over 20 robust"},
             {0.05, -99, 99, 30, "of 3000 points lie over 20 robust"},
             {0.6, -99, 99, 0, "quantized, 8 levels of 0.6 um"},
             {1e-3, -99, 1.2, 0, "points have the highest one"},
             {1e-3, -1.2, 99, 0, "points have the lowest one"}};
  char *text = malloc(N * 32);
  assert_non_null(text);
  asp_heights *p = aspi_profile_generate(1, 60, 1, N, 3, NULL);
  for (size_t k = 0; k < sizeof all / sizeof *all; k++) {
    char *end = text + sprintf(text, "x_um,z_um\n");
    for (int i = 0; i < N; i++) {
      double z = p->z[i] + (i == 1500 ? all[k].dust : 0);
      z = fmin(fmax(z, all[k].low), all[k].high);
      end += sprintf(end, "%d,%.6f\n", i, all[k].quantum * round(z / all[k].quantum));
    }
    asp_heights_free(read_text(text, NULL));
    if (all[k].name ? !strstr(report.warnings, all[k].name) : *report.warnings)
      fail_msg("case %zu: '%s'", k, report.warnings);
    assert_true(all[k].dust > 0 || !strstr(report.warnings, "dust"));
  }
  asp_heights_free(p);
  free(text);
  assert_int_equal(aspi_sampling_check(10, 1, 20, 1, &error), ASP_OK);
  assert_int_equal(aspi_sampling_check(9.9, 1, 20, 1, &error), ASP_ERANGE);
  assert_says(error.text, "d_p 9.9 covers 9.9 points");
  assert_int_equal(aspi_sampling_check(10, 1, 19, 1, &error), ASP_ERANGE);
  assert_says(error.text, "only 19 correlation lengths long");
}

/* Most points are off their neighbors by more than nearly nothing; what is left of them must not
 * be stretched over the others, nor reach GSL's solver and its error handler. */
TEST(more_spikes_than_points_are_refused) {
  char *text = malloc(20000 * 24), *end = text;
  assert_non_null(text);
  end += sprintf(end, "x_um,z_um\n");
  for (int i = 0; i < 20000; i++)
    end += sprintf(end, "%.1f,%.6f\n", 0.5 * i, i < 14 ? 0 : sin(i * 1.7) + sin(i * i * 0.37));
  aspi_profile_options o = aspi_profile_options_default();
  o.fill = true;
  for (o.form = -1; o.form <= ASP_FORM_MAX; o.form++)
    for (o.spikes = 1e-9; o.spikes < 1e-3; o.spikes *= 100)
      expect_error(text, &o, "more than half of");
  free(text);
}

TEST(bad_files_are_named_with_their_line) {
  CHECK_ROWS("profiles.txt", check_file);
  assert_null(read_bytes("x_um,z_um\n0,\0001\n", 15, NULL));
  assert_says(error.text, ":2: a NUL byte");
  char longest[5000];
  memset(longest, 'x', sizeof longest);
  assert_null(read_bytes(longest, sizeof longest, NULL));
  assert_says(error.text, "without a line of two numbers");
  assert_null(aspi_read(NULL, "/nowhere/profile.csv", false, NULL, NULL, &error));
  assert_int_equal(error.code, ASP_EFILE);
  assert_says(error.text, "/nowhere/profile.csv");
}

/* ---- SDF ---- */

TEST(sections_of_a_map) {
  CHECK_ROWS("profiles.txt", check_file);
}

TEST(bad_maps_are_named_with_their_line) {
  CHECK_ROWS("profiles.txt", check_file);
}

/* What engines read: the defaults, in their unit, with a sentence and doubts. */
TEST(defaults_of_engines) {
  char path[] = "/tmp/test_profile.XXXXXX", text[700];
  asp_error doubt;
  FILE *file = fdopen(mkstemp(path), "w");
  fputs("x_mm,z_um\n", file);
  for (int i = 0; i < 400; i++)
    fprintf(file, "%d,%.3f\n", i, i == 300 ? 90 : 0.1 * i + sin(i));
  fclose(file);
  asp_heights *p = asp_heights_read(path, false, 1e6, text, sizeof text, &doubt, &error);
  unlink(path);
  assert_non_null(p);
  assert_int_equal(p->columns, 400);
  assert_near(p->step[0], 1e3, 1e-9);
  assert_near(p->z[100] - p->z[102], sin(100) - sin(102), 0.02);
  assert_string_equal(text, "400 points read, 0 bad, polynomial of degree 1 taken out");
  assert_int_equal(doubt.code, ASP_EDATA);
  assert_says(doubt.text, "1 of 400 points lie over 20");
  asp_heights_free(p);
}

/* A wave, rounded to twelve digits; heights in units of `rise` m over positions in units of `run`
 * m.
 */
static void write_wave(const char *path, const char *units, double run, double rise, int points,
                       double step, double amplitude, double wave) {
  FILE *file = fopen(path, "w");
  fprintf(file, "%s\n", units);
  for (int i = 0; i < points; i++)
    fprintf(file, "%.12g,%.12g\n", i * step / run,
            (7e-6 + amplitude * sin(2 * ASP_PI * i * step / wave)) / rise);
  fclose(file);
}

/* Waves of 10 and 25 um in files of different units, steps and lengths (1 and 3 mm). Numbers by
 * length: mean squares of heights and slopes, and the autocorrelation, a mean of two cosines. */
TEST(several_profiles_are_one_wall) {
  char folder[] = "/tmp/test_profile.XXXXXX", list[200], names[3][60];
  assert_non_null(mkdtemp(folder));
  const char *const name[] = {"one.csv", "two.csv", "with,comma.csv"};
  for (int i = 0; i < 3; i++)
    snprintf(names[i], sizeof names[i], "%s/%s", folder, name[i]);
  write_wave(names[0], "x_um,z_um", 1e-6, 1e-6, 4000, 0.25e-6, 0.1e-6, 10e-6);
  write_wave(names[1], "x_mm,z_nm", 1e-3, 1e-9, 7500, 0.4e-6, 0.3e-6, 25e-6);
  write_wave(names[2], "x_um,z_um", 1e-6, 1e-6, 4000, 0.25e-6, 0.1e-6, 10e-6);
  aspi_profile_options o = aspi_profile_options_default();
  o.form = 0; /* a line through a sine is not level */
  snprintf(list, sizeof list, "%s,%s", names[0], names[1]);
  asp_heights *p = aspi_read(NULL, list, false, &o, &report, &error);
  assert_non_null(p);
  assert_says(report.text, "one.csv: 4000 points read");
  assert_says(report.text, "two.csv: 7500 points read");
  asp_heights_numbers d;
  assert_int_equal(asp_heights_describe(p, &d, &error), ASP_OK);
  double square[] = {0.5 * 0.1 * 0.1 * 0.25, 0.5 * 0.3 * 0.3 * 0.75}; /* um^2 by length */
  double turns[] = {2 * ASP_PI / 10, 2 * ASP_PI / 25}, all = square[0] + square[1];
  double gradient = square[0] * turns[0] * turns[0] + square[1] * turns[1] * turns[1];
  double lag = d.lambda_1 * 1e6;
  assert_near(d.s_q, 1e-6 * sqrt(all), 1e-4 * d.s_q);
  assert_near(d.s_a, 2e-6 / ASP_PI * (0.25 * 0.1 + 0.75 * 0.3), 1e-3 * d.s_a);
  assert_near(d.s_dq, sqrt(gradient), 0.003 * d.s_dq);
  assert_near(square[0] / all * cos(turns[0] * lag) + square[1] / all * cos(turns[1] * lag),
              exp(-1), 0.003);
  asp_heights_free(p);
  p = aspi_read(NULL, names[2], false, &o, &report, &error); /* one file */
  assert_int_equal(p->columns, 4000);
  assert_null(p->next);
  asp_heights_free(p);
  snprintf(list, sizeof list, "%s,%s/none.csv", names[0], folder);
  assert_null(aspi_read(NULL, list, false, &o, NULL, &error));
  assert_says(error.text, "none.csv': No such file");
  assert_says(error.text, "commas separate names");
  snprintf(list, sizeof list, "%s,,%s", names[0], names[1]);
  assert_null(aspi_read(NULL, list, false, &o, NULL, &error));
  assert_says(error.text, "one of several profiles is ''");
  snprintf(list, sizeof list, "%s,\"%s\"", names[0], names[2]);
  p = aspi_read(NULL, list, false, &o, NULL, &error);
  assert_int_equal(p->next->columns, 4000);
  asp_heights_free(p);
  for (int i = 0; i < 3; i++)
    unlink(names[i]);
  rmdir(folder);
}
