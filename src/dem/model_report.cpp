/* Texts of a wall for the user: its description, the report for the log, and doubts about
 * constants; see model.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/model.h"

#include <math.h>

#include "dem/text.h"

using namespace asperity;

namespace {

const double DEGREES = 180 / ASP_PI;

/* "below 0.3 along the normal" */
std::string below(double speed) {
  return speed > 0 ? isinf(speed) ? "at any speed" : text("below %.3g along the normal", speed)
                   : "never";
}

} // namespace

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

/* The speed above which a particle yields, v_y = sigma_y/sqrt(rho E_c) (Bons et al. 2017). */
void Model::report_yield() {
  if (is_given("yield_stress"))
    materials_report_ += text("\n  yield_stress %g, by the description", number("yield_stress"));
  const double softening = asp_description_softening(description_.get());
  if (is_given("temperature"))
    materials_report_ += text(
        "\n  at the particles' temperature of %g K the yield stress is %.4g of that when cold; "
        "the surface energy is the cold one%s",
        temperature_, softening, is_given("soften_modulus") ? "" : ", and the modulus, too");
  const double rate = number("yield_rate");
  if (!(rate >= 0) || rate > 0) /* a law of its own, or no constant */
    return;
  for (size_t t = 0; t < kinds_.size(); t++)
    for (int w : wall_types_) {
      const int type = static_cast<int>(t) + 1;
      const asp_pair *p = pair(type, w);
      if (kinds_[t].present && kinds_[t].most > 0)
        materials_report_ +=
            text("\n  type %d on a wall of type %d: yields above %.4g along the normal", type, w,
                 softening * asp_pair_get(p, "yield_stress") /
                     sqrt(kinds_[t].most * asp_pair_get(p, "modulus")));
    }
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
  asp_check_input input = {description_.get(), wall_.get(), least_, &largest, {NULL, NULL}};
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

/* The normal speeds below which the smallest and the largest particles stick; of the laws with
 * adhesion, whose speeds are far apart, that of the other one, too. */
std::string Model::describe_capture() const {
  std::string lines;
  const bool is_bons = word("rebound") == "bons";
  const std::string other_law = is_bons ? "thornton_ning" : "bons";
  const std::unique_ptr<asp_description, void (*)(asp_description *)> other(
      asp_description_parse(("rebound " + other_law).c_str(), &units_, NULL), asp_description_free);
  const double d_p[2] = {least_, most_};
  for (size_t t = 0; t < kinds_.size() && !pairs_.empty(); t++)
    for (int w : wall_types_) {
      const int type = static_cast<int>(t) + 1;
      double speed[2] = {0, 0}, by_other = 0;
      for (int k = 0; kinds_[t].present && k < 2; k++) {
        asp_particle particle = asp_particle();
        particle.d_p = d_p[k];
        particle.density = density(type, kinds_[t]);
        particle.pair = pair(type, w);
        speed[k] = asp_description_capture_speed(description_.get(), &particle);
        if (other && (is_bons || word("rebound") == "thornton_ning"))
          by_other = asp_description_capture_speed(other.get(), &particle);
      }
      if (!(speed[0] > 0))
        continue;
      lines += text("\n  type %d on a wall of type %d: d_p %.4g sticks ", type, w, d_p[0]) +
               below(speed[0]);
      if (d_p[1] > d_p[0])
        lines += text(", d_p %.4g ", d_p[1]) + below(speed[1]);
      if (by_other > 0)
        lines += " (by " + other_law + " " + below(by_other) + ")";
    }
  return lines;
}

std::string Model::describe_surface() const {
  const asp_wall *wall = wall_.get();
  const asp_surface *s = asp_wall_surface(wall);
  const std::string model = asp_spread_name(asp_wall_spread(wall));
  if (!s || model == "none")
    return "smooth wall";
  std::string line;
  if (measured())
    line = word("surface") + " " + word("file") + " (" + report_ + "), ";
  asp_heights_numbers numbers;
  if (word("surface") == "map" && !asp_heights_describe(heights_.get(), &numbers, NULL))
    line += text("S_sk %.3g, S_ku %.3g, ", numbers.s_sk, numbers.s_ku);
  const double sigma = atan(asp_surface_slope_rms(s)) * DEGREES;
  if (word("surface") == "sigma")
    line += text("sigma %.4g deg for all sizes", sigma);
  else
    line += text("R_q %.4g, lambda_c %.4g, Phi_R %.4g, sigma %.4g deg before the size filter",
                 asp_surface_r_q(s), asp_surface_lambda_c(s), asp_surface_phi_r(s), sigma);
  if (lay_.kind != ASP_LAY_NONE)
    line += text(", lambda_c along the lay %.4g", asp_surface_lambda_along(s));
  line += ", spread " + model + " " + word("tilt") + ", collisions " + word("collisions");
  if (asp_surface_uncertainty(s) > 0)
    line += text("\n  one profile of this length leaves the mean tilt at 2 deg uncertain by about "
                 "%.2g %% of "
                 "sigma",
                 100 * asp_surface_uncertainty(s));
  if (!measured() && !is_given("spread"))
    line +=
        "\n  spread is the default; the choice of Altmeppen et al. 2020 is 'spread weibull plane "
        "collisions single'";
  const double d_p[2] = {least_, most_};
  for (int k = 0; k < 2 && asp_surface_bins(s) == 0 && d_p[k] > (k > 0 ? d_p[0] : 0); k++)
    line += text("\n  d_p %.4g: tilt of sigma %.4g deg", d_p[k],
                 atan(asp_wall_slope(wall, d_p[k])) * DEGREES);
  for (int i = 0; i < asp_surface_bins(s); i++)
    line += text("\n  bin %d: d_p %.4g, sigma %.4g deg", i + 1, asp_surface_bin_d_p(s, i),
                 atan(asp_wall_slope(wall, asp_surface_bin_d_p(s, i))) * DEGREES);
  return line;
}

std::string Model::take_report() {
  if (!is_new_ || !wall_)
    return "";
  is_new_ = false;
  return description() + "\n  " + describe_surface() + materials_report_ + describe_capture();
}
