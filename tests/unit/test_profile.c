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
  assert_non_null(strstr(e.text, "lambda_c/4"));
  assert_null(aspi_profile_generate(1, 1, 0.1, 199, 1, &e));
  assert_non_null(strstr(e.text, "over 20 lambda_c"));
  double z[4] = {1, 1, 1, 1};
  assert_null(asp_heights_create(z, 2, 1, 1, 1, false, &e));
  assert_null(asp_heights_create(z, 4, 1, -1, -1, false, &e));
  asp_heights *flat = asp_heights_create(z, 4, 1, 1, 1, false, &e);
  asp_heights_numbers d;
  assert_int_equal(asp_heights_describe(flat, &d, &e), ASP_EDATA);
  assert_non_null(strstr(e.text, "constant"));
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
  aspi_profile_options plain = options ? *options : aspi_profile_options_default();
  if (!options)
    plain.form = -1;
  asp_heights *p = read_text(text, &plain);
  if (!p)
    print_error("%s\n", error.text);
  assert_non_null(p);
  assert_int_equal(p->columns, points);
  assert_near(p->step[0], spacing, 1e-9 * spacing);
  assert_near(p->z[2], third, 1e-9 * fabs(third));
  assert_false(p->periodic);
  asp_heights_free(p);
}

static void expect_error(const char *text, const aspi_profile_options *options, asp_code code,
                         const char *message) {
  assert_null(read_text(text, options));
  if (!strstr(error.text, message))
    print_error("'%s' is not in '%s'\n", message, error.text);
  assert_int_equal(error.code, code);
  assert_non_null(strstr(error.text, message));
  assert_non_null(strstr(error.text, "/tmp/asperity_test_"));
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
      assert_non_null(strstr(wrong.text, "step_x is"));
    for (size_t k = 0; good && k < sizeof bad / sizeof *bad; k++) {
      z[2] = bad[k];
      assert_null(asp_heights_create(z, 4, 1, spacings[i], spacings[i], true, &wrong));
      assert_int_equal(wrong.code, ASP_EARG);
      assert_non_null(strstr(wrong.text, "height 2 is"));
    }
  }
}

TEST(separators_and_decimal_commas) {
  expect("x_um,z_um\n0,1\n0.5,2\n1,4\n", NULL, 3, 0.5e-6, 4e-6);
  expect("x [mm]; z [nm]\r\n0,0;1,5\r\n0,1;2,5\r\n0,2;4,25\r\n", NULL, 3, 0.1e-3, 4.25e-9);
  expect("# x_um\tz_um\n0\t1\n2\t3\n4\t4\n", NULL, 3, 2e-6, 4e-6);
  expect("# x_um\tz_um\n0,0\t1,5\n2,5\t3\n5,0\t4\n", NULL, 3, 2.5e-6, 4e-6);
  expect("Length (um)  Height (um)\n  0   1\n  2   3\n\n  4   4e0\n", NULL, 3, 2e-6, 4e-6);
  expect("x_um z_um\r0 1\r2 3\r4 4\r", NULL, 3, 2e-6, 4e-6);
  expect("\xEF\xBB\xBFx_um,z_um\n0,1\n0.5,2\n1,4", NULL, 3, 0.5e-6, 4e-6);
}

TEST(units_as_instruments_write_them) {
  expect("Lateral um,Raw Micrometer,\n0,1,,\n1,2,,\n2,4,,\n", NULL, 3, 1e-6, 4e-6);
  expect("x/\xB5m;z/nm\n0;1\n1;2\n2;4\n", NULL, 3, 1e-6, 4e-9);
  expect("x (\xC2\xB5m)\tz (\xCE\xBCm)\n0\t1\n1\t2\n2\t4\n", NULL, 3, 1e-6, 4e-6);
  expect("x [mm],z [\xC3\x85]\n0,1\n1,2\n2,4\n", NULL, 3, 1e-3, 4e-10);
  expect("X(MM) Z(UM)\n0 1\n1 2\n2 4\n", NULL, 3, 1e-3, 4e-6);
  assert_near(aspi_unit_meters("mm", 2), 1e-3, 0);
  assert_near(aspi_unit_meters("parsec", 6), 0, 0);
}

