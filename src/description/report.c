/* The lines of a log about a wall, and about the particles that hit it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/units.h"
#include "description/description.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* A text that may be longer than its room. */
typedef struct report {
  char *text;
  size_t size, length;
} report;

static void add(report *r, const char *format, ...) {
  va_list values;
  va_start(values, format);
  size_t left = r->length < r->size ? r->size - r->length : 0;
  int written = vsnprintf(left ? r->text + r->length : NULL, left, format, values);
  r->length += written > 0 ? (size_t)written : 0;
  va_end(values);
}

static double sigma_of(double slope) {
  return aspi_degrees(atan(slope));
}

static void add_sizes(report *r, const asp_check_input *input, const asp_surface *surface) {
  const double d_p[] = {input->d_least, input->largest ? input->largest->d_p : 0};
  for (int k = 0; k < 2 && asp_surface_bins(surface) == 0 && d_p[k] > (k > 0 ? d_p[0] : 0); k++)
    add(r, "\n  d_p %.4g: tilt of sigma %.4g deg", d_p[k],
        sigma_of(asp_wall_slope(input->wall, d_p[k])));
  for (int i = 0; i < asp_surface_bins(surface); i++) {
    double d = asp_surface_bin_d_p(surface, i);
    add(r, "\n  bin %d: d_p %.4g, sigma %.4g deg", i + 1, d,
        sigma_of(asp_wall_slope(input->wall, d)));
  }
}

static void add_surface(report *r, const asp_check_input *input) {
  const asp_description *d = input->words;
  const asp_surface *s = asp_wall_surface(input->wall);
  if (!input->wall->rough) {
    add(r, "\n  smooth wall");
    return;
  }
  double sigma = sigma_of(asp_surface_slope_rms(s));
  if (d->kind == ASPI_SIGMA)
    add(r, "\n  sigma %.4g deg for all sizes", sigma);
  else
    add(r, "\n  R_q %.4g, lambda_c %.4g, Phi_R %.4g, sigma %.4g deg before the size filter",
        asp_surface_r_q(s), asp_surface_lambda_c(s), asp_surface_phi_r(s), sigma);
  if (d->lay != ASP_LAY_NONE)
    add(r, ", lambda_c along the lay %.4g", asp_surface_lambda_along(s));
  add(r, ", spread %s %s, collisions %s", asp_description_word(d, "spread"),
      asp_description_word(d, "tilt"), asp_description_word(d, "collisions"));
  if (asp_surface_uncertainty(s) > 0)
    add(r,
        "\n  the length of the profile, or of all, leaves the mean tilt at 2 deg uncertain by "
        "about %.2g %% of sigma",
        100 * asp_surface_uncertainty(s));
  if (!d->file && !d->spread)
    add(r,
        "\n  spread is the default; the choice of Altmeppen et al. 2020 is 'spread weibull plane "
        "collisions single'");
  add_sizes(r, input, s);
}

static void add_speed(report *r, double speed) {
  if (isinf(speed))
    add(r, "at any speed");
  else if (speed > 0)
    add(r, "below %.3g along the normal", speed);
  else
    add(r, "never");
}

/* The two laws with adhesion have capture speeds that are far apart: that by the other one. */
static void add_other_law(report *r, const asp_description *d, const asp_particle *particle) {
  const bool is_bons = strcmp(d->choice.law->name, "bons") == 0;
  const char *other = is_bons ? "thornton_ning" : "bons";
  if (!is_bons && strcmp(d->choice.law->name, "thornton_ning") != 0)
    return;
  asp_description *by =
      asp_description_parse(is_bons ? "rebound thornton_ning" : "rebound bons", &d->units, NULL);
  double speed = by ? asp_description_capture_speed(by, particle) : 0;
  if (speed > 0) {
    add(r, " (by %s ", other);
    add_speed(r, speed);
    add(r, ")");
  }
  asp_description_free(by);
}

/* A particle yields above v_y = sigma_y/sqrt(rho E_c) (Bons et al. 2017), but for a law with a
 * yield stress of its own. */
static void add_speeds(report *r, const asp_check_input *input) {
  const asp_description *d = input->words;
  asp_particle particle = *input->largest;
  const asp_pair *pair = particle.pair;
  double rate = asp_description_get(d, "yield_rate"); /* NAN: the law has none */
  if (rate >= 0 && rate <= 0)
    add(r, " yields above %.4g along the normal",
        asp_description_softening(d) * pair->yield_stress / sqrt(particle.density * pair->modulus));
  const double d_p[] = {input->d_least, particle.d_p};
  for (int k = 0; k < 2; k++) {
    particle.d_p = d_p[k];
    double speed = asp_description_capture_speed(d, &particle);
    if (k == 0 && !(speed > 0))
      return;
    if (k == 0 || d_p[1] > d_p[0]) {
      add(r, "%s d_p %.4g %s", r->length ? "," : "", d_p[k], k == 0 ? "sticks " : "");
      add_speed(r, speed);
    }
  }
  add_other_law(r, d, &particle);
}

size_t asp_wall_report(const asp_check_input *input, char *text, size_t size) {
  report r = {text, size, 0};
  if (input->largest && input->largest->pair)
    add_speeds(&r, input);
  else
    add_surface(&r, input);
  if (!(input->largest && input->largest->pair) && input->words->choice.law->softening &&
      aspi_is_given(input->words, "temperature"))
    add(&r,
        "\n  at the particles' temperature of %g K the yield stress is %.4g of that when cold; "
        "the surface energy is the cold one%s",
        asp_description_get(input->words, "temperature"), asp_description_softening(input->words),
        aspi_is_given(input->words, "soften_modulus") ? "" : ", and the modulus, too");
  return r.length;
}
