/* The ledger of a rough wall; see ledger.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/books/ledger.h"

#include <algorithm>
#include <new>
#include <numeric>
#include <tuple>

#include "dem/error.h"

using namespace asperity;

/* Rows per message: the first rank holds this many of each rank. */
static const size_t PIECE = 256;
static const int TAG_OF_MESSAGES = 7301;

bool Ledger::Key::operator<(const Key &other) const {
  return std::tie(step, time, tag, impact) <
         std::tie(other.step, other.time, other.tag, other.impact);
}

Ledger::Ledger(MPI_Comm world, int64_t every, const std::string &path, OnError on_error,
               int columns)
    : world_(world), every_(every), path_(path), on_error_(on_error), n_columns_(columns), saved_(),
      is_open_(false), first_(0), last_(0), lost_(0), columns_(columns), others_(N_FIELDS - N_FULL),
      size_(0), written_(0) {
  MPI_Comm_rank(world_, &rank_);
  MPI_Comm_size(world_, &ranks_);
  if (rank_ == 0 && !path_.empty())
    file_.reset(new LedgerFile(path, columns));
}

Ledger::~Ledger() {}

void Ledger::restore(const LedgerState &saved) {
  saved_ = saved;
}

/* A text of rank 0 on all ranks. */
std::string Ledger::share(std::string text) const {
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, world_);
  text.resize(static_cast<size_t>(length));
  if (length > 0)
    MPI_Bcast(&text[0], length, MPI_CHAR, 0, world_);
  return text;
}

std::string Ledger::open(const std::string &heading) {
  if (is_open_ || path_.empty())
    return "";
  std::string report, wrong;
  try {
    if (file_)
      report = file_->open(saved_, heading);
  } catch (const Error &error) {
    wrong = error.what();
  }
  wrong = share(wrong);
  if (!wrong.empty())
    throw Error(wrong);
  is_open_ = true;
  return share(report);
}

void Ledger::Table::make_room(size_t rows) {
  if (rows <= room_)
    return;
  const size_t room = std::max(2 * room_, rows + 255);
  void *grown = realloc(numbers_.get(), room * columns_ * sizeof(double));
  if (!grown)
    throw std::bad_alloc();
  numbers_.release();
  numbers_.reset(static_cast<double *>(grown));
  room_ = room;
}

void Ledger::add_row(const Row &added) {
  columns_.make_room(size_ + 1);
  others_.make_room(size_ + 1);
  std::copy(added.begin(), added.begin() + n_columns_, columns_.row(size_));
  std::copy(added.begin() + N_FULL, added.end(), others_.row(size_));
  size_++;
}

Ledger::Row Ledger::row(size_t i) const {
  Row whole;
  std::copy(columns_.row(i), columns_.row(i + 1), whole.begin());
  std::copy(others_.row(i), others_.row(i + 1), whole.begin() + N_FULL);
  return whole;
}

void Ledger::begin_step(int64_t step) {
  if ((step - 1) % every_ != 0)
    return;
  size_ = written_ = 0;
}

std::string Ledger::end_step(int64_t step) {
  return step % every_ == 0 ? flush() : "";
}

/* The rows that are not in the file yet. */
std::vector<size_t> Ledger::sorted() const {
  std::vector<size_t> order(size_ - written_);
  for (size_t i = 0; i < order.size(); i++)
    order[i] = written_ + i;
  std::sort(order.begin(), order.end(), [this](size_t a, size_t b) { return key(a) < key(b); });
  return order;
}

/* The next piece of a rank's rows, from one of them on; an empty one at their end. */
void Ledger::print(const std::vector<size_t> &order, size_t from, Piece &piece) const {
  piece.keys.clear();
  piece.lengths.clear();
  piece.bytes.clear();
  for (size_t i = from; i < std::min(from + PIECE, order.size()); i++) {
    const Row r = row(order[i]);
    const size_t before = piece.bytes.size();
    if (is_ledger_array(path_))
      append_record(r, n_columns_, piece.bytes);
    else
      append_line(r, n_columns_, piece.bytes);
    piece.keys.push_back(key(order[i]));
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
  bool write(LedgerFile &file) {
    file.append(piece_.bytes.data() + begin_, piece_.lengths[at_]);
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

/* Merges the sorted rows of all ranks into the file. */
void Ledger::merge(const std::vector<size_t> &order, const std::vector<long long> &counts) {
  std::vector<std::unique_ptr<Source>> sources;
  for (int rank = 0; rank < ranks_; rank++)
    if (counts[rank] > 0)
      sources.push_back(std::unique_ptr<Source>(new Source(*this, order, rank, counts[rank])));
  auto later = [](const std::unique_ptr<Source> &a, const std::unique_ptr<Source> &b) {
    return b->key() < a->key();
  };
  std::make_heap(sources.begin(), sources.end(), later);
  first_ = sources.empty() ? 0 : sources.front()->key().step;
  while (!sources.empty()) {
    std::pop_heap(sources.begin(), sources.end(), later);
    last_ = sources.back()->key().step;
    if (sources.back()->write(*file_))
      std::push_heap(sources.begin(), sources.end(), later);
    else
      sources.pop_back();
  }
}

/* On rank 0. */
std::string Ledger::commit(int64_t rows) {
  const std::string why = file_->commit(rows);
  if (why.empty())
    return "";
  lost_ += rows;
  const int64_t first = static_cast<int64_t>(first_), last = static_cast<int64_t>(last_);
  return "writing the ledger file '" + path_ + "' failed: " + why + "; " + std::to_string(rows) +
         " rows of the steps " + std::to_string(first) + " to " + std::to_string(last) +
         " are lost, " + std::to_string(lost_) + " in all";
}

/* Each rank prints its own rows, which is most of the work; the first one puts them in order. What
 * cannot be written is taken from the other ranks all the same, since they would wait. */
std::string Ledger::flush() {
  if (!is_open_)
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
  const int64_t rows = std::accumulate(counts.begin(), counts.end(), int64_t(0));
  return share(rank_ == 0 && rows > 0 ? commit(rows) : "");
}

std::string Ledger::save(LedgerState &state) {
  std::string why = flush();
  state = saved_;
  if (!is_open_)
    return why;
  std::string late;
  if (file_) {
    late = file_->sync();
    state = file_->state();
  }
  late = share(late);
  if (!late.empty())
    why += (why.empty() ? "" : "; ") + ("the disk does not have all of the ledger file '" + path_ +
                                        "' that this restart file counts: " + late);
  return why;
}

double **Ledger::rows() {
  columns_.make_room(1); /* an engine may take the address of the first row where there is none */
  pointers_.resize(std::max(size_, static_cast<size_t>(1)));
  for (size_t i = 0; i < pointers_.size(); i++)
    pointers_[i] = columns_.row(i);
  return pointers_.data();
}

size_t Ledger::bytes() const {
  return columns_.bytes() + others_.bytes() + pointers_.capacity() * sizeof(double *);
}
