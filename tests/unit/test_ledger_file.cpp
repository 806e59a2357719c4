/* The file of a ledger: whole windows or nothing of them, whatever the disk does.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/books/ledger_file.h"

#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>

#include "dem/error.h"

#include "check.h"

using namespace asperity;

static std::string folder;

static std::string contents(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

static void set_contents(const std::string &path, const std::string &text) {
  std::ofstream(path, std::ios::binary) << text;
}

/* A window of rows, all of the same step. */
static std::string add_rows(LedgerFile &file, int step, int count) {
  std::vector<char> bytes;
  for (int i = 0; i < count; i++) {
    LedgerRow row;
    row.fill(0.5);
    row[LedgerColumn::TAG] = i;
    row[LedgerColumn::TIME] = step;
    append_line(row.data(), LedgerColumn::N_COLUMNS, bytes);
  }
  return file.commit(bytes, count);
}

static void assert_written(const std::string &why) {
  assert_string_equal(why.c_str(), "");
}

/* A grain that slides has no CoR_N: nan in the array, nothing in the file. */
TEST(slides) {
  const double v1[3] = {2, 0, 0}, n[3] = {0, 0, 1};
  asp_impact impact = asp_impact();
  impact.v2[0] = 1;
  impact.v2[2] = 0.1;
  const LedgerRow row = impact_row(v1, n, impact);
  assert_true(std::isnan(row[LedgerColumn::COR_N]) && row[LedgerColumn::COR_T] == 0.5);
  std::vector<char> bytes;
  append_line(row.data(), LedgerColumn::N_COLUMNS, bytes);
  assert_says(std::string(bytes.begin(), bytes.end()), ",,0.5,0\n");
}

static void limit(rlim_t bytes) {
  struct rlimit most;
  assert_int_equal(getrlimit(RLIMIT_FSIZE, &most), 0);
  most.rlim_cur = bytes;
  assert_int_equal(setrlimit(RLIMIT_FSIZE, &most), 0);
}

/* A disk that is full takes a part of a window; when it has room again, the next one follows the
 * last whole one. Larger than what is written at once. */
TEST(full_disk) {
  const std::string path = folder + "/full.csv";
  LedgerFile file(path, LedgerColumn::N_COLUMNS);
  file.open(LedgerState(), "heading");
  assert_written(add_rows(file, 1, 300));
  const std::string good = contents(path);
  for (int rows : {300, 30000}) {
    limit(good.size() + 5000);
    assert_says(add_rows(file, 2, rows), "File too large");
    limit(RLIM_INFINITY);
    assert_true(contents(path) == good);
  }
  assert_int_equal(file.state().rows, 300);
  assert_written(add_rows(file, 3, 10));
  assert_int_equal(file.state().rows, 310);
  const std::string after = contents(path);
  assert_int_equal(file.state().bytes, after.size());
  const std::string other = folder + "/twin-of-full.csv";
  LedgerFile twin(other, LedgerColumn::N_COLUMNS);
  twin.open(LedgerState(), "heading");
  add_rows(twin, 1, 300);
  add_rows(twin, 3, 10);
  assert_true(contents(other) == after);
}

TEST(deleted) {
  const std::string path = folder + "/deleted.csv";
  LedgerFile file(path, LedgerColumn::N_COLUMNS);
  file.open(LedgerState(), "heading");
  assert_written(add_rows(file, 1, 3));
  unlink(path.c_str());
  assert_says(add_rows(file, 2, 3), "deleted");
}

/* Rows behind a part that another program has cut off would follow NUL bytes. */
TEST(cut_short) {
  const std::string path = folder + "/cut_short.csv";
  LedgerFile file(path, LedgerColumn::N_COLUMNS);
  file.open(LedgerState(), "heading");
  assert_written(add_rows(file, 1, 3));
  const std::string whole = contents(path), part = whole.substr(0, whole.size() - 5);
  assert_int_equal(truncate(path.c_str(), static_cast<off_t>(part.size())), 0);
  assert_says(add_rows(file, 2, 3), "another program has cut it from");
  assert_true(contents(path) == part);
}

static std::string wrong_of_open(LedgerFile &file, const LedgerState &saved) {
  try {
    file.open(saved, "heading");
  } catch (const Error &wrong) {
    return wrong.what();
  }
  return "";
}

