/* Texts, with numbers in the unit styles of the engines, and the words of a command.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <string>
#include <vector>

#include "asperity_engine.h"

namespace asperity {

#if defined(__GNUC__)
#define ASPERITY_FORMAT __attribute__((format(printf, 1, 2)))
#else
#define ASPERITY_FORMAT
#endif

/* printf into a string, in the "C" locale. */
std::string text(const char *format, ...) ASPERITY_FORMAT;

/* A number in a setting: equal texts for equal numbers. */
std::string setting(double value);

/* The canonical text of a description. */
std::string description_text(const asp_description *description);

/* A style of the engine without the suffix of LAMMPS's package KOKKOS. */
inline std::string without_suffix(const std::string &style) {
  return style.substr(0, style.find("/kk"));
}

/* The unit style of that name; one that cannot be converted to others has no name and all 0. */
asp_units units_of(const std::string &name);

/* A time in the units of a style, with its unit. */
std::string quantity_of_time(double value, const std::string &style);

/* The words of a command, one after the other. All functions throw an Error that names what is
 * missing or wrong; `what` names the value in it. */
class Words {
public:
  Words(int count, const char *const *words) : words_(words, words + count), next_(0) {}

  bool done() const {
    return next_ >= words_.size();
  }
  size_t left() const {
    return words_.size() - next_;
  }
  bool is(const char *word) const {
    return !done() && words_[next_] == word;
  }
  /* True if the next word is in a list of words separated by blanks. */
  bool is_one_of(const std::string &list) const;
  /* Goes past the next word if it is this one. */
  bool take(const char *word);
  std::string word(const char *what);
  double number(const char *what);
  double whole(const char *what, double least, double most);
  /* The words that are left, valid as long as this. */
  std::vector<const char *> left_over() const;
  /* Goes past some of them. */
  void advance(int count) {
    next_ += static_cast<size_t>(count);
  }

private:
  std::vector<std::string> words_;
  size_t next_;
};

} // namespace asperity
