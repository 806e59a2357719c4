/* The ledger of a rough wall; see ledger.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/ledger.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <algorithm>
#include <numeric>
#include <tuple>

#include "wall/number.h"

using namespace asperity;

/* Names as the file has them, and types in an array: i or f and bytes. Counts (i) are printed as
 * whole numbers in CSV. */
static const struct {
  const char *name, *type;
} COLUMNS[Ledger::N_COLUMNS] = {
    {"tag", "i4"},          {"impact", "i4"}, {"time", "f8"},       {"mesh", "i2"},
    {"triangle", "i4"},     {"x", "f8"},      {"y", "f8"},          {"z", "f8"},
    {"d_p", "f4"},          {"v1", "f4"},     {"alpha1_deg", "f4"}, {"delta_alpha_deg", "f4"},
    {"tilt_out_deg", "f4"}, {"hits", "i1"},   {"v2", "f4"},         {"alpha2_deg", "f4"},
    {"cor_n", "f4"},        {"cor_t", "f4"},  {"outcome", "i1"}};

/* An array's header: magic, version, length, a Python dictionary. */
static const size_t HEADER = 2048, PREAMBLE = 10, TITLE_MOST = 1000;
static const char SHAPE[] = "'shape': (";

#if __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "arrays are written little-endian"
#endif

/* How many rows a rank sends at once: the first rank holds as many of each. */
static const size_t PIECE = 256;
static const int TAG_OF_MESSAGES = 7301;

bool Ledger::Key::operator<(const Key &other) const {
  return std::tie(step, time, tag, impact) <
         std::tie(other.step, other.time, other.tag, other.impact);
}

