/* Texts of a wall for the user: its description, the report for the log, and doubts about
 * constants; see model.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/model.h"

#include <math.h>

#include "dem/text.h"

using namespace asperity;

/* The report on the wall, or on particles that have a pair. */
std::string Model::report(const asp_particle &particles) const {
  asp_check_input input = asp_check_input();
  input.words = description_.get();
  input.wall = wall_.get();
  input.d_least = least_;
  input.largest = &particles;
  std::string lines(asp_wall_report(&input, NULL, 0) + 1, '\0');
  asp_wall_report(&input, &lines[0], lines.size());
  lines.pop_back();
  return lines;
}

/* Reports the source of a constant of the pairs. */
void Model::report_constant(const char *keyword, const char *name, bool of_script, double value) {
  materials_report_ += std::string("\n  ") + keyword;
  if (is_given(keyword))
    materials_report_ += text(" %g, by the description", value);
  else if (of_script)
    materials_report_ += std::string(" by the script's ") + name;
  else
    materials_report_ += text(" %g, the default", value);
}

/* Warns of each doubt once: about the words (type 0), or about a type of particles. */
void Model::ask(const asp_check_input &input, int type, int wall_type) {
  char doubt[480];
  for (int i = 0; asp_warning(&input, i, doubt, sizeof doubt); i++)
    if (*doubt && !said_.count({0, doubt}) && said_.insert({type, doubt}).second)
      engine_.warn(type > 0 ? text("type %d on a wall of type %d: %s", type, wall_type, doubt)
                            : doubt);
}

/* What looks like a mistake; anew where there are smaller particles than before, or much larger
 * ones. Collective. */
void Model::warn_of_doubts() {
  const bool have_others = most_ > 0 && (least_ < doubted_for_[0] || most_ > 2 * doubted_for_[1]);
  if (!wall_ || !(is_new_ || have_others))
    return;
  doubted_for_[0] = most_ > 0 ? least_ : doubted_for_[0];
  doubted_for_[1] = most_;
  asp_particle largest = asp_particle();
  largest.d_p = most_;
  asp_check_input input = asp_check_input();
  input.words = description_.get();
  input.wall = wall_.get();
  input.d_least = least_;
  input.largest = &largest;
  ask(input, 0, 0);
  for (size_t t = 0; t < kinds_.size() && !pairs_.empty(); t++)
    for (int w : wall_types_) {
      const int type = static_cast<int>(t) + 1;
      if (!kinds_[t].present)
        continue;
      largest.density = density(type, kinds_[t]);
      largest.pair = pair(type, w);
      input.material[0] = materials_[t];
      input.material[1] = materials_[w - 1];
      ask(input, type, w);
    }
}

/* The density of particles of a type: of the two, the one that is farther from that of the
 * material; that of the material where there are none yet. */
double Model::density(int type, const Engine::Kind &kind) const {
  const double own = asp_material_get(materials_[type - 1], "density");
  if (!(kind.most > 0))
    return own;
  return fabs(kind.least - own) > fabs(kind.most - own) ? kind.least : kind.most;
}

/* The speeds at which particles of each type yield and stick. */
std::string Model::describe_speeds() const {
  std::string lines;
  for (size_t t = 0; t < kinds_.size() && !pairs_.empty(); t++)
    for (int w : wall_types_) {
      if (!kinds_[t].present)
        continue;
      const int type = static_cast<int>(t) + 1;
      asp_particle particles = asp_particle();
      particles.d_p = most_;
      particles.density = density(type, kinds_[t]);
      particles.pair = pair(type, w);
      const std::string speeds = report(particles);
      if (!speeds.empty())
        lines += text("\n  type %d on a wall of type %d:", type, w) + speeds;
    }
  return lines;
}

/* The file of a measured wall, as it was read. */
std::string Model::describe_file() const {
  if (!measured())
    return "";
  std::string line = "\n  " + word("surface") + " " + word("file") + " (" + report_ + ")";
  asp_heights_numbers numbers;
  if (word("surface") == "map" && !asp_heights_describe(heights_.get(), &numbers, NULL))
    line += text(", S_sk %.3g, S_ku %.3g", numbers.s_sk, numbers.s_ku);
  return line;
}

std::string Model::take_report() {
  if (!is_new_ || !wall_)
    return "";
  is_new_ = false;
  asp_particle largest = asp_particle();
  largest.d_p = most_;
  return description() + describe_file() + report(largest) + materials_report_ + describe_speeds();
}
