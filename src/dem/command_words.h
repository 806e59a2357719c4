/* The words of a command of a script, one after the other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_COMMAND_WORDS_H
#define ASPERITY_DEM_COMMAND_WORDS_H

#include <string>
#include <vector>

namespace asperity {

/* All functions throw an Error that names what is missing or wrong; `what` names the value in
 * it. */
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
  std::vector<const char *> rest() const;
  void skip(int count) {
    next_ += static_cast<size_t>(count);
  }

private:
  std::vector<std::string> words_;
  size_t next_;
};

/* Keywords that an engine's command has besides those of all engines. */
class OwnKeywords {
public:
  virtual ~OwnKeywords() {}
  virtual std::string keywords() const = 0; /* with blanks between */

  /* If the next word is one of them, reads it and what belongs to it. */
  virtual bool parse(Words &words) = 0;
};

} // namespace asperity

#endif
