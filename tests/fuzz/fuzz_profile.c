/* Fuzzing of the readers of profile and map files: whatever the bytes, a reader returns a profile
 * that can be described and closed, or a map that can be described, or an error with a message, and
 * no sanitizer has anything to say. LLVMFuzzerTestOneInput is for libFuzzer; without it (FUZZ_MAIN)
 * this is a program of its own that mutates made-up files, the same ones every time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/stream.h"
#include "surface/rolling.h"
#include "surface/describe.h"
#include "readers/read.h"
#include "surface/slopes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS_MOST = 1 << 16 };

static void fail(const char *what) {
  fprintf(stderr, "fuzz_profile: %s\n", what);
  abort();
}

static void check_profile(const asp_heights *profile) {
  size_t points = profile->columns, count;
  double spacing = profile->step[0];
  if (points < 3 || !(spacing > 0) || !isfinite(spacing))
    fail("a profile without points or spacing");
  for (size_t i = 0; i < points; i++)
    if (!isfinite(profile->z[i]))
      fail("a height that is not a number");
  if (points > POINTS_MOST)
    return;
  asp_heights_numbers d;
  asp_error error;
  asp_heights_describe(profile, &d, &error);
  double *slopes = malloc(points * sizeof *slopes);
  double d_p = spacing * (1 + 0.25 * (double)points);
  if (slopes && d_p <= spacing * (double)points &&
      aspi_profile_slopes(profile, d_p, slopes, &count, &error) != ASP_OK)
    fail("a profile that no disc rolls over");
  for (size_t i = 0; slopes && i < count; i++)
    if (!isfinite(slopes[i]))
      fail("a slope that is not a number");
  free(slopes);
}

/* Small ones are described: the autocorrelation of a large one is slow. */
static void check_map(const asp_heights *map) {
  size_t points = map->columns * map->rows;
  if (points < 9 || !(map->step[0] > 0 && map->step[1] > 0))
    fail("a map without points or spacing");
  for (size_t i = 0; i < points; i++)
    if (!isfinite(map->z[i]))
      fail("a height that is not a number");
  asp_heights_numbers numbers;
  asp_error error = {.code = ASP_OK};
  if (points <= 256 && asp_heights_describe(map, &numbers, &error) && !*error.text)
    fail("a map that cannot be described");
}

static asp_heights *read_map(FILE *stream, const aspi_profile_options *read, asp_error *error) {
  aspi_profile_report report = {0};
  aspi_profile_options options = *read;
  options.step[0] = read->column ? 1e-6 : 0;
  options.column = NULL;
  rewind(stream);
  return aspi_read(stream, "fuzz", true, &options, &report, error);
}

static aspi_profile_options options_of(uint8_t bits) {
  aspi_profile_options o = aspi_profile_options_default();
  o.unit_x = o.unit_z = bits & 1 ? 1e-6 : 0;
  o.form = (bits >> 1 & 3) - 1;
  o.fill = bits & 8;
  o.spikes = bits & 32 ? 5 : 0;
  if (bits & 128) {
    o.spikes = 1e-5;
    o.form = ASP_FORM_MAX;
  }
  o.column = bits & 64 ? "3" : NULL;
  return o;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* The first byte chooses the options, the rest is the file. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size < 2)
    return 0;
  FILE *stream = fmemopen((void *)(data + 1), size - 1, "rb");
  if (!stream)
    return 0;
  aspi_profile_options options = options_of(*data);
  aspi_profile_report report;
  asp_error error = {.code = ASP_OK};
  asp_heights *profile = aspi_read(stream, "fuzz", false, &options, &report, &error);
  if (profile)
    check_profile(profile);
  else if (error.code == ASP_OK || !*error.text)
    fail("neither a profile nor an error");
  asp_heights_free(profile);
  error = (asp_error){.code = ASP_OK};
  asp_heights *map = read_map(stream, &options, &error);
  if (map)
    check_map(map);
  else if (error.code == ASP_OK || !*error.text)
    fail("neither a map nor an error");
  asp_heights_free(map);
  fclose(stream);
  return 0;
}

#ifdef FUZZ_MAIN
enum { FILE_MOST = 8000 };