TEST(units_that_must_be_asked_for) {
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  expect_error("0,1\n1,2\n2,4\n", NULL, ASP_EDATA, ":1: no unit of length is stated");
  expect_error("Stylus 2.5 um\nLength 3 mm\nx,z\n0,1\n1,2\n2,4\n", NULL, ASP_EDATA, ":4: no unit");
  expect_error("x (um),z\n0,1\n1,2\n2,4\n", NULL, ASP_EDATA,
               "no unit of length is stated of column 2");
  o.unit_x = 1e-3;
  expect_error("0,1\n1,2\n2,4\n", &o, ASP_EDATA, "no unit");
  o.unit_z = 1e-6;
  expect("0,1\n1,2\n2,4\n", &o, 3, 1e-3, 4e-6);
  expect("x_nm,z_nm\n0,1\n1,2\n2,4\n", &o, 3, 1e-3, 4e-6);
  o.meter = 1e6;
  expect("0,1\n1,2\n2,4\n", &o, 3, 1e3, 4);
  o.column = "3";
  expect("x,a,z\n0,1,7\n1,2,8\n2,4,9\n", &o, 3, 1e3, 9);
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
    assert_non_null(strstr(report.text, "resampled"));
    assert_non_null(strstr(report.text, "points read, 0 bad"));
    asp_heights_numbers d;
    assert_int_equal(asp_heights_describe(p, &d, NULL), ASP_OK);
    assert_near(d.s_q, 0.25e-6, 0.003e-6);
    asp_heights_free(p);
  }
  free(text);
  expect("\xEF\xBB\xBF" SDF_HEAD "*\n1 2 3 4 1 2 3 4 1 2 3 4\n*\n", NULL, 4, 2e-6, 3e-6);
}

/* A profile along a line in X and Y: its position is the distance along the line. */
TEST(lines_in_x_and_y) {
  const char *turned = "X [um],Y [um],Z [um]\n10,7,1\n9,8,2\n8,9,4\n7,10,8\n";
  expect("X [um],Y [um],Z [um]\n10,7,1\n13,11,2\n16,15,4\n19,19,8\n", NULL, 4, 5e-6, 4e-6);
  assert_non_null(strstr(report.text, "distances in columns 1 and 2, heights of column 3"));
  expect("X;Y;Z\nmm;um;um\n0,003;0;1\n0,006;4;2\n0,009;8;4\n", NULL, 3, 5e-6, 4e-6);
  expect("x_um y_um z_um\n3 0 1\n3 2 2\n3 4 4\n", NULL, 3, 2e-6, 4e-6);
  expect("x_um y_um z_um\n3 5 1\n2 5 2\n1 5 4\n0 5 8\n", NULL, 4, 1e-6, 2e-6); /* X falls */
  assert_non_null(strstr(report.text, "positions fall"));
  expect(turned, NULL, 4, sqrt(2) * 1e-6, 2e-6); /* toward X */
  expect_error("x_um y_um z_um\n0 0 1\n3 0 2\n3 4 3\n6 8 4\n", NULL, ASP_EDATA,
               "are not on a line");
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  o.x_column = "X";
  expect(turned, &o, 4, 1e-6, 2e-6);
  o.x_column = NULL;
  char uneven[8000] = "x_um,y_um,z_um\n", *end = uneven + strlen(uneven);
  for (int i = 0; i < 200; i++) {
    double at = 5 * i + 2 * sin(i);
    end += sprintf(end, "%.4f,%.4f,%.4f\n", 7 - 0.6 * at, 0.8 * at - 9, at);
  }
  asp_heights *p = read_text(uneven, &o);
  assert_non_null(p);
  assert_non_null(strstr(report.text, "unequal spacing of 3.082e-06 to 6.918e-06 m resampled"));
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
  expect_error(text, &o, ASP_EDATA, "column '101' is asked for; none of the 100 columns has that");
}

