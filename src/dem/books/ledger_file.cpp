/* The file of a ledger; see ledger_file.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/books/ledger_file.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cmath>

#include "base/number.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

/* Bytes at the end of a file that identify it; bytes per read or write; largest length of a
 * heading. */
static const int64_t TAIL = 4096;
static const size_t BUFFER = 1 << 18, HEADING_MOST = 1 << 14;

static std::string cannot_write(const std::string &path, const std::string &why) {
  return "cannot write the ledger file '" + path + "': " + why;
}

static std::string rows_of(int64_t count) {
  return std::to_string(count) + (count == 1 ? " row" : " rows");
}

uint32_t asperity::checksum(const void *bytes, size_t length) {
  const unsigned char *at = static_cast<const unsigned char *>(bytes);
  uint32_t sum = 2166136261u; /* FNV-1a's offset basis and prime */
  for (size_t i = 0; i < length; i++)
    sum = (sum ^ at[i]) * 16777619u;
  return sum;
}

LedgerFile::LedgerFile(const std::string &path, int columns)
    : path_(path), columns_(columns), fd_(-1), rows_(0), bytes_(0), torn_(false) {}

LedgerFile::~LedgerFile() {
  if (fd_ >= 0)
    close(fd_);
}

/* ---- beginning and continuing ---------------------------------------------------------------- */

std::string LedgerFile::open(const LedgerState &saved, const std::string &heading) {
  try {
    const bool is_new = open_or_create(saved);
    lock();
    return begin_or_continue(is_new, saved, heading);
  } catch (const Error &) {
    if (fd_ >= 0)
      close(fd_);
    fd_ = -1;
    throw;
  }
}

/* Returns true for a new file. A pipe or a device could not be cut back to whole rows. */
bool LedgerFile::open_or_create(const LedgerState &saved) {
  const int flags = O_RDWR | O_CLOEXEC;
  struct stat is;
  if (stat(path_.c_str(), &is) == 0 && !S_ISREG(is.st_mode))
    throw Error(cannot_write(path_, "it is not a regular file"));
  fd_ = ::open(path_.c_str(), flags);
  const bool is_new = fd_ < 0 && errno == ENOENT;
  if (is_new && saved.path == path_ && saved.rows > 0)
    throw Error("the ledger file '" + path_ + "' is gone, and the restart file counts " +
                rows_of(saved.rows) +
                " in it; it must be there, or 'ledger' name another file, which begins anew");
  if (is_new)
    fd_ = ::open(path_.c_str(), flags | O_CREAT, 0666);
  if (fd_ < 0)
    throw Error(cannot_write(path_, strerror(errno)));
  return is_new;
}

