/* The ledger of a rough wall; see ledger.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/books/ledger.h"

#include <algorithm>

#include "dem/engine.h"
#include "dem/error.h"

using namespace asperity;

/* About so many rows of all ranks are printed and written at once. */
static const int64_t ROWS = 1 << 14;

Ledger::Ledger(MPI_Comm world, int64_t every, const std::string &path, OnError on_error,
               int columns)
    : world_(world), every_(every), path_(path), on_error_(on_error), n_columns_(columns), saved_(),
      is_open_(false), lost_(0), steps_most_(1), n_steps_(0) {
  MPI_Comm_rank(world_, &rank_);
  if (rank_ == 0 && !path_.empty())
    file_.reset(new LedgerFile(path, columns));
}

Ledger::~Ledger() {}

void Ledger::restore(const LedgerState &saved) {
  saved_ = saved;
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
  wrong = share(wrong, world_);
  if (!wrong.empty())
    throw Error(wrong);
  is_open_ = true;
  return share(report, world_);
}

void Ledger::add_row(const LedgerRow &added) {
  numbers_.insert(numbers_.end(), added.begin(), added.begin() + n_columns_);
  steps_.push_back(added[STEP]);
}

void Ledger::begin_step(int64_t step) {
  if ((step - 1) % every_ != 0)
    return;
  numbers_.clear();
  steps_.clear();
}

std::string Ledger::end_step(int64_t step) {
  n_steps_++;
  return step % every_ == 0 || n_steps_ >= steps_most_ ? flush() : "";
}

/* On rank 0. */
std::string Ledger::commit(const PrintedRows &rows) {
  const std::string why = rows.size() > 0 ? rows.commit(*file_) : "";
  if (why.empty())
    return "";
  double first = rows.keys[0], last = first;
  for (size_t i = 0; i < rows.size(); i++) {
    first = std::min(first, rows.keys[i * PrintedRows::KEY]);
    last = std::max(last, rows.keys[i * PrintedRows::KEY]);
  }
  lost_ += static_cast<int64_t>(rows.size());
  return "writing the ledger file '" + path_ + "' failed: " + why + "; " +
         std::to_string(rows.size()) + " rows of the steps " +
         std::to_string(static_cast<int64_t>(first)) + " to " +
         std::to_string(static_cast<int64_t>(last)) + " are lost, " + std::to_string(lost_) +
         " in all";
}

/* Each rank prints its own rows, which is most of the work; the first one puts them in order. The
 * rows of the next steps wait for as long as will make about ROWS of them. */
std::string Ledger::flush() {
  if (!is_open_)
    return "";
  PrintedRows mine;
  const double *row =
      numbers_.data() + numbers_.size() - steps_.size() * static_cast<size_t>(n_columns_);
  for (const double step : steps_) {
    mine.add(row, n_columns_, step);
    row += n_columns_;
  }
  steps_.clear();
  const PrintedRows all = {gather(mine.keys, world_), gather(mine.bytes, world_)};
  int64_t count = static_cast<int64_t>(all.size());
  MPI_Bcast(&count, 1, MPI_INT64_T, 0, world_);
  steps_most_ = std::max<int64_t>(1, 2 * count < ROWS ? 2 * n_steps_ : n_steps_ * ROWS / count);
  n_steps_ = 0;
  return share(rank_ == 0 ? commit(all) : "", world_);
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
  late = share(late, world_);
  if (!late.empty())
    why += (why.empty() ? "" : "; ") + ("the disk does not have all of the ledger file '" + path_ +
                                        "' that this restart file counts: " + late);
  return why;
}

double **Ledger::rows() {
  if (numbers_.empty())
    numbers_.reserve(1); /* an engine may take the address of the first row where there is none */
  pointers_.resize(std::max(static_cast<size_t>(size()), static_cast<size_t>(1)));
  for (size_t i = 0; i < pointers_.size(); i++)
    pointers_[i] = numbers_.data() + i * static_cast<size_t>(n_columns_);
  return pointers_.data();
}

size_t Ledger::bytes() const {
  return (numbers_.capacity() + steps_.capacity() + pointers_.capacity()) * sizeof(double);
}