/* Cut back from any later length. */
TEST(every_length) {
  const std::string path = folder + "/cut.csv";
  LedgerState state;
  {
    LedgerFile file(path, LedgerColumn::N_COLUMNS);
    file.open(LedgerState(), "heading");
    assert_written(add_rows(file, 1, 3));
    state = file.state();
  }
  const std::string good = contents(path);
  {
    LedgerFile file(path, LedgerColumn::N_COLUMNS);
    file.open(state, "heading");
    assert_written(add_rows(file, 2, 2));
  }
  const std::string longer = contents(path);
  for (size_t length = good.size(); length <= longer.size(); length++) {
    set_contents(path, longer.substr(0, length));
    LedgerFile file(path, LedgerColumn::N_COLUMNS);
    const std::string report = file.open(state, "heading");
    assert_true(contents(path) == good);
    assert_true((report.find("cut off") != std::string::npos) == (length > good.size()));
    if (length == longer.size())
      assert_says(report, "after the 3 rows that the restart file counts; 2 rows after");
  }
  for (size_t length = 0; length < good.size(); length++) {
    set_contents(path, longer.substr(0, length));
    LedgerFile file(path, LedgerColumn::N_COLUMNS);
    assert_says(wrong_of_open(file, state), "are missing");
    assert_int_equal(contents(path).size(), length);
  }
}

TEST(two_walls) {
  const std::string path = folder + "/two.csv", link_path = folder + "/link.csv";
  std::unique_ptr<LedgerFile> first(new LedgerFile(path, LedgerColumn::N_COLUMNS));
  first->open(LedgerState(), "heading");
  assert_written(add_rows(*first, 5, 3));
  const std::string rows = contents(path);
  assert_int_equal(symlink(path.c_str(), link_path.c_str()), 0);
  for (const std::string &name : {path, link_path}) {
    LedgerFile second(name, LedgerColumn::N_COLUMNS);
    assert_says(wrong_of_open(second, LedgerState()), "is being written by another wall");
  }
  assert_true(contents(path) == rows);
  first.reset();
  LedgerFile later(path, LedgerColumn::N_COLUMNS);
  assert_string_equal(later.open(LedgerState(), "heading").c_str(), "");
  assert_int_equal(later.state().rows, 0);
}

TEST(no_file) {
  const std::string path = folder + "/nowhere/rows.csv";
  LedgerFile file(path, LedgerColumn::N_COLUMNS);
  assert_says(wrong_of_open(file, LedgerState()), "No such file");
  const std::string fifo = folder + "/fifo.csv";
  assert_int_equal(mkfifo(fifo.c_str(), 0600), 0);
  for (const std::string &other : {fifo, folder, std::string("/dev/null")}) {
    LedgerFile irregular(other, LedgerColumn::N_COLUMNS);
    assert_says(wrong_of_open(irregular, LedgerState()), other + "': it is not a regular file");
  }
}

/* A file that is gone is an error only where the restart file counts rows in it. */
TEST(gone) {
  const std::string path = folder + "/gone.csv";
  for (double rows : {0.0, 2.0}) {
    LedgerFile file(path, LedgerColumn::N_COLUMNS);
    LedgerState saved;
    saved.path = path;
    saved.rows = rows;
    const std::string wrong = wrong_of_open(file, saved);
    assert_true(rows > 0 ? wrong.find("is gone") != std::string::npos : wrong.empty());
    unlink(path.c_str());
  }
}

/* A link names its file before that is there. */
TEST(links) {
  const std::string link = folder + "/symbolic.csv", path = folder + "/behind.csv";
  assert_int_equal(symlink(path.c_str(), link.c_str()), 0);
  LedgerFile file(link, LedgerColumn::N_COLUMNS);
  file.open(LedgerState(), "heading");
  assert_written(add_rows(file, 1, 3));
  assert_says(contents(path), "# heading");
}

/* LAMMPS has tags of 64 bits where it is built for them. */
TEST(long_tags) {
  const int64_t tag = 3000000000;
  std::vector<char> bytes;
  LedgerRow row;
  row.fill(0);
  row[LedgerColumn::TAG] = static_cast<double>(tag);
  append_line(row.data(), LedgerColumn::N_COLUMNS, bytes);
  assert_memory_equal(bytes.data(), "3000000000,", 11);
}

int main() {
  char name[] = "/tmp/asperity-XXXXXX";
  signal(SIGXFSZ, SIG_IGN);
  folder = mkdtemp(name);
  const int failed = run_listed_tests(NULL, NULL);
  if (system(("rm -r " + folder).c_str()) != 0)
    return 1;
  return failed;
}
