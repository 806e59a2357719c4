/* Packs and unpacks a wall's part of a restart file; see record.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/books/record.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <algorithm>

#include "asperity_internal.h"
#include "dem/books/checksum.h"
#include "dem/error.h"

using namespace asperity;

namespace {

/* The form of head and sections is the same in all versions; what is in the sections is not. */
const uint32_t VERSION = 3;
const char MAGIC[8] = {'a', 's', 'p', '-', 'w', 'a', 'l', 'l'};

struct Head {
  char magic[sizeof MAGIC];
  uint32_t version, sections;
  uint64_t length; /* with the head */
  uint32_t sum;    /* of what is behind the head */
  uint32_t sum_of_head;
};

const std::string ADVICE = "; give the wall another ID to begin anew without it";

void fail(const std::string &what) {
  throw Error("the restart file's record of this wall " + what + ADVICE);
}

void damaged(const std::string &where) {
  fail("is damaged (" + where + ")");
}

class Writer {
public:
  Writer() : sections_(0), length_at_(0) {
    bytes_.resize(sizeof(Head));
  }
  template <class T> void number(T value) {
    bytes(&value, sizeof value);
  }
  void text(const std::string &value) {
    number<uint64_t>(value.size());
    bytes(value.data(), value.size());
  }
  void numbers(const std::vector<double> &values) {
    number<uint64_t>(values.size());
    bytes(values.data(), values.size() * sizeof(double));
  }
  void begin(const std::string &name) {
    text(name);
    length_at_ = bytes_.size();
    number<uint64_t>(0);
    sections_++;
  }
  void end() {
    const uint64_t length = bytes_.size() - length_at_ - sizeof length;
    memcpy(&bytes_[length_at_], &length, sizeof length);
  }
  std::vector<char> finish() {
    Head head;
    memset(&head, 0, sizeof head);
    memcpy(head.magic, MAGIC, sizeof MAGIC);
    head.version = VERSION;
    head.sections = sections_;
    head.length = bytes_.size();
    head.sum = checksum(bytes_.data() + sizeof head, bytes_.size() - sizeof head);
    head.sum_of_head = checksum(&head, offsetof(Head, sum_of_head));
    memcpy(bytes_.data(), &head, sizeof head);
    return bytes_;
  }

private:
  void bytes(const void *from, size_t length) {
    const char *begin = static_cast<const char *>(from);
    bytes_.insert(bytes_.end(), begin, begin + length);
  }

  std::vector<char> bytes_;
  uint32_t sections_;
  size_t length_at_;
};

/* Reads a record and never past its end, whatever lengths it contains. */
class Reader {
public:
  Reader(const std::string &name, const char *begin, size_t length)
      : name_(name), at_(begin), left_(length) {}
  template <class T> T number() {
    T value;
    bytes(&value, sizeof value);
    return value;
  }
  std::string text() {
    std::string value(count(1), '\0');
    bytes(&value[0], value.size());
    return value;
  }
  std::vector<double> numbers() {
    std::vector<double> values(count(sizeof(double)));
    bytes(values.data(), values.size() * sizeof(double));
    return values;
  }
  void numbers(double *to, size_t n) {
    const std::vector<double> values = numbers();
    if (values.size() != n)
      damaged(name_);
    std::copy(values.begin(), values.end(), to);
  }
  Reader section() {
    const std::string name = text();
    const size_t length = count(1);
    Reader part(name, at_, length);
    at_ += length;
    left_ -= length;
    return part;
  }
  const std::string &name() const {
    return name_;
  }
  bool done() const {
    return left_ == 0;
  }

private:
  size_t count(size_t size) {
    const uint64_t n = number<uint64_t>();
    if (n > left_ / size)
      damaged(name_);
    return static_cast<size_t>(n);
  }
  void bytes(void *to, size_t length) {
    if (length > left_)
      damaged(name_);
    if (length > 0)
      memcpy(to, at_, length);
    at_ += length;
    left_ -= length;
  }

  std::string name_;
  const char *at_;
  size_t left_;
};

Head check_head(const char *bytes, size_t available) {
  Head head;
  if (available < sizeof head)
    fail("is cut short: it has " + std::to_string(available) + " bytes, its head " +
         std::to_string(sizeof head));
  memcpy(&head, bytes, sizeof head);
  if (memcmp(head.magic, MAGIC, sizeof MAGIC) != 0)
    fail("does not begin as one: it is damaged, or of a version that had no number yet");
  if (checksum(&head, offsetof(Head, sum_of_head)) != head.sum_of_head)
    damaged("its head");
  if (head.version != VERSION)
    fail("is of version " + std::to_string(head.version) + "; it must be of version " +
         std::to_string(VERSION));
  if (head.length < sizeof head || head.length > INT_MAX)
    damaged("its length");
  if (head.length > available)
    fail("is cut short: it has " + std::to_string(available) + " bytes of " +
         std::to_string(head.length));
  if (checksum(bytes + sizeof head, head.length - sizeof head) != head.sum)
    damaged("its contents");
  return head;
}