/* Columns by their header: counters and times are no positions, whatever their place. */
TEST(columns_are_chosen_by_their_header) {
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  expect("Point,X [um],Z [um]\n1,0,1\n2,2,2\n3,4,4\n", NULL, 3, 2e-6, 4e-6);
  expect("t [s],x [um],z [nm]\n0.1,0,1\n0.2,2,2\n0.3,4,4\n", NULL, 3, 2e-6, 4e-9);
  expect("t/s\tz/um\tx/um\n0,1\t1\t0\n0,2\t2\t2\n0,3\t4\t4\n", NULL, 3, 2e-6, 4e-6);
  expect("X;Y;Z\num;um;nm\n0;7;1\n2;7;2\n4;7;4\n", NULL, 3, 2e-6, 4e-9);
  expect("Index Position Height\n# mm mm mm\n1 0 1\n2 2 2\n3 4 4\n",
         &(aspi_profile_options){
             .meter = 1, .form = -1, .row = 1, .missing = NAN, .unit_x = 1e-3, .unit_z = 1e-3},
         3, 2e-3, 4e-3);
  expect_error("Point,Z [um]\n1,0\n2,1\n3,4\n", NULL, ASP_EDATA,
               "no column is named as a position");
  expect("Punkt;Weg;Hoehe\n;mm;um\n1;0,0;1\n2;2,0;2\n3;4,0;4\n", NULL, 3, 2e-3, 4e-6);
  expect("N\tX\tZ\n\tmm\tum\n1\t0\t1\n2\t2\t2\n3\t4\t4\n", NULL, 3, 2e-3, 4e-6);
  assert_non_null(strstr(report.text, "of columns 2 and 3"));
  expect("No  x [mm]  z [um]\n1 0 1\n2 2 2\n3 4 4\n", NULL, 3, 2e-3, 4e-6);
  expect_error("Point,t [s],Z [um]\n1,0,4\n2,1,3\n3,4,3\n", NULL, ASP_EDATA,
               "no column is named as a position");
  expect_error("a [um],b [um],c [um]\n0,1,4\n1,2,4\n2,4,3\n", NULL, ASP_EDATA,
               "no column is named as a height; say which columns");
  o.unit_x = o.unit_z = 1e-6;
  static const char *const no_length[] = {"n,Z [um]", "x [px],z [um]", "Time,z"};
  for (size_t i = 0; i < sizeof no_length / sizeof *no_length; i++) {
    char file[80];
    snprintf(file, sizeof file, "%s\n0,1\n1,2\n2,4\n", no_length[i]);
    expect_error(file, &o, ASP_EDATA, "no column is named as a position");
  }
  expect("Height,Distance\n1,0\n2,2\n4,4\n", &o, 3, 2e-6, 4e-6);
  expect_error("1 0 7\n2 1 8\n3 2 9\n", &o, ASP_EDATA, ":1: 3 columns under 0 names");
  expect_error("\"x\" \"z\"\n\"1\" 0 7\n\"2\" 1 8\n", &o, ASP_EDATA, "3 columns under 0 names");
  expect_error("x,z\n1,0,7\n2,1,8\n3,2,9\n", &o, ASP_EDATA, "3 columns under 2 names");
  o.step[0] = 2e-6;
  expect_error("1,7\n2,8\n3,9\n", &o, ASP_EDATA, "2 columns under 0 names");
  expect_error("time [s],angle [deg],n\n1,7,1\n2,8,2\n", &o, ASP_EDATA, "no column is named");
  o.step[0] = o.unit_x = o.unit_z = 0;
  o.x_column = o.column = "1";
  expect_error("x [um],z [um]\n0,9\n2,9\n4,9\n", &o, ASP_EDATA, "as positions and as heights");
  o.x_column = "b";
  o.column = "1";
  expect("a [um],b [um],z [um]\n1,0,9\n2,2,9\n4,4,9\n", &o, 3, 2e-6, 4e-6);
  o.x_column = "c";
  expect_error("a [um],b [um],z [um]\n1,0,9\n2,2,9\n4,4,9\n", &o, ASP_EDATA,
               "none of the 3 columns has that name");
  o.x_column = "4";
  expect_error("a [um],b [um],z [um]\n1,0,9\n2,2,9\n4,4,9\n", &o, ASP_EDATA,
               "none of the 3 columns has that");
}