/* Another wall of this process has a lock of its own, too. Some file systems have no locks. */
void LedgerFile::lock() {
  if (flock(fd_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw Error("the ledger file '" + path_ +
                "' is being written by another wall or run; each must have a file of its own");
}

std::string LedgerFile::begin_or_continue(bool is_new, const LedgerState &saved,
                                          const std::string &heading) {
  const bool same_name = saved.path == path_;
  if (!is_new && !saved.path.empty() && (same_name || holds(saved)))
    return continue_at(saved);
  begin(heading);
  if (saved.rows == 0 || same_name)
    return "";
  return "ledger file '" + path_ + "' begins here; the " + rows_of(saved.rows) + " of '" +
         saved.path + "' that the restart file counts are not in it";
}

void LedgerFile::begin(const std::string &heading) {
  const std::string first = "# " + heading + "\n" + ledger_names(columns_) + "\n";
  rows_ = bytes_ = 0;
  std::string why = take_back();
  if (why.empty())
    why = write(first.data(), first.size());
  if (!why.empty())
    throw Error(cannot_write(path_, why));
  bytes_ = static_cast<int64_t>(first.size());
}

std::string LedgerFile::continue_at(const LedgerState &state) {
  const std::string advice = "; it must be the file itself, or 'ledger' name another file, which "
                             "begins anew";
  bool torn;
  if (size() < state.bytes) {
    const int64_t found = count_rows(0, torn);
    throw Error("the ledger file '" + path_ + "' has " + rows_of(found) +
                ", and the restart file counts " + std::to_string(state.rows) + ": " +
                std::to_string(state.rows - found) + " are missing" + advice);
  }
  check_columns();
  if (!holds(state))
    throw Error("the ledger file '" + path_ +
                "' is not that of the restart file: its rows before number " +
                std::to_string(state.rows) + " differ" + advice);
  const int64_t after = count_rows(state.bytes, torn);
  rows_ = state.rows;
  bytes_ = state.bytes;
  const std::string why = take_back();
  if (!why.empty())
    throw Error(cannot_write(path_, why));
  std::string report = "ledger file '" + path_ + "' continues after the " + rows_of(rows_) +
                       " that the restart file counts";
  if (after > 0 || torn)
    report += "; " + (after > 0 ? rows_of(after) : std::string()) +
              (after > 0 && torn ? " and " : "") + (torn ? "a part of a row" : "") +
              " after them cut off";
  return report;
}

void LedgerFile::check_columns() {
  std::string first(HEADING_MOST, '\0');
  first.resize(std::max<ssize_t>(0, pread(fd_, &first[0], first.size(), 0)));
  const std::string names = "\n" + ledger_names(columns_) + "\n";
  if (first.compare(0, 1, "#") != 0 ||
      first.compare(std::min(first.find('\n'), first.size()), names.size(), names) != 0)
    throw Error(
        "the ledger file '" + path_ +
        "' is not one to append to: its columns must be those of this version and of this ledger");
}

bool LedgerFile::holds(const LedgerState &state) const {
  return size() >= state.bytes && tail_at(state.bytes) == state.tail;
}

/* Checksum of the last bytes. */
uint32_t LedgerFile::tail_at(int64_t bytes) const {
  const int64_t from = std::max<int64_t>(bytes - TAIL, 0);
  std::vector<char> tail(static_cast<size_t>(std::max<int64_t>(0, bytes - from)));
  const ssize_t length = pread(fd_, tail.data(), tail.size(), from);
  return checksum(tail.data(), static_cast<size_t>(std::max<ssize_t>(0, length)));
}

int64_t LedgerFile::size() const {
  struct stat is;
  return fstat(fd_, &is) == 0 ? static_cast<int64_t>(is.st_size) : 0;
}

/* From a place between two rows, or from the beginning of the file. */
int64_t LedgerFile::count_rows(int64_t from, bool &torn) const {
  const int64_t above = from > 0 ? 0 : 2;
  std::vector<char> part(BUFFER);
  int64_t lines = 0;
  torn = false;
  for (ssize_t length; (length = pread(fd_, part.data(), part.size(), from)) > 0; from += length) {
    lines += std::count(part.begin(), part.begin() + length, '\n');
    torn = part[length - 1] != '\n';
  }
  return std::max<int64_t>(0, lines - above);
}

LedgerState LedgerFile::state() const {
  if (fd_ < 0)
    return LedgerState();
  return LedgerState{path_, rows_, bytes_, tail_at(bytes_)};
}

/* ---- writing --------------------------------------------------------------------------------- */

std::string LedgerFile::write(const char *bytes, size_t length) {
  for (int64_t at = bytes_; length > 0;) {
    const ssize_t done = pwrite(fd_, bytes, length, at);
    if (done < 0 && errno == EINTR)
      continue;
    if (done <= 0)
      return done < 0 ? strerror(errno) : "nothing more is taken";
    bytes += done;
    at += done;
    length -= static_cast<size_t>(done);
  }
  return "";
}

/* Back to the rows that were added. */
std::string LedgerFile::take_back() {
  torn_ = size() > bytes_ && ftruncate(fd_, bytes_) != 0;
  return torn_ ? strerror(errno) : "";
}

/* What another program has done to the file: rows that go to a file without a name are gone with
 * it, and rows behind a missing part would follow NUL bytes. */
std::string LedgerFile::damage() const {
  struct stat is;
  if (fstat(fd_, &is) != 0)
    return "";
  if (is.st_nlink == 0)
    return "it has been deleted";
  if (is.st_size < bytes_)
    return text("another program has cut it from %lld to %lld bytes",
                static_cast<long long>(bytes_), static_cast<long long>(is.st_size));
  return "";
}

std::string LedgerFile::commit(const std::vector<char> &bytes, int64_t rows) {
  std::string why = torn_ ? take_back() : "";
  if (why.empty())
    why = damage();
  if (why.empty())
    why = write(bytes.data(), bytes.size());
  if (!why.empty()) {
    take_back();
    return why;
  }
  rows_ += rows;
  bytes_ += static_cast<int64_t>(bytes.size());
  return "";
}

/* File systems that cannot sync say EINVAL or ENOTSUP. */
std::string LedgerFile::sync() {
  if (fsync(fd_) == 0 || errno == EINVAL || errno == ENOTSUP)
    return "";
  return strerror(errno);
}

/* ---- rows ------------------------------------------------------------------------------------ */

/* Whole numbers (i) are printed as such in CSV. */
#define LEDGER_NAMED(ID, name, type, text) {name, type},
static const struct {
  const char *name, *type;
} COLUMNS[] = {LEDGER_COLUMNS(LEDGER_NAMED) LEDGER_MORE_COLUMNS(LEDGER_NAMED)};
#undef LEDGER_NAMED

std::string asperity::ledger_names(int columns) {
  std::string names;
  for (int i = 0; i < columns; i++)
    names += (i > 0 ? "," : "") + std::string(COLUMNS[i].name);
  return names;
}

void asperity::append_line(const double *row, int columns, std::vector<char> &bytes) {
  char line[(ASPI_NUMBER_MOST + 1) * LedgerColumn::N_FULL], *end = line;
  for (int i = 0; i < columns; i++) {
    if (i > 0)
      *end++ = ',';
    if (std::isnan(row[i])) /* a coefficient that there is not */
      continue;
    end = COLUMNS[i].type[0] == 'i' ? aspi_count_format(row[i], end)
                                    : aspi_number_format(row[i], 10, end);
  }
  *end++ = '\n';
  bytes.insert(bytes.end(), line, end);
}

LedgerRow asperity::impact_row(const double v1[3], const double n[3], const asp_impact &impact) {
  typedef LedgerColumn L;
  const double degrees = 180 / ASP_PI;
  const asp_coefficients c = asp_impact_coefficients(v1, n, &impact);
  LedgerRow row = {};
  row[L::V1] = c.v1;
  row[L::ALPHA1] = c.alpha1 * degrees;
  row[L::DELTA_ALPHA] = impact.delta_alpha * degrees;
  row[L::TILT_OUT] = impact.tilt_out * degrees;
  row[L::HITS] = impact.hits;
  row[L::V2] = c.v2;
  row[L::ALPHA2] = c.alpha2 * degrees;
  row[L::COR_N] = c.cor_n;
  row[L::COR_T] = c.cor_t;
  for (int k = 0; k < 3; k++) {
    row[L::NX + k] = n[k];
    row[L::V1X + k] = v1[k];
    row[L::V2X + k] = impact.v2[k];
    row[L::OMEGA2X + k] = impact.omega[k];
  }
  return row;
}

void PrintedRows::add(const double *row, int columns, double step) {
  typedef LedgerColumn L;
  const size_t before = bytes.size();
  append_line(row, columns, bytes);
  const double length = static_cast<double>(bytes.size() - before);
  keys.insert(keys.end(), {step, row[L::TIME], row[L::TAG], row[L::IMPACT], length});
}

std::string PrintedRows::commit(LedgerFile &file) const {
  struct Place {
    const double *key;
    const char *row;
    bool operator<(const Place &other) const {
      return std::lexicographical_compare(key, key + KEY - 1, other.key, other.key + KEY - 1);
    }
  };
  std::vector<Place> order;
  order.reserve(size());
  const char *row = bytes.data();
  for (const double *key = keys.data(); order.size() < size(); key += KEY) {
    order.push_back(Place{key, row});
    row += static_cast<size_t>(key[KEY - 1]);
  }
  std::sort(order.begin(), order.end());
  std::vector<char> sorted;
  sorted.reserve(bytes.size());
  for (const Place &place : order)
    sorted.insert(sorted.end(), place.row, place.row + static_cast<size_t>(place.key[KEY - 1]));
  return file.commit(sorted, static_cast<int64_t>(order.size()));
}
