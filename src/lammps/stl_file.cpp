/* An STL file; see stl.h. The format is that of 3D Systems' StereoLithography Interface
 * Specification (1988): text in words, or 80 bytes of any text, the number of triangles, and 50
 * bytes for each. Either may begin with the word `solid`; a file is binary whose length is what its
 * number of triangles says.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "stl_file.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <memory>
#include <sstream>

#include "base/number.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

namespace {

const size_t HEAD = 84, RECORD = 50, NORMAL = 12;

/* A word of the format, in small letters or large. */
bool is(const std::string &word, const char *name) {
  return strcasecmp(word.c_str(), name) == 0;
}

std::string read_all(const std::string &path) {
  std::unique_ptr<FILE, int (*)(FILE *)> file(fopen(path.c_str(), "rb"), fclose);
  struct stat is;
  if (!file || fstat(fileno(file.get()), &is) != 0)
    throw Error("STL file '" + path + "' cannot be read: " + strerror(errno));
  if (S_ISDIR(is.st_mode))
    throw Error("STL file '" + path + "' is a folder; it must be a file");
  std::string bytes;
  char block[1 << 16];
  for (size_t n; (n = fread(block, 1, sizeof block, file.get())) > 0;)
    bytes.append(block, n);
  if (ferror(file.get()))
    throw Error("STL file '" + path + "' cannot be read: " + strerror(errno));
  return bytes;
}

/* Little-endian, whatever the machine is. */
uint32_t number_at(const char *at) {
  uint32_t value = 0;
  for (int k = 3; k >= 0; k--)
    value = value << 8 | static_cast<unsigned char>(at[k]);
  return value;
}

bool is_binary(const std::string &bytes) {
  return bytes.size() >= HEAD &&
         (bytes.size() - HEAD) / RECORD == number_at(bytes.data() + HEAD - 4) &&
         (bytes.size() - HEAD) % RECORD == 0;
}

std::vector<ContactTriangle> read_binary(const std::string &path, const std::string &bytes) {
  std::vector<ContactTriangle> triangles((bytes.size() - HEAD) / RECORD);
  for (size_t i = 0; i < triangles.size(); i++)
    for (int k = 0; k < 9; k++) {
      const uint32_t bits = number_at(&bytes[HEAD + i * RECORD + NORMAL + 4 * k]);
      float value;
      memcpy(&value, &bits, sizeof value);
      if (!std::isfinite(value))
        throw Error(text("STL file '%s', triangle %zu: a coordinate is %g; it must be finite",
                         path.c_str(), i + 1, static_cast<double>(value)));
      triangles[i].node[k / 3][k % 3] = static_cast<double>(value);
    }
  return triangles;
}

/* A text, line by line: a line may follow those in `may_follow` only. */
class Reader {
public:
  explicit Reader(const std::string &path)
      : path_(path), number_(0), triangle_(), corners_(0), state_(OUTSIDE) {}
  std::vector<ContactTriangle> read(const std::string &bytes);

private:
  enum State { OUTSIDE, SOLID, FACET, LOOP, LOOP_DONE };

  [[noreturn]] void fail(const std::string &must) const;
  void take_line();
  void vertex();

  const std::string &path_;
  int number_; /* of the line */
  std::string line_;
  std::vector<std::string> words_;
  ContactTriangle triangle_;
  int corners_;
  State state_;
  std::vector<ContactTriangle> triangles_;
};

void Reader::fail(const std::string &must) const {
  throw Error(
      text("STL file '%s', line %d: it says '%.80s'; ", path_.c_str(), number_, line_.c_str()) +
      must);
}

void Reader::vertex() {
  if (words_.size() != 4)
    fail("it must be 'vertex X Y Z'");
  if (corners_ == 3)
    fail("a facet must have three vertices, and this is its fourth");
  for (int d = 0; d < 3; d++) {
    char *end;
    const double value = aspi_number(words_[d + 1].c_str(), &end);
    if (*end || !std::isfinite(value))
      fail("the coordinates of a vertex must be finite numbers");
    triangle_.node[corners_][d] = value;
  }
  corners_++;
}

void Reader::take_line() {
  const std::string &first = words_[0], second = words_.size() > 1 ? words_[1] : "";
  if (state_ == OUTSIDE && is(first, "solid"))
    state_ = SOLID;
  else if (state_ == OUTSIDE)
    fail("it must be 'solid NAME', with which a text begins");
  else if (state_ == SOLID && is(first, "endsolid"))
    state_ = OUTSIDE;
  else if (state_ == SOLID && is(first, "facet"))
    state_ = FACET;
  else if (state_ == SOLID)
    fail("it must be 'facet normal X Y Z' or 'endsolid'");
  else if (state_ == FACET && is(first, "outer") && is(second, "loop")) {
    state_ = LOOP;
    corners_ = 0;
  } else if (state_ == FACET)
    fail("it must be 'outer loop'");
  else if (state_ == LOOP && is(first, "vertex"))
    vertex();
  else if (state_ == LOOP && is(first, "endloop") && corners_ == 3) {
    state_ = LOOP_DONE;
    triangles_.push_back(triangle_);
  } else if (state_ == LOOP)
    fail(text("it must be the facet's vertex %d of 3, 'vertex X Y Z'", corners_ + 1));
  else if (is(first, "endfacet"))
    state_ = SOLID;
  else
    fail("it must be 'endfacet'");
}

std::vector<ContactTriangle> Reader::read(const std::string &bytes) {
  std::istringstream lines(bytes);
  while (std::getline(lines, line_)) {
    number_++;
    if (!line_.empty() && line_.back() == '\r')
      line_.pop_back();
    std::istringstream line(line_);
    words_.clear();
    for (std::string word; line >> word;)
      words_.push_back(word);
    if (!words_.empty())
      take_line();
  }
  line_ = "";
  number_++;
  if (state_ != OUTSIDE)
    throw Error(text("STL file '%s' ends at line %d within a %s; it must end with 'endsolid'",
                     path_.c_str(), number_ - 1, state_ == SOLID ? "solid" : "facet"));
  return triangles_;
}

} // namespace

std::vector<ContactTriangle> asperity::read_stl(const std::string &path) {
  const std::string bytes = read_all(path);
  const bool is_text = strncasecmp(bytes.c_str(), "solid", 5) == 0;
  if (!is_binary(bytes) && !is_text && bytes.size() >= HEAD)
    throw Error(text("STL file '%s' is no text that begins with 'solid', and has %zu bytes; a "
                     "binary one of %u triangles, as it says, must have %.0f",
                     path.c_str(), bytes.size(), number_at(bytes.data() + HEAD - 4),
                     HEAD + RECORD * static_cast<double>(number_at(bytes.data() + HEAD - 4))));
  const std::vector<ContactTriangle> triangles =
      is_binary(bytes) ? read_binary(path, bytes) : Reader(path).read(bytes);
  if (triangles.empty())
    throw Error("STL file '" + path + "' has no triangles; it must have one or more");
  if (triangles.size() > INT_MAX / 2)
    throw Error(text("STL file '%s' has %zu triangles; there must be no more than %d", path.c_str(),
                     triangles.size(), INT_MAX / 2));
  return triangles;
}