/* What instruments and spreadsheets write, and what their numbers may look like. */
TEST(files_of_all_kinds) {
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  o.fill = true;
  expect("x [inch],z [inch]\n0,1\n1,2\n2,4\n", NULL, 3, 25.4e-3, 4 * 25.4e-3);
  expect("x_um,z_um\n4,4\n2,2\n0,1\n-2,7\n", NULL, 4, 2e-6, 2e-6);
  assert_non_null(strstr(report.text, "positions fall"));
  expect("x_um,z_um\n0.00,1\n1.00,2\n1.00,3\n2.00,4\n3.00,5\n", NULL, 4, 1e-6, 4e-6);
  assert_non_null(strstr(report.text, ", 1 repeated positions averaged"));
  asp_heights *p = read_text("x_um,z_um\n0.00,1\n1.00,2\n1.00,3\n2.00,4\n3.00,5\n", &o);
  assert_near(p->z[1], 2.5e-6, 1e-12);
  asp_heights_free(p);
  expect("x_um,z_um\n0,1\n1,2\n2,4\nRa,1.2\nend of file\n", NULL, 3, 1e-6, 4e-6);
  assert_non_null(strstr(report.text, "data end before line 5"));
  expect("\"x [um]\",\"z [um]\"\n\"0\",\"1\"\n\"1\",\"2\"\n\"2\",\"4\"\n", NULL, 3, 1e-6, 4e-6);
  expect("x_um,z_um\n0.0D+00,1.0D+00\n1.0D+00,2.0d0\n2.0D0,4.0D+00\n", NULL, 3, 1e-6, 4e-6);
  expect_error("x_um;z_um\n0;1\n1;2\n2;3\n3;1.004,5\n4;2\n", NULL, ASP_EDATA, "1.004,5");
  expect("x_um,z_um\n0,1\n1,inf\n2,3\n3,#NUM!\n4,5\n5,9\n", &o, 6, 1e-6, 3e-6);
  assert_non_null(strstr(report.text, "points read, 2 bad"));
  o.missing = 7;
  expect("x_um,z_um\n0,1\n1,7\n2,3\n3,7.0\n4,5\n5,9\n", &o, 6, 1e-6, 3e-6);
  assert_non_null(strstr(report.text, "points read, 2 bad"));
  o.missing = NAN;
  o.step[0] = 2e-6;
  expect("Z [um]\n1\n2\n4\n", &o, 3, 2e-6, 4e-6);
  o.step[0] = 0;
  expect_error("Z [um]\n1\n2\n4\n", &o, ASP_EDATA, "heights alone of a profile need the step");
  expect("x [in],z [\xC2\xB5"
         "in]\n0,1\n1,2\n2,4\n",
         NULL, 3, 25.4e-3, 4 * 25.4e-9);
  expect("x_um;z_um\n0;1\n1;\342\210\2222\n2;\342\210\2224\n", NULL, 3, 1e-6, -4e-6);
  expect("x_um,z_um\n\"0,000\",\"1,5\"\n\"0,500\",\"2,5\"\n\"1,000\",\"4,5\"\n", NULL, 3, 0.5e-6,
         4.5e-6);
  expect("x_um,z_um\n0,1\n1,******\n2,3\n3,#VALUE!\n4,5\n5,9\n", &o, 6, 1e-6, 3e-6);
  assert_non_null(strstr(report.text, "points read, 2 bad"));
  static const char utf16[] = "\xFF\xFEx\0_\0\xB5\0m\0,\0z\0_\0\xB5\0m\0\r\0\n\0"
                              "0\0,\0001\0\r\0\n\0001\0,\0002\0\r\0\n\0002\0,\0004\0";
  p = read_bytes(utf16, sizeof utf16 - 1, &o);
  if (!p)
    print_error("%s\n", error.text);
  assert_non_null(p);
  assert_int_equal(p->columns, 3);
  assert_near(p->z[2], 4e-6, 1e-12);
  asp_heights_free(p);
}

