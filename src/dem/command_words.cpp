/* The words of a command; see command_words.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/command_words.h"

#include <math.h>

#include "base/number.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

bool Words::is_one_of(const std::string &list) const {
  return !done() && (" " + list + " ").find(" " + words_[next_] + " ") != std::string::npos;
}

std::vector<const char *> Words::rest() const {
  std::vector<const char *> all;
  for (size_t i = next_; i < words_.size(); i++)
    all.push_back(words_[i].c_str());
  return all;
}

bool Words::take(const char *word) {
  if (!is(word))
    return false;
  next_++;
  return true;
}

std::string Words::word(const char *what) {
  if (done())
    throw Error(text("%s is missing at the end of the command", what));
  return words_[next_++];
}

double Words::number(const char *what) {
  const std::string value = word(what);
  char *end;
  const double number = aspi_number(value.c_str(), &end);
  if (value.empty() || *end)
    throw Error(text("%s is '%s'; it must be a number", what, value.c_str()));
  return number;
}

double Words::whole(const char *what, double least, double most) {
  const double value = number(what);
  if (!(value >= least && value <= most) || value < floor(value) || value > floor(value))
    throw Error(
        text("%s is %.15g; it must be a whole number from %.0f to %.0f", what, value, least, most));
  return value;
}