static const char *const files[] = {
    "x_um,z_um\n0,1\n0.5,2\n1,4\n1.5,2\n2,1\n2.5,0\n3,2\n3.5,1\n",
    "Scan Parameters\r\nStylus,Radius: 2.5 \xB5m\r\nLateral um,Raw Micrometer,\r\n0.0,-0.1,,\r\n"
    "0.2,0.3,,\r\n0.3,0.2,,\r\n0.5,nan,,\r\n0.6,-0.1,,\r\n0.8,0.4,,\r\n0.9,0.2,,\r\n",
    "x [mm]; z [nm]\n0,0;1,5\n0,1;2,5\n0,3;4,25\n0,9;BAD\n1,0;4\n1,1;3\n",
    "\xEF\xBB\xBF# unit: um\n0 1\n1 3\n2 nan\n3 4\n4 1e1\n5 7\n",
    "0.000000\t0.003581\n0.000100\t0.003584\n0.000199\t0.003585\n0.000299\t0.003\n",
    "\n aISO-1.0\nNumPoints = 4\nNumProfiles = 3\nXscale = 1.0E-6\nYscale=2E-6\nZscale = 1E-6\n"
    "Compression = 0\n*\n1 2 4 3\n1 BAD 2 3\n5 4 3 2\n*\n<Name> x\n*",
    "# Width: 4 um\n# Height: 3 mm\n# Value units: "
    "m\n1,2,3,5\n2,1,nan,4\n1,,2,0\n3,3,1,2\n4,5,1,7\n",
    "x_um;y_um;z_nm\n0;0;1\n1;0;2\n2;0;3\n3;0;1\n0;1;1\n1;1;5\n2;1;3\n3;1;1\n0;2;1\n1;2;2\n2;2;"
    "0\n3;2;9\n"
    "0;3;4\n1;3;2\n2;3;1\n3;3;-1\n",
    "bISO-2.0ASPERITY  "
    "010120260000010120260000\x04\x01\x01\x01\x05\x01\x01\x01\x01\x01\x01\x01\x01\x01"
    "\x01\x3f\x01\x01\x01\x01\x01\x01\x01\x3f\x01\x01\x01\x01\x01\x01\x01\x3f\x01\x01\x01\x01\x01"
    "\x01"
    "\x01\x3f\x01\x01\x01 some heights or other that are bytes here and there"};

static const char *const tokens[] = {"nan", "inf", "-",   "1e308", "1e-308", "-1e308", ",",  ";",
                                     "\t",  "\n",  "*\n", "=",     "BAD",    "um",     "\r", "0"};

static size_t below(aspi_stream *stream, size_t most) {
  return (size_t)(aspi_stream_uniform(stream) * (double)most);
}

/* Makes room for a piece in the file, and puts it there. */
static size_t insert(uint8_t *file, size_t size, size_t at, const uint8_t *piece, size_t length) {
  if (size + length > FILE_MOST)
    return size;
  memmove(file + at + length, file + at, size - at);
  memcpy(file + at, piece, length);
  return size + length;
}

/* Puts a byte, a token or a piece of the file itself somewhere, once or, rarely, hundreds of times,
 * or takes a piece out. */
static size_t mutate(aspi_stream *stream, uint8_t *file, size_t size) {
  size_t at = below(stream, size), from = below(stream, size), kind = below(stream, 4);
  size_t length = 1 + below(stream, 8), times = below(stream, 50) ? 1 : 1 + below(stream, 1000);
  uint8_t piece[16] = {(uint8_t)below(stream, 256)};
  length = kind == 0 ? 1 : length < size - from ? length : size - from;
  if (kind == 3 && size > at + length) {
    memmove(file + at, file + at + length, size - at - length);
    return size - length;
  }
  if (kind == 1) {
    const char *token = tokens[below(stream, sizeof tokens / sizeof *tokens)];
    length = strlen(token);
    memcpy(piece, token, length);
  } else if (kind >= 2) {
    memcpy(piece, file + from, length);
  }
  for (size_t i = 0; i < times; i++)
    size = insert(file, size, at, piece, length);
  return size;
}

int main(int argc, char **argv) {
  size_t rounds = argc > 1 ? strtoul(argv[1], NULL, 10) : 20000;
  for (size_t round = 0; round < rounds; round++) {
    aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = 1, .tag = round});
    const char *from = files[round % (sizeof files / sizeof *files)];
    uint8_t file[FILE_MOST + 1] = {(uint8_t)below(&stream, 256)};
    size_t size = strlen(from), changes = round < 600 ? 0 : 1 + below(&stream, 12);
    memcpy(file + 1, from, size);
    for (size_t i = 1; from[0] == 'b' && i <= size; i++) /* strings hold no NUL */
      file[i] = file[i] == 1 ? 0 : file[i];
    for (size_t i = 0; i < changes; i++)
      size = mutate(&stream, file + 1, size);
    LLVMFuzzerTestOneInput(file, size + 1);
  }
  printf("%zu files\n", rounds);
  return 0;
}
#endif