/* Columns of depths are turned over, by any order of the columns, and said so. */
TEST(depths_become_heights) {
  static const char *const names[] = {"x_um,depth_um", "x [um],Depth [um]", "Weg [um],Tiefe [um]"};
  for (int i = 0; i < 3; i++) {
    char file[80];
    snprintf(file, sizeof file, "%s\n0,1\n1,2\n2,4\n", names[i]);
    expect(file, NULL, 3, 1e-6, -4e-6);
    assert_non_null(strstr(report.text, "depths turned into heights"));
  }
  expect("depth_um,x_um\n1,0\n2,1\n4,2\n", NULL, 3, 1e-6, -4e-6);
  expect("x_um,depth_um,height_um\n0,1,1\n1,2,2\n2,9,4\n", NULL, 3, 1e-6, -9e-6);
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  o.column = "height";
  expect("x_um,depth_um,height_um\n0,9,1\n1,9,2\n2,9,4\n", &o, 3, 1e-6, 4e-6);
  assert_null(strstr(report.text, "depths"));
  o.column = "2";
  o.fill = true;
  o.missing = 7;
  expect("x_um,depth_um,height_um\n0,1,1\n1,7,2\n2,3,4\n", &o, 3, 1e-6, -3e-6);
}

/* What cannot be what it was read as is refused with the way out. */
TEST(suspicious_numbers_are_refused) {
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  const char *marked = "x_um,z_um\n0,1\n1,-9999\n2,3\n3,2\n4,5\n";
  expect_error(marked, &o, ASP_EDATA, ":3: height -9999 beside heights of 1 to 5");
  o.missing = -9999;
  expect_error(marked, &o, ASP_EDATA, ":3: the first of 1 bad or missing points");
  o.fill = true;
  expect(marked, &o, 5, 1e-6, 3e-6);
  expect("x_um,z_um\n0,1000\n1,-999\n2,300\n3,200\n4,500\n", NULL, 5, 1e-6, 300e-6);
  expect_error("x_um,z_um\n0,500,1,234\n0,750,1,334\n1,000,1,224\n", NULL, ASP_EDATA,
               ":2: 4 columns under 2 names (or are there decimal commas?");
  expect_error("x_um,z_um\n0,5\n0,5,1,25\n1,1,25\n", NULL, ASP_EDATA, ":3: 4 fields, the first");
  o.x_column = "1";
  o.column = "4";
  expect("x_um,b,c,z_um\n0,500,1,234\n1,750,1,334\n2,000,1,224\n", &o, 3, 1e-6, 224e-6);
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
  static const char *const files[] = {
      "x_m,z_m\n0,1\n1,nan\n2,3\n3,7\n4,5\n", "x_m,z_m\n0,1\n1,\n2,3\n3,7\n4,5\n",
      "x_m,z_m\n0,1\n1,inf\n2,3\n3,7\n4,5\n", "x_m,z_m\n0,1\n1,BAD\n2,3\n3,7\n4,5\n",
      "x_m,z_m\n0,1\n1,---\n2,3\n3,7\n4,5\n"};
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
    o.fill = false;
    expect_error(files[i], &o, ASP_EDATA, ":3: the first of 1 bad or missing points");
    o.fill = true;
    expect(files[i], &o, 5, 1, 3);
    assert_non_null(strstr(report.text, "points read, 1 bad"));
    assert_int_equal(report.filled, 1);
    assert_non_null(strstr(report.text, "1 points filled in"));
  }
  expect("x_m,z_m\n0,nan\n1,1\n2,2\n3,4\n4,nan\n", &o, 3, 1, 4);
  expect_error("x_m,z_m\n0,1\n1,nan\n2,nan\n3,nan\n4,5\n", &o, ASP_EDATA,
               "more than half of 5 points");
}