MeshState read_mesh(Reader &from) {
  MeshState mesh;
  mesh.id = from.text();
  mesh.triangles = from.number<int64_t>();
  mesh.totals = from.numbers();
  mesh.map = from.numbers();
  mesh.motion = from.numbers();
  return mesh;
}

LedgerState read_ledger(Reader &from) {
  LedgerState ledger;
  ledger.path = from.text();
  ledger.rows = from.number<int64_t>();
  ledger.bytes = from.number<int64_t>();
  ledger.tail = from.number<uint32_t>();
  return ledger;
}

Settings read_settings(Reader &from) {
  Settings settings;
  while (!from.done()) {
    const std::string name = from.text();
    settings.push_back(std::make_pair(name, from.text()));
  }
  return settings;
}

std::string value_of(const Settings &settings, const std::string &name) {
  for (const std::pair<std::string, std::string> &entry : settings)
    if (entry.first == name && !entry.second.empty())
      return entry.second;
  return "none";
}

std::string impacts_of(const std::vector<double> &totals) {
  return setting(totals.empty() ? 0 : totals[0]) + " impacts";
}

std::string triangles(int64_t count) {
  return std::to_string(count) + (count == 1 ? " triangle" : " triangles");
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

std::string asperity::setting(double value) {
  char text[32];
  snprintf(text, sizeof text, "%.15g", value);
  return text;
}

void asperity::check_record_size(uint64_t bytes) {
  if (bytes > INT_MAX)
    throw Error("the record of this wall in a restart file has " + std::to_string(bytes) +
                " bytes; an engine takes " + std::to_string(INT_MAX) +
                " at most: leave out meshes, or triangles of them");
}

std::vector<char> asperity::pack(const WallState &state) {
  Writer to;
  to.begin("settings");
  for (const std::pair<std::string, std::string> &entry : state.settings) {
    to.text(entry.first);
    to.text(entry.second);
  }
  to.end();
  to.begin("numbers");
  to.numbers(state.counters);
  to.numbers(state.totals);
  to.numbers(std::vector<double>(state.d_range, state.d_range + 2));
  to.numbers(std::vector<double>(state.clock, state.clock + 3));
  to.end();
  for (const MeshState &mesh : state.meshes) {
    to.begin("mesh");
    to.text(mesh.id);
    to.number(mesh.triangles);
    to.numbers(mesh.totals);
    to.numbers(mesh.map);
    to.numbers(mesh.motion);
    to.end();
  }
  if (!state.bodies.empty()) {
    to.begin("bodies");
    to.numbers(state.bodies);
    to.end();
  }
  to.begin("ledger");
  to.text(state.ledger.path);
  to.number(state.ledger.rows);
  to.number(state.ledger.bytes);
  to.number(state.ledger.tail);
  to.end();
  return to.finish();
}

WallState asperity::unpack(const char *bytes, size_t available) {
  const Head head = check_head(bytes, available);
  Reader all("a section", bytes + sizeof head, head.length - sizeof head);
  WallState state = WallState();
  for (uint32_t i = 0; i < head.sections; i++) {
    Reader part = all.section();
    if (part.name() == "settings")
      state.settings = read_settings(part);
    else if (part.name() == "mesh")
      state.meshes.push_back(read_mesh(part));
    else if (part.name() == "bodies")
      state.bodies = part.numbers();
    else if (part.name() == "ledger")
      state.ledger = read_ledger(part);
    else if (part.name() == "numbers") {
      state.counters = part.numbers();
      state.totals = part.numbers();
      part.numbers(state.d_range, 2);
      part.numbers(state.clock, 3);
    } else
      damaged("section '" + part.name() + "'");
  }
  return state;
}

std::vector<int> asperity::match_meshes(const WallState &saved,
                                        const std::vector<std::pair<std::string, int64_t>> &now,
                                        std::string &report) {
  std::vector<int> found(now.size(), -1);
  std::vector<std::string> lost;
  if (!now.empty() && !saved.totals.empty())
    lost.push_back("the " + impacts_of(saved.totals) + " of the primitive wall");
  for (size_t i = 0; i < saved.meshes.size(); i++) {
    const MeshState &mesh = saved.meshes[i];
    const std::string what = "the " + impacts_of(mesh.totals) + " of mesh '" + mesh.id + "', ";
    size_t k = 0;
    while (k < now.size() && now[k].first != mesh.id)
      k++;
    if (k == now.size())
      lost.push_back(what + "which is not one of this wall");
    else if (now[k].second != mesh.triangles)
      lost.push_back(what + "which had " + triangles(mesh.triangles) + " and has " +
                     std::to_string(now[k].second));
    else
      found[k] = static_cast<int>(i);
  }
  report.clear();
  for (const std::string &text : lost)
    report += (report.empty() ? "" : "; ") + text;
  return found;
}
