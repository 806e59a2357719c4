/* The ledger of a rough wall; see rebound_ledger.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound_ledger.h"

#include <errno.h>
#include <string.h>
#include <algorithm>
#include <tuple>
#include <utility>

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

/* Counts as whole numbers: also much cheaper to print than doubles. */
static bool is_count(int column) {
  return column == ReboundLedger::TAG || column == ReboundLedger::IMPACT ||
         column == ReboundLedger::MESH || column == ReboundLedger::TRIANGLE ||
         column == ReboundLedger::HITS || column == ReboundLedger::OUTCOME;
}

static void append_line(const ReboundLedger::Row &row, std::vector<char> &text) {
  char line[32 * ReboundLedger::N_COLUMNS];
  int length = 0;
  for (int i = 0; i < ReboundLedger::N_COLUMNS; i++) {
    const char *separator = i ? "," : "";
    char *end = line + length;
    const size_t room = sizeof line - length;
    if (i == ReboundLedger::COR_T && !(row[ReboundLedger::COR_T_DEFINED] > 0))
      length += snprintf(end, room, "%s", separator);
    else if (is_count(i))
      length += snprintf(end, room, "%s%lld", separator, static_cast<long long>(row[i]));
    else
      length += snprintf(end, room, "%s%.10g", separator, row[i]);
  }
  line[length++] = '\n';
  text.insert(text.end(), line, line + length);
}

/* What all ranks have of T, one rank after the other, on rank 0. */
template <class T>
static std::vector<T> gather(MPI_Comm world, int rank, const std::vector<T> &mine) {
  int ranks, bytes = static_cast<int>(mine.size() * sizeof(T));
  MPI_Comm_size(world, &ranks);
  std::vector<int> counts(ranks), starts(ranks + 1, 0);
  MPI_Gather(&bytes, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, world);
  for (int i = 0; i < ranks; i++)
    starts[i + 1] = starts[i] + counts[i];
  std::vector<T> all(rank == 0 ? starts[ranks] / sizeof(T) : 0);
  MPI_Gatherv(mine.data(), bytes, MPI_BYTE, all.data(), counts.data(), starts.data(), MPI_BYTE, 0,
              world);
  return all;
}

/* Each rank prints its own rows, which is most of the work; the first one puts them in order. */
std::string ReboundLedger::flush() {
  if (path_.empty())
    return "";
  std::vector<Line> lines;
  std::vector<char> text;
  for (; written_ < rows_.size(); written_++) {
    const Row &row = rows_[written_];
    const size_t before = text.size();
    append_line(row, text);
    lines.push_back(Line{row[STEP], row[TIME], row[TAG], row[IMPACT], text.size() - before});
  }
  lines = gather(world_, rank_, lines);
  text = gather(world_, rank_, text);
  if (rank_ == 0)
    write(lines, text);
  int bad = failed_ ? 1 : 0;
  MPI_Bcast(&bad, 1, MPI_INT, 0, world_);
  return bad ? "writing the ledger file '" + path_ + "' failed; is the disk full?" : "";
}

void ReboundLedger::write(const std::vector<Line> &lines, const std::vector<char> &text) {
  std::vector<std::pair<const Line *, const char *>> order;
  const char *begin = text.data();
  for (const Line &line : lines) {
    order.push_back(std::make_pair(&line, begin));
    begin += line.length;
  }
  std::sort(order.begin(), order.end(),
            [](const std::pair<const Line *, const char *> &a,
               const std::pair<const Line *, const char *> &b) {
              return std::tie(a.first->step, a.first->time, a.first->tag, a.first->impact) <
                     std::tie(b.first->step, b.first->time, b.first->tag, b.first->impact);
            });
  for (const std::pair<const Line *, const char *> &line : order)
    fwrite(line.second, 1, line.first->length, file_);
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
