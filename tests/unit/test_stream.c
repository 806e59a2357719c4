/* The random numbers of a contact: known answers, and independence of everything but the key.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "base/stream.h"

#include <stdlib.h>

/* Random123's own known-answer vectors for philox4x32 with 10 rounds. */
TEST(philox_known_answers) {
  static const struct {
    uint32_t key[2], counter[4], word[4];
  } known[] = {
      {{0, 0}, {0, 0, 0, 0}, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
      {{0xffffffff, 0xffffffff},
       {0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff},
       {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
      {{0xa4093822, 0x299f31d0},
       {0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
       {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}},
  };
  for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
    aspi_stream s = {.left = 0};
    memcpy(s.key, known[i].key, sizeof s.key);
    memcpy(s.counter, known[i].counter, sizeof s.counter);
    for (int j = 0; j < 4; j += 2) {
      uint64_t bits = (uint64_t)known[i].word[j] << 32 | known[i].word[j + 1];
      assert_near(aspi_stream_uniform(&s), ((double)(bits >> 11) + 0.5) * 0x1p-53, 0);
    }
  }
}

TEST(known_draws) {
  char path[1000], line[400], fix[40];
  snprintf(path, sizeof path, "%s/known_draws.txt", getenv("ASPERITY_TEST_DATA"));
  FILE *file = fopen(path, "r");
  assert_non_null(file);
  int rows = 0;
  while (fgets(line, sizeof line, file)) {
    unsigned seed, impact;
    unsigned long long tag;
    double u[4];
    if (*line == '#')
      continue;
    assert_int_equal(sscanf(line, "%u %39s %llu %u %lf %lf %lf %lf", &seed, fix, &tag, &impact,
                            &u[0], &u[1], &u[2], &u[3]),
                     8);
    aspi_stream s = aspi_stream_begin(&(asp_key){seed, asp_key_wall(fix), tag, impact, 0});
    for (int i = 0; i < 4; i++)
      assert_near(aspi_stream_uniform(&s), u[i], 0);
    rows++;
  }
  fclose(file);
  assert_int_equal(rows, 6);
}

TEST(name_of_a_wall_is_fnv1a) {
  assert_int_equal(asp_key_wall(""), 2166136261u);
  assert_int_equal(asp_key_wall("a"), 0xe40c292cu);
  assert_int_equal(asp_key_wall("foobar"), 0xbf9cf968u);
}

/* 1e6 draws: inside (0, 1), mean 1/2, variance 1/12, within five standard errors. */
TEST(uniform_is_uniform) {
  enum { TAGS = 100000, DRAWS = 10 };
  double sum = 0, square = 0, n = (double)TAGS * DRAWS;
  for (uint64_t tag = 0; tag < TAGS; tag++) {
    aspi_stream s = aspi_stream_begin(&(asp_key){7, 7, tag, 1, 0});
    for (int i = 0; i < DRAWS; i++) {
      double u = aspi_stream_uniform(&s);
      assert_true(u > 0 && u < 1);
      double steps = u < 0.5 ? u * 0x1p53 - 0.5 : u * 0x1p52; /* as the header tells */
      assert_near(steps, floor(steps), 0);
      sum += u - 0.5;
      square += (u - 0.5) * (u - 0.5);
    }
  }
  assert_near(sum / n, 0, 5 * sqrt(1 / 12. / n));
  assert_near(square / n, 1 / 12., 5 * sqrt(1 / 180. / n));
}