/* Rows that are not there are a gap, too. */
TEST(missing_rows_are_a_gap) {
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  const char *text = "x_m,z_m\n0,1\n1,2\n2,4\n3,1\n8,6\n9,2\n10,1\n11,5\n";
  expect_error(text, &o, ASP_EDATA, ":6: the first of 4 bad or missing points");
  o.fill = true;
  expect(text, &o, 12, 1, 4);
  assert_int_equal(report.longest_gap, 4);
  asp_heights *p = read_text(text, &o);
  for (int i = 3; i <= 8; i++)
    assert_near(p->z[i], 1 + (i - 3), 1e-12);
  asp_heights_free(p);
  assert_non_null(strstr(report.text, "resampled"));
}

TEST(unequal_spacing_is_resampled) {
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  const char *text = "x_m,z_m\n0.00,0\n1.00,2\n1.50,3\n3.00,6\n4.00,8\n5.00,5\n";
  expect(text, &o, 6, 1, 4);
  assert_non_null(strstr(report.text, "resampled"));
  assert_non_null(strstr(report.text, "resampled to 1 m"));
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
  expect_error(text, &o, ASP_EDATA,
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
  assert_non_null(strstr(error.text, "d_p 9.9 covers 9.9 points"));
  assert_int_equal(aspi_sampling_check(10, 1, 19, 1, &error), ASP_ERANGE);
  assert_non_null(strstr(error.text, "only 19 correlation lengths long"));
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
      expect_error(text, &o, ASP_EDATA, "more than half of");
  free(text);
}

TEST(bad_files_are_named_with_their_line) {
  expect_error("", NULL, ASP_EDATA, ":1: the file ends without a line of two numbers");
  expect_error("x_um,z_um\n", NULL, ASP_EDATA, "without a line of two numbers");
  expect_error("hello\nworld\n", NULL, ASP_EDATA, "without a line of two numbers");
  expect_error("x_um,z_um\n0,1\n", NULL, ASP_EDATA, "after 1 point,");
  expect_error("x_um,z_um\n0,1\n1,2\n", NULL, ASP_EDATA, "after 2 points");
  expect_error("x_um,z_um\n0,1\n1,2\ntwo,3\n", NULL, ASP_EDATA, ":4: 'two,3' is not a number");
  expect_error("x_um,z_um\n0,1\n1,2\nnan,3\n", NULL, ASP_EDATA, ":4: ");
  expect_error("x_um,z_um\n0,1\n2,2\n1,3\n", NULL, ASP_EDATA,
               ":4: position 1 comes after 2; positions must all increase");
  expect_error("x_um,z_um\n1,1\n1,2\n1,3\n1,5\n", NULL, ASP_EDATA, "from 1 to 1");
  expect_error("x_um,z_um\n0,1\n1,1\n2,1\n", NULL, ASP_EDATA, "the profile is constant");
  expect_error("x_um,z_um\n0,1\n1,2\n2,3\n3,4\n", NULL, ASP_EDATA, "constant but for its form");
  expect_error("x_m,z_m\n0,1e300\n1,2\n2,1\n", NULL, ASP_EDATA, "check the unit");
  expect_error("x_m,z_m\n0,1\n1e-300,2\n2e-300,1\n", NULL, ASP_EDATA, "check the unit");
  assert_null(read_bytes("x_um,z_um\n0,\0001\n", 15, NULL));
  assert_non_null(strstr(error.text, ":2: a NUL byte"));
  char longest[5000];
  memset(longest, 'x', sizeof longest);
  assert_null(read_bytes(longest, sizeof longest, NULL));
  assert_non_null(strstr(error.text, "without a line of two numbers"));
  assert_null(aspi_read(NULL, "/nowhere/profile.csv", false, NULL, NULL, &error));
  assert_int_equal(error.code, ASP_EFILE);
  assert_non_null(strstr(error.text, "/nowhere/profile.csv"));
}

/* ---- SDF ---- */

TEST(sections_of_a_map) {
  const char *map =
      SDF_HEAD "*\r\n1 2\r\n 4 3 10 20 40 30\r\n100 200 400 300\r\n*\r\n<Name> T\r\n*";
  aspi_profile_options o = aspi_profile_options_default();
  o.form = -1;
  expect(map, &o, 4, 2e-6, 4e-6);
  o.row = 3;
  expect(map, &o, 4, 2e-6, 400e-6);
  o.column = "4";
  expect(map, &o, 3, 3e-6, 300e-6);
  o.column = "5";
  expect_error(map, &o, ASP_EDATA, "column 5 is asked for; the map has 4");
  o.column = NULL;
  o.row = 4;
  expect_error(map, &o, ASP_EDATA, "row 4 is asked for; the map has 3");
  o.row = 1;
  const char *bad = SDF_HEAD "*\n1 BAD 4 3 10 20 40 30 1 2 4 3 *\n";
  expect_error(bad, &o, ASP_EDATA, ":11: the first of 1 bad");
  o.fill = true;
  expect(bad, &o, 4, 2e-6, 4e-6);
}

TEST(bad_maps_are_named_with_their_line) {
  expect_error("aISO-1.0\nNumPoints = 4\n", NULL, ASP_EDATA, ":3: the file ends within the SDF");
  expect_error("aISO-1.0\nNumPoints = 4\nNumProfi", NULL, ASP_EDATA, ":3: 'NumProfi' where");
  expect_error("aISO-1.0\n*\n1 2 3\n", NULL, ASP_EDATA, ":2: the header ends without NumPoints");
  expect_error("aISO-1.0\nNumPoints=3\nNumProfiles=1\nXscale=1\n*\n1 2 1\n", NULL, ASP_EDATA,
               "without Zscale");
  expect_error("aISO-1.0\nNumPoints=many\n", NULL, ASP_EDATA, ":2: NumPoints is 'many'");
  expect_error("aISO-1.0\nNumPoints=2.5\nNumProfiles=1\n*\n", NULL, ASP_EDATA, "NumPoints is 2.5");
  expect_error("aISO-1.0\nNumPoints=3\nNumProfiles=1\nXscale=0\nZscale=1\n*\n1 2 1\n", NULL,
               ASP_EDATA, "Xscale is 0");
  expect_error("bISO-1.0\nNumPoints=3\n", NULL, ASP_EDATA, "ends within its header");
  expect_error(SDF_HEAD "*\n1 2 3\n", NULL, ASP_EDATA, "the heights end after 3");
  expect_error(SDF_HEAD "*\n1 2 3 4 1 2 3 4 1 2 3 4 5\n*\n", NULL, ASP_EDATA, "'5' after the last");
  expect_error(SDF_HEAD "*\n1 2 x\n", NULL, ASP_EDATA, "'x' where a height is expected");
  expect_error("aISO-1.0\nNumPoints=3\nNumProfiles=1\nXscale=1\nZscale=1\nCompression=1\n*\n1\n",
               NULL, ASP_EDATA, "Compression is 1");
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
  assert_non_null(strstr(doubt.text, "1 of 400 points lie over 20"));
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
  assert_non_null(strstr(report.text, "one.csv: 4000 points read"));
  assert_non_null(strstr(report.text, "two.csv: 7500 points read"));
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
  assert_non_null(strstr(error.text, "none.csv': No such file"));
  assert_non_null(strstr(error.text, "commas separate names"));
  snprintf(list, sizeof list, "%s,,%s", names[0], names[1]);
  assert_null(aspi_read(NULL, list, false, &o, NULL, &error));
  assert_non_null(strstr(error.text, "one of several profiles is ''"));
  snprintf(list, sizeof list, "%s,\"%s\"", names[0], names[2]);
  p = aspi_read(NULL, list, false, &o, NULL, &error);
  assert_int_equal(p->next->columns, 4000);
  asp_heights_free(p);
  for (int i = 0; i < 3; i++)
    unlink(names[i]);
  rmdir(folder);
}
