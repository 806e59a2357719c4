/* The ledger of a rough wall; see rebound_ledger.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound_ledger.h"

#include <errno.h>
#include <string.h>
#include <algorithm>

using namespace LAMMPS_NS;

static const char COLUMNS[] =
    "tag,impact,time,mesh,triangle,x,y,z,d_p,v1,alpha1_deg,delta_alpha_deg,tilt_out_deg,hits,v2,"
    "alpha2_deg,cor_n,cor_t,outcome\n";

ReboundLedger::ReboundLedger(MPI_Comm world, bigint every, const std::string &path)
    : world_(world), every_(every), path_(path), file_(NULL), failed_(false), written_(0) {
  MPI_Comm_rank(world_, &rank_);
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

void ReboundLedger::add(const Row &row) {
  rows_.push_back(row);
}

void ReboundLedger::begin_step(bigint step) {
  if ((step - 1) % every_ != 0)
    return;
  rows_.clear();
  written_ = 0;
}

void ReboundLedger::end_step(bigint step) {
  if (step % every_ == 0)
    flush();
}

static bool earlier(const ReboundLedger::Row &a, const ReboundLedger::Row &b) {
  static const int keys[] = {ReboundLedger::STEP, ReboundLedger::TIME, ReboundLedger::TAG,
                             ReboundLedger::IMPACT};
  for (int key : keys)
    if (a[key] < b[key] || b[key] < a[key])
      return a[key] < b[key];
  return false;
}

std::string ReboundLedger::flush() {
  if (path_.empty())
    return "";
  int ranks, mine = static_cast<int>((rows_.size() - written_) * N_FIELDS);
  MPI_Comm_size(world_, &ranks);
  std::vector<int> counts(ranks), starts(ranks + 1, 0);
  MPI_Gather(&mine, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, world_);
  for (int i = 0; i < ranks; i++)
    starts[i + 1] = starts[i] + counts[i];
  std::vector<Row> all(rank_ == 0 ? starts[ranks] / N_FIELDS : 0);
  MPI_Gatherv(rows_.data() + written_, mine, MPI_DOUBLE, all.data(), counts.data(), starts.data(),
              MPI_DOUBLE, 0, world_);
  written_ = rows_.size();
  if (rank_ == 0)
    write(all);
  int bad = failed_ ? 1 : 0;
  MPI_Bcast(&bad, 1, MPI_INT, 0, world_);
  return bad ? "writing the ledger file '" + path_ + "' failed; is the disk full?" : "";
}

/* Counts as whole numbers: also much cheaper to print than doubles. */
static bool is_count(int column) {
  return column == ReboundLedger::TAG || column == ReboundLedger::IMPACT ||
         column == ReboundLedger::MESH || column == ReboundLedger::TRIANGLE ||
         column == ReboundLedger::HITS || column == ReboundLedger::OUTCOME;
}

void ReboundLedger::write(const std::vector<Row> &rows) {
  std::vector<const Row *> order;
  for (const Row &row : rows)
    order.push_back(&row);
  std::sort(order.begin(), order.end(), [](const Row *a, const Row *b) { return earlier(*a, *b); });
  for (const Row *ordered : order) {
    const Row &row = *ordered;
    char line[32 * N_COLUMNS];
    int length = 0;
    for (int i = 0; i < N_COLUMNS; i++) {
      const char *separator = i ? "," : "";
      char *end = line + length;
      const size_t room = sizeof line - length;
      if (i == COR_T && !(row[COR_T_DEFINED] > 0))
        length += snprintf(end, room, "%s", separator);
      else if (is_count(i))
        length += snprintf(end, room, "%s%lld", separator, static_cast<long long>(row[i]));
      else
        length += snprintf(end, room, "%s%.10g", separator, row[i]);
    }
    line[length++] = '\n';
    fwrite(line, 1, length, file_);
  }
  if (fflush(file_) != 0)
    failed_ = true;
}

double **ReboundLedger::rows() {
  pointers_.resize(rows_.size());
  for (size_t i = 0; i < rows_.size(); i++)
    pointers_[i] = rows_[i].data();
  return pointers_.data();
}

double ReboundLedger::memory_usage() const {
  return static_cast<double>(rows_.capacity() * sizeof(Row) +
                             pointers_.capacity() * sizeof(double *));
}