static bool ends_with(const std::string &text, const std::string &end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

Ledger::Ledger(MPI_Comm world, int64_t every, const std::string &path)
    : world_(world), every_(every), path_(path), is_array_(ends_with(path, ".npy")), in_file_(0),
      file_(NULL), size_(0), written_(0) {
  MPI_Comm_rank(world_, &rank_);
  MPI_Comm_size(world_, &ranks_);
}

Ledger::~Ledger() {
  if (file_)
    fclose(file_);
}

static int bytes_of(int column) {
  return COLUMNS[column].type[1] - '0';
}

static long long bytes_of_row() {
  long long bytes = 0;
  for (int i = 0; i < Ledger::N_COLUMNS; i++)
    bytes += bytes_of(i);
  return bytes;
}

/* The dictionary up to the number of rows. The heading is the title of the first column, the one
 * place that the format has for a text. */
static std::string begin_header(const std::string &heading) {
  std::string title;
  for (char c : heading.substr(0, TITLE_MOST))
    title += c == '\'' || c == '\\' ? ' ' : c;
  std::string text = "{'descr': [(('" + title + "', '" + COLUMNS[0].name + "'), '<i4')";
  for (int i = 1; i < Ledger::N_COLUMNS; i++)
    text += std::string(", ('") + COLUMNS[i].name + "', '" + (bytes_of(i) > 1 ? "<" : "|") +
            COLUMNS[i].type + "')";
  return text + "], 'fortran_order': False, " + SHAPE;
}

std::string Ledger::open(bool append, const std::string &heading) {
  std::string why;
  if (rank_ == 0 && !path_.empty() && !file_)
    why = is_array_ ? open_array(append, heading) : open_csv(append, heading);
  int length = static_cast<int>(why.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, world_);
  why.resize(length);
  MPI_Bcast(&why[0], length, MPI_CHAR, 0, world_);
  return why;
}

static std::string cannot_write(const std::string &path) {
  return "cannot write the ledger file '" + path + "': " + strerror(errno);
}

std::string Ledger::open_csv(bool append, const std::string &heading) {
  file_ = fopen(path_.c_str(), append ? "a" : "w");
  if (!file_)
    return cannot_write(path_);
  if (ftell(file_) <= 0) {
    fprintf(file_, "# %s\n", heading.c_str());
    for (int i = 0; i < N_COLUMNS; i++)
      fprintf(file_, "%s%s", i ? "," : "", COLUMNS[i].name);
    fputc('\n', file_);
  }
  fflush(file_);
  return "";
}

std::string Ledger::open_array(bool append, const std::string &heading) {
  header_ = begin_header(heading);
  if (append)
    file_ = fopen(path_.c_str(), "r+b");
  if (file_)
    return continue_array();
  file_ = fopen(path_.c_str(), "wb");
  if (!file_)
    return cannot_write(path_);
  write_header();
  return "";
}

/* Keeps the heading that the file has, and cuts off rows that its header does not count. */
std::string Ledger::continue_array() {
  std::string text(HEADER, '\0');
  text.resize(fread(&text[0], 1, HEADER, file_));
  const size_t shape = text.find(SHAPE), columns = header_.find(COLUMNS[0].name);
  const size_t length = header_.size() - header_.find("'), ", columns);
  if (text.size() < HEADER || shape == std::string::npos || shape < PREAMBLE + length ||
      header_.compare(header_.size() - length, length, text, shape + sizeof SHAPE - 1 - length,
                      length) != 0)
    return "the ledger file '" + path_ + "' is there, but is not one to append to";
  in_file_ = atoll(text.c_str() + shape + sizeof SHAPE - 1);
  header_ = text.substr(PREAMBLE, shape + sizeof SHAPE - 1 - PREAMBLE);
  const off_t end = static_cast<off_t>(HEADER) + in_file_ * bytes_of_row();
  if (fseeko(file_, 0, SEEK_END) != 0 || ftello(file_) < end)
    return "the ledger file '" + path_ + "' has fewer rows than its header says";
  if (ftruncate(fileno(file_), end) != 0 || fseeko(file_, end, SEEK_SET) != 0)
    return cannot_write(path_);
  return "";
}

void Ledger::write_header() {
  std::string text = header_ + std::to_string(in_file_) + ",), }";
  text.resize(HEADER - PREAMBLE - 1, ' ');
  const unsigned length = HEADER - PREAMBLE;
  const unsigned char preamble[PREAMBLE] = {0x93, 'N', 'U', 'M',           'P',
                                            'Y',  1,   0,   length & 0xff, length >> 8};
  rewind(file_);
  fwrite(preamble, 1, PREAMBLE, file_);
  fwrite(text.data(), 1, text.size(), file_);
  fputc('\n', file_);
  fflush(file_);
  fseeko(file_, 0, SEEK_END);
}

void Ledger::add(const Row &added) {
  if (size_ == blocks_.size() * BLOCK)
    blocks_.push_back(std::unique_ptr<Row[]>(new Row[BLOCK]));
  row(size_++) = added;
}

void Ledger::begin_step(int64_t step) {
  if ((step - 1) % every_ != 0)
    return;
  size_ = written_ = 0;
}

void Ledger::end_step(int64_t step) {
  if (step % every_ == 0)
    flush();
}

static void append_line(const Ledger::Row &row, std::vector<char> &bytes) {
  char line[(NUMBER_MOST + 1) * Ledger::N_COLUMNS], *end = line;
  for (int i = 0; i < Ledger::N_COLUMNS; i++) {
    if (i > 0)
      *end++ = ',';
    if (i == Ledger::COR_T && !(row[Ledger::COR_T_DEFINED] > 0))
      continue;
    end = COLUMNS[i].type[0] == 'i' ? print_count(static_cast<long long>(row[i]), end)
                                    : print_number(row[i], end);
  }
  *end++ = '\n';
  bytes.insert(bytes.end(), line, end);
}

static void append_record(const Ledger::Row &row, std::vector<char> &bytes) {
  char record[sizeof(int64_t) * Ledger::N_COLUMNS], *end = record;
  for (int i = 0; i < Ledger::N_COLUMNS; i++) {
    double value = row[i];
    if (i == Ledger::COR_T && !(row[Ledger::COR_T_DEFINED] > 0))
      value = NAN;
    if (COLUMNS[i].type[0] == 'i') {
      const int64_t whole = static_cast<int64_t>(value); /* its first bytes: the same in fewer */
      memcpy(end, &whole, sizeof whole);
    } else if (bytes_of(i) == 4) {
      const float single = static_cast<float>(value);
      memcpy(end, &single, sizeof single);
    } else
      memcpy(end, &value, sizeof value);
    end += bytes_of(i);
  }
  bytes.insert(bytes.end(), record, end);
}

/* The rows that are not in the file yet. */
std::vector<size_t> Ledger::sorted() const {
  auto key = [this](size_t i) {
    const Row &r = row(i);
    return Key{r[STEP], r[TIME], r[TAG], r[IMPACT]};
  };
  std::vector<size_t> order(size_ - written_);
  for (size_t i = 0; i < order.size(); i++)
    order[i] = written_ + i;
  std::sort(order.begin(), order.end(), [&key](size_t a, size_t b) { return key(a) < key(b); });
  return order;
}

/* The next piece of a rank's rows, from one of them on; an empty one at their end. */
void Ledger::print(const std::vector<size_t> &order, size_t from, Piece &piece) const {
  piece.keys.clear();
  piece.lengths.clear();
  piece.bytes.clear();
  for (size_t i = from; i < std::min(from + PIECE, order.size()); i++) {
    const Row &r = row(order[i]);
    const size_t before = piece.bytes.size();
    if (is_array_)
      append_record(r, piece.bytes);
    else
      append_line(r, piece.bytes);
    piece.keys.push_back(Key{r[STEP], r[TIME], r[TAG], r[IMPACT]});
    piece.lengths.push_back(static_cast<int>(piece.bytes.size() - before));
  }
}

void Ledger::send(const std::vector<size_t> &order) const {
  Piece piece;
  for (size_t from = 0; from < order.size(); from += PIECE) {
    print(order, from, piece);
    const int rows = static_cast<int>(piece.keys.size());
    MPI_Send(piece.keys.data(), rows * static_cast<int>(sizeof(Key)), MPI_BYTE, 0, TAG_OF_MESSAGES,
             world_);
    MPI_Send(piece.lengths.data(), rows, MPI_INT, 0, TAG_OF_MESSAGES, world_);
    MPI_Send(piece.bytes.data(), static_cast<int>(piece.bytes.size()), MPI_CHAR, 0, TAG_OF_MESSAGES,
             world_);
  }
}

/* One rank's rows as the first rank takes them up, piece by piece. */
class Ledger::Source {
public:
  Source(const Ledger &ledger, const std::vector<size_t> &order, int rank, long long count)
      : ledger_(ledger), order_(order), rank_(rank), left_(count), taken_(0) {
    next_piece();
  }
  const Key &key() const {
    return piece_.keys[at_];
  }
  /* Writes the row; false when it was the last one. */
  bool write(FILE *file) {
    fwrite(piece_.bytes.data() + begin_, 1, piece_.lengths[at_], file);
    begin_ += piece_.lengths[at_];
    if (++at_ == piece_.keys.size() && left_ > 0)
      next_piece();
    return at_ < piece_.keys.size();
  }

private:
  void next_piece() {
    const int rows = static_cast<int>(std::min(left_, static_cast<long long>(PIECE)));
    at_ = begin_ = 0;
    if (rank_ == ledger_.rank_)
      ledger_.print(order_, taken_, piece_);
    else
      receive(rows);
    taken_ += rows;
    left_ -= rows;
  }
  void receive(int rows) {
    piece_.keys.resize(rows);
    piece_.lengths.resize(rows);
    MPI_Recv(piece_.keys.data(), rows * static_cast<int>(sizeof(Key)), MPI_BYTE, rank_,
             TAG_OF_MESSAGES, ledger_.world_, MPI_STATUS_IGNORE);
    MPI_Recv(piece_.lengths.data(), rows, MPI_INT, rank_, TAG_OF_MESSAGES, ledger_.world_,
             MPI_STATUS_IGNORE);
    piece_.bytes.resize(std::accumulate(piece_.lengths.begin(), piece_.lengths.end(), 0));
    MPI_Recv(piece_.bytes.data(), static_cast<int>(piece_.bytes.size()), MPI_CHAR, rank_,
             TAG_OF_MESSAGES, ledger_.world_, MPI_STATUS_IGNORE);
  }

  const Ledger &ledger_;
  const std::vector<size_t> &order_; /* of this rank */
  int rank_;
  long long left_;
  size_t taken_, at_, begin_;
  Piece piece_;
};

/* All ranks' rows into the file, always the first one of those that are next. */
void Ledger::merge(const std::vector<size_t> &order, const std::vector<long long> &counts) {
  std::vector<std::unique_ptr<Source>> sources;
  for (int rank = 0; rank < ranks_; rank++)
    if (counts[rank] > 0)
      sources.push_back(std::unique_ptr<Source>(new Source(*this, order, rank, counts[rank])));
  auto later = [](const std::unique_ptr<Source> &a, const std::unique_ptr<Source> &b) {
    return b->key() < a->key();
  };
  std::make_heap(sources.begin(), sources.end(), later);
  while (!sources.empty()) {
    std::pop_heap(sources.begin(), sources.end(), later);
    if (sources.back()->write(file_))
      std::push_heap(sources.begin(), sources.end(), later);
    else
      sources.pop_back();
  }
}

/* Each rank prints its own rows, which is most of the work; the first one puts them in order. */
std::string Ledger::flush() {
  if (path_.empty())
    return "";
  const std::vector<size_t> order = sorted();
  long long mine = static_cast<long long>(order.size());
  std::vector<long long> counts(ranks_);
  MPI_Gather(&mine, 1, MPI_LONG_LONG, counts.data(), 1, MPI_LONG_LONG, 0, world_);
  if (rank_ == 0)
    merge(order, counts);
  else
    send(order);
  written_ = size_;
  int bad = rank_ == 0 && (fflush(file_) != 0 || ferror(file_));
  in_file_ = std::accumulate(counts.begin(), counts.end(), in_file_);
  if (rank_ == 0 && is_array_ && !bad)
    write_header();
  MPI_Bcast(&bad, 1, MPI_INT, 0, world_);
  return bad ? "writing the ledger file '" + path_ + "' failed; is the disk full?" : "";
}

double **Ledger::rows() {
  pointers_.resize(size_);
  for (size_t i = 0; i < size_; i++)
    pointers_[i] = row(i).data();
  return pointers_.data();
}

double Ledger::memory_usage() const {
  return static_cast<double>(blocks_.size() * BLOCK * sizeof(Row) +
                             pointers_.capacity() * sizeof(double *));
}
