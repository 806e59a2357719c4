/* Packs and unpacks a wall's part of a restart file; see record.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/books/record.h"

#include <limits.h>
#include <string.h>
#include <algorithm>

#include "asperity_engine.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

namespace {

/* Another list of what is in a record is another version. */
const uint32_t VERSION = 6;
const char MAGIC[8] = {'a', 's', 'p', '-', 'w', 'a', 'l', 'l'};

struct Head {
  char magic[sizeof MAGIC];
  uint32_t version, length; /* with the head */
  uint32_t sum;             /* of what is behind the head */
  uint32_t sum_of_head;
};

[[noreturn]] void fail(const std::string &what) {
  throw Error("the restart file's record of this wall " + what +
              "; give the wall another ID to begin anew without it");
}

[[noreturn]] void damaged(const std::string &where) {
  fail("is damaged (" + where + ")");
}

struct Writer {
  std::vector<char> all;
  void bytes(const void *from, size_t length) {
    const char *begin = static_cast<const char *>(from);
    all.insert(all.end(), begin, begin + length);
  }
  template <class List> void resize(List &list) {
    const uint64_t size = list.size();
    bytes(&size, sizeof size);
  }
};

/* Never reads past the end, whatever lengths there are. */
struct Reader {
  const char *at;
  size_t left;
  void bytes(void *to, size_t length) {
    if (length > left)
      damaged("its contents");
    if (length > 0)
      memcpy(to, at, length);
    at += length;
    left -= length;
  }
  template <class List> void resize(List &list) {
    uint64_t size;
    bytes(&size, sizeof size);
    if (size > left)
      damaged("a length");
    list.resize(size);
  }
};

/* Writes or reads a value: a number, an array of them, or what is made of such values. */
template <class Of, class T> void each(Of &of, T &value) {
  of.bytes(&value, sizeof value);
}

template <class Of> void each(Of &of, std::string &text) {
  of.resize(text);
  of.bytes(&text[0], text.size());
}

template <class Of> void each(Of &of, std::vector<double> &numbers) {
  of.resize(numbers);
  of.bytes(numbers.data(), numbers.size() * sizeof(double));
}

template <class Of> void each(Of &of, std::pair<std::string, std::string> &setting) {
  each(of, setting.first);
  each(of, setting.second);
}

template <class Of> void each(Of &of, MeshState &mesh) {
  each(of, mesh.id);
  each(of, mesh.triangles);
  each(of, mesh.totals);
  each(of, mesh.map);
  each(of, mesh.motion);
}

template <class Of, class Item> void each(Of &of, std::vector<Item> &list) {
  of.resize(list);
  for (Item &item : list)
    each(of, item);
}

template <class Of> void each(Of &of, WallState &state) {
  each(of, state.settings);
  each(of, state.counters);
  each(of, state.totals);
  each(of, state.d_range);
  each(of, state.clock);
  each(of, state.meshes);
  each(of, state.bodies);
  each(of, state.ledger.path);
  each(of, state.ledger.rows);
  each(of, state.ledger.bytes);
  each(of, state.ledger.tail);
}

Head check_head(const char *bytes, size_t available) {
  Head head;
  if (available < sizeof head)
    fail("is cut short: it has " + std::to_string(available) + " bytes, its head " +
         std::to_string(sizeof head));
  memcpy(&head, bytes, sizeof head);
  if (memcmp(head.magic, MAGIC, sizeof MAGIC) != 0)
    fail("does not begin as one: it is damaged, or of a version that had no number yet");
  if (checksum(&head, offsetof(Head, sum_of_head)) != head.sum_of_head)
    damaged("its head, or it is of another version");
  if (head.version != VERSION)
    fail("is of version " + std::to_string(head.version) + "; it must be of version " +
         std::to_string(VERSION));
  if (head.length < sizeof head)
    damaged("its length");
  if (head.length > available)
    fail("is cut short: it has " + std::to_string(available) + " bytes of " +
         std::to_string(head.length));
  if (checksum(bytes + sizeof head, head.length - sizeof head) != head.sum)
    damaged("its contents");
  return head;
}

std::string value_of(const Settings &settings, const std::string &name) {
  for (const std::pair<std::string, std::string> &entry : settings)
    if (entry.first == name && !entry.second.empty())
      return entry.second;
  return "none";
}

} // namespace

Settings asperity::clauses(const Settings &settings) {
  Settings all;
  for (const std::pair<std::string, std::string> &entry : settings) {
    if (entry.first != "description") {
      all.push_back(entry);
      continue;
    }
    const char *at = entry.second.c_str();
    for (size_t length; (length = asp_description_clause(at)) > 0; at += length) {
      const std::string clause(at, length), name = clause.substr(0, clause.find(' '));
      const size_t end = clause.find_last_not_of(' ') + 1;
      all.push_back(std::make_pair(
          name, end > name.size() ? clause.substr(name.size() + 1, end - name.size() - 1) : ""));
    }
  }
  return all;
}

std::string asperity::describe_changes(const Settings &now, const Settings &saved) {
  std::string changes;
  Settings both = now;
  for (const std::pair<std::string, std::string> &entry : saved)
    if (std::none_of(now.begin(), now.end(),
                     [&entry](const std::pair<std::string, std::string> &other) {
                       return other.first == entry.first;
                     }))
      both.push_back(entry);
  for (const std::pair<std::string, std::string> &entry : both) {
    const std::string &name = entry.first;
    const std::string value = value_of(now, name), before = value_of(saved, name);
    if (value != before)
      changes += (changes.empty() ? "" : "; ") + name + " " + value + ", was " + before;
  }
  return changes;
}

void asperity::check_record_size(uint64_t bytes) {
  if (bytes > INT_MAX)
    throw Error("the record of this wall in a restart file has " + std::to_string(bytes) +
                " bytes; an engine takes " + std::to_string(INT_MAX) +
                " at most: leave out meshes, or triangles of them");
}

std::vector<char> asperity::pack(WallState &state) {
  Writer to;
  Head head = Head();
  each(to, head);
  each(to, state);
  memcpy(head.magic, MAGIC, sizeof MAGIC);
  head.version = VERSION;
  head.length = static_cast<uint32_t>(to.all.size());
  head.sum = checksum(to.all.data() + sizeof head, to.all.size() - sizeof head);
  head.sum_of_head = checksum(&head, offsetof(Head, sum_of_head));
  memcpy(to.all.data(), &head, sizeof head);
  return to.all;
}

WallState asperity::unpack(const char *bytes, size_t available) {
  const Head head = check_head(bytes, available);
  Reader from = {bytes + sizeof head, head.length - sizeof head};
  WallState state = WallState();
  each(from, state);
  if (from.left > 0)
    damaged("its length");
  return state;
}
