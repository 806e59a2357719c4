/* The memories of movers; see memory.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/memory.h"

#include <string.h>
#include <algorithm>
#include <map>

#include "dem/engine.h"
#include "dem/error.h"

using namespace asperity;

namespace {

template <class Item> size_t width_of(const std::vector<Item> &list) {
  return list.size() * sizeof(Item) / sizeof(double);
}

struct Count {
  size_t n;
  template <class Item> void operator()(const std::vector<Item> &list) {
    n += 1 + width_of(list);
  }
};

struct Write {
  double *to;
  template <class Item> void operator()(const std::vector<Item> &list) {
    *to++ = static_cast<double>(list.size());
    if (!list.empty())
      memcpy(to, list.data(), list.size() * sizeof(Item));
    to += width_of(list);
  }
};

struct Read {
  const double *from;
  template <class Item> void operator()(std::vector<Item> &list) {
    list.resize(static_cast<size_t>(*from++));
    if (!list.empty())
      memcpy(list.data(), from, list.size() * sizeof(Item));
    from += width_of(list);
  }
};

const size_t STATE = sizeof(MoverState) / sizeof(double);
const size_t HEAD = sizeof(MemoryHead) / sizeof(double);

} // namespace

size_t Memories::bytes() const {
  size_t all = memory.capacity() * sizeof memory[0] + loaded.capacity();
  for (const std::unique_ptr<Memory> &of : memory)
    if (of) {
      Count count = {0};
      of->each(count);
      all += sizeof *of + count.n * sizeof(double);
    }
  return all;
}

void Memories::copy(int from, int to) {
  const std::unique_ptr<Memory> &of = memory[static_cast<size_t>(from)];
  if (from != to)
    memory[static_cast<size_t>(to)].reset(of ? new Memory(*of) : NULL);
  loaded[static_cast<size_t>(to)] = loaded[static_cast<size_t>(from)];
}

void Memories::set_status(int i, Status now) {
  state[i].status = static_cast<double>(now);
  Memory *of = find(i);
  if (!of)
    return;
  if (now != Status::RESTING)
    of->rests.clear();
  if (now != Status::REBOUNDED)
    of->rebound.clear();
  if (!is_stuck(i))
    of->stuck.clear();
}

int Memories::pack(int i, double *to) const {
  const std::unique_ptr<Memory> &of = memory[static_cast<size_t>(i)];
  Write write = {to + 1};
  if (of) {
    memcpy(write.to, static_cast<const MemoryHead *>(of.get()), sizeof(MemoryHead));
    write.to += HEAD;
    of->each(write);
  }
  to[0] = static_cast<double>(write.to - to);
  return static_cast<int>(write.to - to);
}

int Memories::unpack(int i, const double *from) {
  clear(i);
  loaded[static_cast<size_t>(i)] = 1;
  if (from[0] > 1) {
    Memory &of = own(i);
    memcpy(static_cast<MemoryHead *>(&of), from + 1, sizeof(MemoryHead));
    Read read = {from + 1 + HEAD};
    of.each(read);
  }
  return static_cast<int>(from[0]);
}

/* ---- bodies ---- */

void BodyMemories::write(int64_t tag, const MoverState &its, const Memories &rows, size_t i,
                         std::vector<double> &to) {
  Count count = {1 + STATE + 1};
  if (rows.memory[i]) {
    count.n += HEAD;
    rows.memory[i]->each(count);
  }
  const size_t at = to.size();
  to.resize(at + count.n);
  to[at] = static_cast<double>(tag);
  memcpy(&to[at + 1], &its, sizeof its);
  rows.pack(static_cast<int>(i), &to[at + 1 + STATE]);
}

int64_t BodyMemories::read(const std::vector<double> &all, size_t &at, MoverState &its,
                           Memories &one) {
  const size_t begin = at + 1 + STATE;
  const double left = static_cast<double>(all.size()) - static_cast<double>(begin);
  if (!(left >= 1) || !(all[begin] >= 1 && all[begin] <= left))
    throw Error("the restart file's record of this wall has bodies of another form; give the wall "
                "another ID to begin anew without it");
  const int64_t tag = static_cast<int64_t>(all[at]);
  memcpy(&its, &all[at + 1], sizeof its);
  at = begin + static_cast<size_t>(one.unpack(0, &all[begin]));
  return tag;
}

std::vector<double> BodyMemories::pack() const {
  std::vector<double> all = waiting_;
  for (size_t b = 0; b < tags_.size(); b++)
    write(tags_[b], states_[b], *this, b, all);
  return all;
}

void BodyMemories::claim(const std::vector<int64_t> &tags, MPI_Comm world) {
  std::map<int64_t, size_t> number;
  std::vector<MoverState> states(tags.size(), MoverState());
  Memories next;
  next.grow(static_cast<int>(tags.size()));
  for (size_t b = 0; b < tags.size(); b++)
    number[tags[b]] = b;
  for (size_t b = 0; b < tags_.size(); b++) {
    const auto at = number.find(tags_[b]);
    if (at == number.end()) {
      write(tags_[b], states_[b], *this, b, waiting_);
      continue;
    }
    states[at->second] = states_[b];
    next.memory[at->second] = std::move(memory[b]);
  }
  const std::vector<double> all = gather_for_all(waiting_, world);
  for (size_t i = 0; i < all.size();) {
    MoverState its;
    Memories one;
    one.grow(1);
    const auto at = number.find(read(all, i, its, one));
    if (at == number.end())
      continue;
    states[at->second] = its;
    next.memory[at->second] = std::move(one.memory[0]);
  }
  waiting_.clear();
  tags_ = tags;
  states_.swap(states);
  memory.swap(next.memory);
  loaded.swap(next.loaded);
  state = states_.data();
}
