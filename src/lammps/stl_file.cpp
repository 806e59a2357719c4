/* An STL file, read as a stream; see stl_file.h. The format is that of 3D Systems'
 * StereoLithography Interface Specification (1988): text in words, or 80 bytes of any text, the
 * number of triangles, and 50 bytes for each. Either may begin with the word `solid`; a file is
 * binary if its length fits its number of triangles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "stl_file.h"

#include <cctype>
#include <cerrno>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "base/number.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

namespace {

const size_t HEAD = 84, RECORD = 50, NORMAL = 12, MOST = INT_MAX / 2;

/* True if the text begins with the name, in small letters or large. */
bool begins(const char *text, const char *name) {
  for (; *name; text++, name++)
    if (tolower(static_cast<unsigned char>(*text)) != *name)
      return false;
  return true;
}

class Stl {
public:
  Stl(const std::string &path, const std::function<void(const ContactTriangle &)> &take);
  void read();

private:
  enum State { OUTSIDE, SOLID, FACET, LOOP, LOOP_DONE };
  struct Word { /* of a line */
    const char *begin, *end;
    bool is(const char *name) const { /* in small letters or large */
      return strlen(name) == static_cast<size_t>(end - begin) && begins(begin, name);
    }
  };

  [[noreturn]] void fail(const std::string &must) const;
  void give();
  void read_binary(size_t count);
  void read_text();
  bool read_line();
  void split_line();
  void take_line();
  void vertex();

  const std::string &path_;
  const std::function<void(const ContactTriangle &)> &take_;
  std::unique_ptr<FILE, int (*)(FILE *)> file_;
  std::string line_; /* of a text */
  std::vector<Word> words_;
  int number_; /* of the line */
  State state_;
  ContactTriangle triangle_;
  int corners_;
  size_t triangles_;
};

Stl::Stl(const std::string &path, const std::function<void(const ContactTriangle &)> &take)
    : path_(path), take_(take), file_(fopen(path.c_str(), "rb"), fclose), number_(0),
      state_(OUTSIDE), triangle_(), corners_(0), triangles_(0) {}

void Stl::fail(const std::string &must) const {
  throw Error(
      text("STL file '%s', line %d: it says '%.80s'; ", path_.c_str(), number_, line_.c_str()) +
      must);
}

void Stl::give() {
  if (++triangles_ > MOST)
    throw Error(
        text("STL file '%s' has more than %zu triangles; it must have fewer", path_.c_str(), MOST));
  take_(triangle_);
}

/* Little-endian, whatever the machine is. */
uint32_t number_at(const unsigned char *at) {
  return at[0] | at[1] << 8 | at[2] << 16 | static_cast<uint32_t>(at[3]) << 24;
}

void Stl::read_binary(size_t count) {
  unsigned char record[RECORD];
  while (triangles_ < count && fread(record, RECORD, 1, file_.get()) == 1) {
    for (int k = 0; k < 9; k++) {
      const uint32_t bits = number_at(record + NORMAL + 4 * k);
      float value;
      memcpy(&value, &bits, sizeof value);
      if (!std::isfinite(value))
        throw Error(text("STL file '%s', triangle %zu: a coordinate is %g; it must be finite",
                         path_.c_str(), triangles_ + 1, static_cast<double>(value)));
      triangle_.node[k / 3][k % 3] = static_cast<double>(value);
    }
    give();
  }
}

void Stl::vertex() {
  if (words_.size() != 4)
    fail("it must be 'vertex X Y Z'");
  if (corners_ == 3)
    fail("a facet must have three vertices, and this is its fourth");
  for (int d = 0; d < 3; d++) {
    char *end;
    const double value = aspi_number(words_[d + 1].begin, &end);
    if (end != words_[d + 1].end || !std::isfinite(value))
      fail("the coordinates of a vertex must be finite numbers");
    triangle_.node[corners_][d] = value;
  }
  corners_++;
}

/* A line may follow some others only. */
void Stl::take_line() {
  const Word &first = words_[0];
  if (state_ == OUTSIDE && first.is("solid"))
    state_ = SOLID;
  else if (state_ == OUTSIDE)
    fail("it must be 'solid NAME', with which a text begins");
  else if (state_ == SOLID && first.is("endsolid"))
    state_ = OUTSIDE;
  else if (state_ == SOLID && first.is("facet"))
    state_ = FACET;
  else if (state_ == SOLID)
    fail("it must be 'facet normal X Y Z' or 'endsolid'");
  else if (state_ == FACET && words_.size() > 1 && first.is("outer") && words_[1].is("loop")) {
    state_ = LOOP;
    corners_ = 0;
  } else if (state_ == FACET)
    fail("it must be 'outer loop'");
  else if (state_ == LOOP && first.is("vertex"))
    vertex();
  else if (state_ == LOOP && first.is("endloop") && corners_ == 3) {
    state_ = LOOP_DONE;
    give();
  } else if (state_ == LOOP)
    fail(text("it must be the facet's vertex %d of 3, 'vertex X Y Z'", corners_ + 1));
  else if (first.is("endfacet"))
    state_ = SOLID;
  else
    fail("it must be 'endfacet'");
}

void Stl::split_line() {
  words_.clear();
  for (const char *at = line_.c_str(), *from;; words_.push_back({from, at})) {
    at += strspn(at, " \t\r\v\f");
    if (!*at)
      return;
    from = at;
    at += strcspn(at, " \t\r\v\f");
  }
}

/* The next line, without its end. */
bool Stl::read_line() {
  char piece[256];
  line_.clear();
  while (fgets(piece, sizeof piece, file_.get())) {
    line_ += piece;
    if (!line_.empty() && line_.back() == '\n') {
      line_.erase(line_.find_last_not_of("\r\n") + 1);
      return true;
    }
  }
  return !line_.empty();
}

void Stl::read_text() {
  while (read_line()) {
    number_++;
    split_line();
    if (!words_.empty())
      take_line();
  }
  if (state_ != OUTSIDE)
    throw Error(text("STL file '%s' ends at line %d within a %s; it must end with 'endsolid'",
                     path_.c_str(), number_, state_ == SOLID ? "solid" : "facet"));
}

void Stl::read() {
  const auto fail_to_read = [this] {
    throw Error("STL file '" + path_ + "' cannot be read: " + strerror(errno));
  };
  if (!file_ || fseek(file_.get(), 0, SEEK_END) != 0)
    fail_to_read();
  const double length = static_cast<double>(ftell(file_.get()));
  rewind(file_.get());
  unsigned char head[HEAD];
  const bool has_head = fread(head, HEAD, 1, file_.get()) == 1;
  const size_t count = has_head ? number_at(head + HEAD - 4) : 0;
  const double bytes = static_cast<double>(HEAD) + RECORD * static_cast<double>(count);
  if (has_head && !(bytes > length) && !(bytes < length))
    read_binary(count);
  else if (has_head && !begins(reinterpret_cast<char *>(head), "solid"))
    throw Error(text("STL file '%s' is no text that begins with 'solid', and has %.0f bytes; a "
                     "binary one of %zu triangles, as it says, must have %.0f",
                     path_.c_str(), length, count, bytes));
  else {
    rewind(file_.get());
    read_text();
  }
  if (ferror(file_.get()))
    fail_to_read();
  if (triangles_ == 0)
    throw Error("STL file '" + path_ + "' has no triangles; it must have one or more");
}

} // namespace

void asperity::read_stl(const std::string &path,
                        const std::function<void(const ContactTriangle &)> &take) {
  Stl(path, take).read();
}
