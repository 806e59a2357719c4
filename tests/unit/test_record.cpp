/* The restart record: what comes back, and what does not, with every byte flipped and cut at every
 * length; each record lies in memory of just its length, for the sanitizers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/books/record.h"

#include <memory>

#include "dem/error.h"
#include "dem/text.h"

#include "check.h"

using namespace asperity;

/* Where the head has them. */
enum { VERSION = 8, LENGTH = 12, SUM = 16, SUM_OF_HEAD = 20, HEAD = 24 };

static WallState example() {
  WallState state = WallState();
  state.settings = {{"geometry", "mesh low high"}, {"seed", "4"}, {"materials", ""}};
  state.counters = {168, 3, 1e-12, 4, 5, 6};
  state.meshes = {
      MeshState{"low", 2, {160, 3, 1e-12, 0.5}, {100, 1e-12, 0.25, 60, 0, 0.25}, {1, 2, 3}},
      MeshState{"high", 1, {8, 0, 0, 0.125}, {8, 0, 0.125}, {}}};
  state.bodies = {7, 8};
  state.d_range[0] = 1e-6;
  state.d_range[1] = 1e-4;
  state.clock[1] = 100;
  state.clock[2] = 1e-8;
  state.ledger = LedgerState{"rows.csv", 168, 20000, 0xDEADBEEF};
  return state;
}

static std::vector<char> example_record() {
  WallState state = example();
  return pack(state);
}

/* In memory that ends where they do. */
static std::unique_ptr<char[]> exact(const std::vector<char> &bytes, size_t length) {
  std::unique_ptr<char[]> copy(new char[length]);
  memcpy(copy.get(), bytes.data(), length);
  return copy;
}

TEST(comes_back) {
  const std::vector<char> record = example_record();
  const WallState was = example(), is = unpack(exact(record, record.size()).get());
  assert_true(is.settings == was.settings);
  assert_true(is.counters == was.counters);
  assert_int_equal(is.totals.size(), 0);
  assert_int_equal(is.meshes.size(), 2);
  for (size_t m = 0; m < 2; m++) {
    assert_string_equal(is.meshes[m].id.c_str(), was.meshes[m].id.c_str());
    assert_int_equal(is.meshes[m].triangles, was.meshes[m].triangles);
    assert_true(is.meshes[m].totals == was.meshes[m].totals);
    assert_true(is.meshes[m].map == was.meshes[m].map);
    assert_true(is.meshes[m].motion == was.meshes[m].motion);
  }
  assert_true(is.bodies == was.bodies);
  assert_memory_equal(is.d_range, was.d_range, sizeof is.d_range);
  assert_memory_equal(is.clock, was.clock, sizeof is.clock);
  assert_string_equal(is.ledger.path.c_str(), was.ledger.path.c_str());
  assert_int_equal(is.ledger.rows, was.ledger.rows);
  assert_int_equal(is.ledger.bytes, was.ledger.bytes);
  assert_int_equal(is.ledger.tail, was.ledger.tail);
}

/* The message of the error that it ends with. */
static std::string wrong_of(const std::vector<char> &record, size_t length, size_t available) {
  try {
    unpack(exact(record, length).get(), available);
  } catch (const Error &wrong) {
    return wrong.what();
  }
  return "";
}

/* The engine does not tell how long the record is. */
TEST(flipped) {
  const std::vector<char> good = example_record();
  for (size_t i = 0; i < good.size(); i++)
    for (int bit = 0; bit < 8; bit++) {
      std::vector<char> record = good;
      record[i] = static_cast<char>(record[i] ^ 1 << bit);
      assert_says(wrong_of(record, record.size(), SIZE_MAX), "damaged");
    }
}

TEST(cut) {
  const std::vector<char> good = example_record();
  for (size_t length = 0; length < good.size(); length++)
    assert_says(wrong_of(good, length, length), "cut short");
}

static void put(std::vector<char> &record, size_t at, uint32_t value) {
  memcpy(&record[at], &value, sizeof value);
}

static void sum_up(std::vector<char> &record) {
  put(record, SUM, checksum(record.data() + HEAD, record.size() - HEAD));
  put(record, SUM_OF_HEAD, checksum(record.data(), SUM_OF_HEAD));
}

/* Wrong lengths and counts behind right checksums, as a faulty writer would leave them. */
TEST(wrong_inside) {
  const std::vector<char> good = example_record();
  int refused = 0;
  for (size_t i = VERSION; i < good.size(); i++)
    for (int value : {0, 1, 127, 128, 255}) {
      std::vector<char> record = good;
      record[i] = static_cast<char>(value);
      sum_up(record);
      const bool head_is_longer = i >= LENGTH && i < SUM;
      refused +=
          !wrong_of(record, record.size(), head_is_longer ? record.size() : SIZE_MAX).empty();
    }
  assert_true(refused > 500);
}

TEST(other_version) {
  std::vector<char> record = example_record();
  put(record, VERSION, 7);
  sum_up(record);
  assert_says(wrong_of(record, record.size(), SIZE_MAX),
              "is of version 7; it must be of version 6");
}

/* What was written before records had a name began with counters. */
TEST(no_name) {
  const std::vector<double> counters(100, 168);
  std::vector<char> record(sizeof(double) * counters.size());
  memcpy(record.data(), counters.data(), record.size());
  assert_says(wrong_of(record, record.size(), SIZE_MAX), "does not begin as one");
}

TEST(changes) {
  const Settings now = {{"geometry", "mesh low"}, {"seed", "4"}, {"materials", ""}};
  assert_string_equal(describe_changes(now, now).c_str(), "");
  const Settings other = {{"geometry", "mesh low"}, {"seed", "5"}, {"materials", "quartz"}};
  assert_string_equal(describe_changes(now, other).c_str(),
                      "seed 4, was 5; materials none, was quartz");
  const Settings one = {{"geometry", "mesh low"},
                        {"description", "surface profile \"a seed 3.csv\" dp_bins 4 seed 4"}},
                 two = {{"geometry", "mesh low"},
                        {"description", "surface smooth friction 1 seed 4"}};
  assert_string_equal(
      describe_changes(clauses(one), clauses(two)).c_str(),
      "surface profile \"a seed 3.csv\" dp_bins 4, was smooth; friction none, was 1");
  assert_string_equal(setting(1e-5).c_str(), "1e-05");
  assert_string_not_equal(setting(0.9).c_str(), setting(0.9000000001).c_str());
}

/* Engines state the length as an int. */
TEST(records_too_long_are_refused) {
  check_record_size(2147483647);
  std::string said;
  try {
    check_record_size(2147483648);
  } catch (const Error &wrong) {
    said = wrong.what();
  }
  assert_true(said.find("has 2147483648 bytes") != std::string::npos);
  assert_true(said.find("2147483647 at most") != std::string::npos);
}
