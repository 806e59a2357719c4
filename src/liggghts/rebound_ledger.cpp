/* The ledger of a rough wall; see rebound_ledger.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound_ledger.h"

#include <errno.h>
#include <string.h>
#include <algorithm>
#include <numeric>
#include <tuple>

#include "rebound_number.h"

using namespace LAMMPS_NS;

static const char COLUMNS[] =
    "tag,impact,time,mesh,triangle,x,y,z,d_p,v1,alpha1_deg,delta_alpha_deg,tilt_out_deg,hits,v2,"
    "alpha2_deg,cor_n,cor_t,outcome\n";

/* How many rows a rank sends at once: the first rank holds as many of each. */
static const size_t PIECE = 256;
static const int TAG_OF_MESSAGES = 7301;

bool ReboundLedger::Key::operator<(const Key &other) const {
  return std::tie(step, time, tag, impact) <
         std::tie(other.step, other.time, other.tag, other.impact);
}

ReboundLedger::ReboundLedger(MPI_Comm world, bigint every, const std::string &path)
    : world_(world), every_(every), path_(path), file_(NULL), size_(0), written_(0) {
  MPI_Comm_rank(world_, &rank_);
  MPI_Comm_size(world_, &ranks_);
}

ReboundLedger::~ReboundLedger() {
  if (file_)
    fclose(file_);
}

std::string ReboundLedger::open(bool append, const std::string &heading) {
  int bad = 0;
  if (rank_ == 0 && !path_.empty() && !file_) {
    file_ = fopen(path_.c_str(), append ? "a" : "w");
    bad = file_ ? 0 : errno;
    if (file_ && ftell(file_) <= 0)
      fprintf(file_, "%s\n%s", heading.c_str(), COLUMNS);
    if (file_)
      fflush(file_);
  }
  MPI_Bcast(&bad, 1, MPI_INT, 0, world_);
  return bad ? "cannot write the ledger file '" + path_ + "': " + strerror(bad) : "";
}

void ReboundLedger::add(const Row &added) {
  if (size_ == blocks_.size() * BLOCK)
    blocks_.push_back(std::unique_ptr<Row[]>(new Row[BLOCK]));
  row(size_++) = added;
}

void ReboundLedger::begin_step(bigint step) {
  if ((step - 1) % every_ != 0)
    return;
  size_ = written_ = 0;
}

void ReboundLedger::end_step(bigint step) {
  if (step % every_ == 0)
    flush();
}

/* Counts as whole numbers. */
static bool is_count(int column) {
  return column == ReboundLedger::TAG || column == ReboundLedger::IMPACT ||
         column == ReboundLedger::MESH || column == ReboundLedger::TRIANGLE ||
         column == ReboundLedger::HITS || column == ReboundLedger::OUTCOME;
}

static void append_line(const ReboundLedger::Row &row, std::vector<char> &text) {
  char line[(NUMBER_MOST + 1) * ReboundLedger::N_COLUMNS], *end = line;
  for (int i = 0; i < ReboundLedger::N_COLUMNS; i++) {
    if (i > 0)
      *end++ = ',';
    if (i == ReboundLedger::COR_T && !(row[ReboundLedger::COR_T_DEFINED] > 0))
      continue;
    end =
        is_count(i) ? print_count(static_cast<long long>(row[i]), end) : print_number(row[i], end);
  }
  *end++ = '\n';
  text.insert(text.end(), line, end);
}

/* The rows that are not in the file yet. */
std::vector<size_t> ReboundLedger::sorted() const {
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
void ReboundLedger::print(const std::vector<size_t> &order, size_t from, Piece &piece) const {
  piece.keys.clear();
  piece.lengths.clear();
  piece.text.clear();
  for (size_t i = from; i < std::min(from + PIECE, order.size()); i++) {
    const Row &r = row(order[i]);
    const size_t before = piece.text.size();
    append_line(r, piece.text);
    piece.keys.push_back(Key{r[STEP], r[TIME], r[TAG], r[IMPACT]});
    piece.lengths.push_back(static_cast<int>(piece.text.size() - before));
  }
}

void ReboundLedger::send(const std::vector<size_t> &order) const {
  Piece piece;
  for (size_t from = 0; from < order.size(); from += PIECE) {
    print(order, from, piece);
    const int rows = static_cast<int>(piece.keys.size());
    MPI_Send(piece.keys.data(), rows * static_cast<int>(sizeof(Key)), MPI_BYTE, 0, TAG_OF_MESSAGES,
             world_);
    MPI_Send(piece.lengths.data(), rows, MPI_INT, 0, TAG_OF_MESSAGES, world_);
    MPI_Send(piece.text.data(), static_cast<int>(piece.text.size()), MPI_CHAR, 0, TAG_OF_MESSAGES,
             world_);
  }
}

/* One rank's rows as the first rank takes them up, piece by piece. */
class ReboundLedger::Source {
public:
  Source(const ReboundLedger &ledger, const std::vector<size_t> &order, int rank, long long count)
      : ledger_(ledger), order_(order), rank_(rank), left_(count), taken_(0) {
    next_piece();
  }
  const Key &key() const {
    return piece_.keys[at_];
  }
  /* Writes the row; false when it was the last one. */
  bool write(FILE *file) {
    fwrite(piece_.text.data() + begin_, 1, piece_.lengths[at_], file);
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
    piece_.text.resize(std::accumulate(piece_.lengths.begin(), piece_.lengths.end(), 0));
    MPI_Recv(piece_.text.data(), static_cast<int>(piece_.text.size()), MPI_CHAR, rank_,
             TAG_OF_MESSAGES, ledger_.world_, MPI_STATUS_IGNORE);
  }

  const ReboundLedger &ledger_;
  const std::vector<size_t> &order_; /* of this rank */
  int rank_;
  long long left_;
  size_t taken_, at_, begin_;
  Piece piece_;
};

/* All ranks' rows into the file, always the first one of those that are next. */
void ReboundLedger::merge(const std::vector<size_t> &order, const std::vector<long long> &counts) {
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
std::string ReboundLedger::flush() {
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
  MPI_Bcast(&bad, 1, MPI_INT, 0, world_);
  return bad ? "writing the ledger file '" + path_ + "' failed; is the disk full?" : "";
}

double **ReboundLedger::rows() {
  pointers_.resize(size_);
  for (size_t i = 0; i < size_; i++)
    pointers_[i] = row(i).data();
  return pointers_.data();
}

double ReboundLedger::memory_usage() const {
  return static_cast<double>(blocks_.size() * BLOCK * sizeof(Row) +
                             pointers_.capacity() * sizeof(double *));
}
