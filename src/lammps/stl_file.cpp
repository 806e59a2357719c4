/* An STL file, read as a stream; see driven_mesh.h. The format is that of 3D Systems'
 * StereoLithography Interface Specification (1988): text in words, or 80 bytes of any text, the
 * number of triangles, and 50 bytes for each. Either may begin with the word `solid`; a file is
 * binary if its length fits its number of triangles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "driven_mesh.h"

#include <cctype>
#include <cerrno>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

#include "base/number.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

namespace {

const size_t HEAD = 84, RECORD = 50, NORMAL = 12, MOST = INT_MAX / 2;
const char BLANKS[] = " \t\r\v\f";

class Stl {
public:
  Stl(const std::string &path, const std::function<void(const ContactTriangle &)> &take)
      : path_(path), take_(take), file_(path.c_str(), std::ios::binary), number_(0), triangle_(),
        triangles_(0) {}
  void read();

private:
  [[noreturn]] void fail(const std::string &must) const;
  void give();
  void read_binary(size_t count);
  void read_text();
  bool read_line();
  bool is(const char *words) const;
  void next(const char *part);
  void read_vertex(double node[3]);

  const std::string &path_;
  const std::function<void(const ContactTriangle &)> &take_;
  std::ifstream file_;
  std::string line_; /* of a text */
  int number_;       /* of the line */
  ContactTriangle triangle_;
  size_t triangles_;
};

void Stl::fail(const std::string &must) const {
  throw Error(text("STL file '%s', line %d: it says '%.80s'; it must be ", path_.c_str(), number_,
                   line_.c_str()) +
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
  while (triangles_ < count && file_.read(reinterpret_cast<char *>(record), RECORD)) {
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

/* The next line that is not blank, with one blank between words and none at its ends; false at the
 * end of the file. */
bool Stl::read_line() {
  std::string read;
  while (std::getline(file_, read)) {
    number_++;
    line_.clear();
    for (size_t at = 0, end; (at = read.find_first_not_of(BLANKS, at)) != std::string::npos;
         at = end) {
      end = std::min(read.find_first_of(BLANKS, at), read.size());
      line_ += (line_.empty() ? "" : " ") + read.substr(at, end - at);
    }
    if (!line_.empty())
      return true;
  }
  return false;
}

/* True if the line begins with these words, in small letters or large. */
bool Stl::is(const char *words) const {
  const size_t length = strlen(words);
  bool equal = line_.size() == length || (line_.size() > length && line_[length] == ' ');
  for (size_t k = 0; k < length && equal; k++)
    equal = tolower(static_cast<unsigned char>(line_[k])) == words[k];
  return equal;
}

/* The next line of a part of the text. */
void Stl::next(const char *part) {
  if (!read_line())
    throw Error(text("STL file '%s' ends at line %d within a %s; it must end with 'endsolid'",
                     path_.c_str(), number_, part));
}

void Stl::read_vertex(double node[3]) {
  const char *at = line_.c_str() + strlen("vertex");
  bool good = true;
  for (int d = 0; d < 3 && good; d++) {
    char *end;
    good = *at == ' ';
    if (!good)
      continue;
    node[d] = aspi_number(at + 1, &end);
    good = end > at + 1 && (!*end || *end == ' ') && std::isfinite(node[d]);
    at = end;
  }
  if (!good || *at)
    fail("'vertex X Y Z' of finite numbers");
}

void Stl::read_text() {
  static const char *const LINES[] = {"outer loop", "vertex",  "vertex",
                                      "vertex",     "endloop", "endfacet"};
  while (read_line()) {
    if (!is("solid"))
      fail("'solid NAME', with which a text begins");
    for (next("solid"); !is("endsolid"); next("solid")) {
      if (!is("facet"))
        fail("'facet normal X Y Z' or 'endsolid'");
      for (int k = 0; k < 6; k++) {
        next("facet");
        if (!is(LINES[k]))
          fail(k >= 1 && k <= 3 ? text("the facet's vertex %d of 3, 'vertex X Y Z'", k)
                                : "'" + std::string(LINES[k]) + "'");
        if (k >= 1 && k <= 3)
          read_vertex(triangle_.node[k - 1]);
      }
      give();
    }
  }
}

void Stl::read() {
  const auto fail_to_read = [this] {
    throw Error("STL file '" + path_ + "' cannot be read: " + strerror(errno));
  };
  char head[HEAD] = "";
  if (!file_.seekg(0, std::ios::end))
    fail_to_read();
  const double length = static_cast<double>(file_.tellg());
  file_.seekg(0);
  file_.read(head, HEAD);
  const bool has_head = file_.gcount() == HEAD;
  const size_t count = has_head ? number_at(reinterpret_cast<unsigned char *>(head) + HEAD - 4) : 0;
  const double bytes = static_cast<double>(HEAD) + RECORD * static_cast<double>(count);
  line_.assign(head, strlen("solid"));
  if (has_head && !(bytes > length) && !(bytes < length))
    read_binary(count);
  else if (has_head && !is("solid"))
    throw Error(text("STL file '%s' is no text that begins with 'solid', and has %.0f bytes; a "
                     "binary one of %zu triangles, as it says, must have %.0f",
                     path_.c_str(), length, count, bytes));
  else {
    file_.clear();
    file_.seekg(0);
    read_text();
  }
  if (file_.bad())
    fail_to_read();
  if (triangles_ == 0)
    throw Error("STL file '" + path_ + "' has no triangles; it must have one or more");
}

} // namespace

void asperity::read_stl(const std::string &path,
                        const std::function<void(const ContactTriangle &)> &take) {
  Stl(path, take).read();
}
