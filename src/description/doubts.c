/* Warnings of a wall that is allowed and looks like a mistake.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "description/description.h"
#include "readers/read.h"
#include "rebound/laws.h"
#include "surface/instrument.h"

#include <math.h>
#include <string.h>

/* A yield stress that is a larger share of the modulus is beyond all solids: then the modulus is
 * probably one that was made soft for a longer step. */
#define YIELD_MOST 0.1

/* A particle's density may be this share off that of its material. */
#define DENSITY_OFF 0.01

/* Pa: a hardness under this is one in GPa (lead has it), and a flow stress one in GPa or MPa. */
#define HARDNESS_LEAST 5e7
#define FLOW_STRESS_LEAST 1e6

/* Heights over this many diameters, or in meters where no diameter is known, are probably in
 * another unit. */
#define DIAMETERS_MOST 1e3
#define HEIGHT_MOST 0.01

/* Each writes its doubt, if there is one; else the text stays empty. */
typedef void ask(const asp_check_input *input, char *text, size_t size);

/* A number of the caller's with its SI unit; as it is where the caller's units are unknown. */
typedef struct si {
  char text[40];
} si;

static si in_si(const asp_check_input *input, double value, const char *kind) {
  si made = {""};
  char units[120];
  double factor = aspi_quantity_factor(kind, &input->words->units);
  aspi_quantity_units(kind, units, sizeof units);
  units[strcspn(units, " ")] = '\0';
  aspi_append(made.text, sizeof made.text, "%.4g%s%.20s", value / (factor > 0 ? factor : 1),
              factor > 0 ? " " : "", factor > 0 ? units : "");
  return made;
}

static void yields_never(const asp_check_input *input, char *text, size_t size) {
  const asp_pair *pair = input->largest->pair;
  if (pair && !(asp_description_get(input->words, "yield_rate") > 0) &&
      pair->yield_stress > YIELD_MOST * pair->modulus)
    aspi_append(
        text, size,
        "the yield stress, %s, is %.3g times the composite modulus, %s, so that nothing "
        "yields; is the modulus one that was made soft for the pair style? 'materials' takes "
        "real ones",
        in_si(input, pair->yield_stress, "stress").text, pair->yield_stress / pair->modulus,
        in_si(input, pair->modulus, "stress").text);
}

static void has_other_density(const asp_check_input *input, char *text, size_t size) {
  const asp_material *m = input->material[0];
  double off = m ? fabs(input->largest->density / m->density - 1) : 0;
  if (input->largest->density > 0 && m && m->density > 0 && off > DENSITY_OFF)
    aspi_append(
        text, size,
        "the density of particles is up to %.3g %% off that of material '%s', %s; theirs is "
        "taken",
        100 * off, m->name, in_si(input, m->density, "density").text);
}

static void sticks_always(const asp_check_input *input, char *text, size_t size) {
  if (isinf(asp_description_capture_speed(input->words, input->largest)))
    aspi_append(
        text, size,
        "particles up to %s always stick: surface energy %s is too high for the yield stress %s",
        in_si(input, input->largest->d_p, "length").text,
        in_si(input, input->largest->pair->surface_energy, "energy/area").text,
        in_si(input, input->largest->pair->yield_stress * asp_description_softening(input->words),
              "stress")
            .text);
}

/* Without adhesion these laws do not depend on the size. */
static void has_other_sizes(const asp_check_input *input, char *text, size_t size) {
  const asp_rebound_law *law = input->words->choice.law;
  const double meter = input->words->units.meter, d_most = input->largest->d_p / meter;
  const double d_least = input->d_least > 0 ? input->d_least / meter : d_most;
  const bool are_large = d_most > (1 + ASPI_ROUNDING_TEXT) * law->d_most;
  if (!input->largest->pair || !(d_most > 0) || input->words->deposit == ASPI_DEPOSIT_OFF ||
      !(input->largest->pair->surface_energy > 0) ||
      (!are_large && d_least >= (1 - ASPI_ROUNDING_TEXT) * law->d_least))
    return;
  aspi_append(text, size, "the adhesion of '%s' is for particles of %g to %g um; ", law->name,
              1e6 * law->d_least, 1e6 * law->d_most);
  if (are_large)
    aspi_append(text, size,
                "it freezes larger grains to the wall: say 'rebound walton E MU 0 deposit off'");
  else
    aspi_append(text, size, "for smaller ones say 'rebound thornton_ning'");
}

static void is_high(const asp_check_input *input, char *text, size_t size) {
  double r_q = input->words->r_q, d_p = input->largest->d_p, meter = input->words->units.meter;
  if (d_p > 0 && r_q > DIAMETERS_MOST * d_p)
    aspi_append(text, size,
                "rq is %s, %.3g times the diameter of the largest particle, %s; is it in another "
                "unit?",
                in_si(input, r_q, "length").text, r_q / d_p, in_si(input, d_p, "length").text);
  else if (!(d_p > 0) && meter > 0 && r_q > HEIGHT_MOST * meter)
    aspi_append(text, size, "rq is %g, which is %g m; is it in another unit?", r_q, r_q / meter);
}

static void is_soft(const asp_check_input *input, char *text, size_t size) {
  const aspi_erosion *erosion = &input->words->choice.erosion;
  const aspi_keyword *p = erosion->law ? &erosion->law->parameters[0] : NULL;
  bool hardness = p && strcmp(p->name, "hardness") == 0;
  if (p && strcmp(p->unit, "stress") == 0 &&
      erosion->si[0] < (hardness ? HARDNESS_LEAST : FLOW_STRESS_LEAST))
    aspi_append(text, size, "%s is %g, which is %g Pa; is it one in GPa%s?", p->name,
                erosion->given[0], erosion->si[0], hardness ? "" : " or MPa");
}

static void has_no_sampling(const asp_check_input *input, char *text, size_t size) {
  double length = input->words->spacing;
  if (aspi_is_given(input->words, "rsm") && !aspi_is_given(input->words, "sampling"))
    aspi_append(text, size,
                "rsm depends on the sampling length: lambda_c is taken as %s and may be %s to "
                "%s; say 'sampling LR', or rather rdq",
                in_si(input, input->words->lambda_c, "length").text,
                in_si(input, length / aspi_r_sm_factor(ASPI_RSM_MOST), "length").text,
                in_si(input, length / aspi_r_sm_factor(ASPI_RSM_LEAST), "length").text);
}

static void holds_nothing(const asp_check_input *input, char *text, size_t size) {
  const aspi_flow *flow = &input->words->choice.flow;
  double d_p = input->largest->d_p;
  if (flow->density > 0 && d_p > 0 && !(aspi_flow_adhesion(flow, d_p) > 0))
    aspi_append(
        text, size,
        "'remove' takes away at once what particles of diameter %s leave on the wall: from 70 "
        "um on the median of adhesion by the size is 0; state 'adhesion'",
        in_si(input, d_p, "length").text);
}

/* More than half of what sticks, of the largest particles, with the median of their adhesion. */
static void blows_off(const asp_check_input *input, char *text, size_t size) {
  const aspi_flow *flow = &input->words->choice.flow;
  const double d_p = input->largest->d_p, share = aspi_flow_adhesion(flow, d_p);
  if (input->largest->pair && share > 0 &&
      asp_description_capture_speed(input->words, input->largest) > 0 &&
      aspi_flow_rate(flow, input->largest, share) * input->words->units.second > log(2))
    aspi_append(text, size,
                "within a second the flow of 'remove' takes away more than half of the particles "
                "of diameter %s that stick: they arrive with %s adhesion of a smooth contact, and "
                "are held by %.3g of it; 'adhesion F' is for both",
                in_si(input, d_p, "length").text,
                flow->adhesion > 0 ? "a share of the" : "all of the", share);
}

static void has_odd_heights(const asp_check_input *input, char *text, size_t size) {
  if (input->wall && input->wall->heights.doubt.code)
    aspi_append(text, size, "surface %s %s: %s", asp_description_word(input->words, "surface"),
                input->words->file, input->wall->heights.doubt.text);
}

static void is_coarse(const asp_check_input *input, char *text, size_t size) {
  const aspi_wall_heights *h = input->wall ? &input->wall->heights : NULL;
  asp_error doubt;
  if (h && h->spacing > 0 && input->d_least > 0 &&
      aspi_sampling_check(input->d_least, h->spacing, h->length, h->lambda, &doubt))
    aspi_append(text, size, "surface %s %s: %s", asp_description_word(input->words, "surface"),
                input->words->file, doubt.text);
}

static void is_rough_twice(const asp_check_input *input, char *text, size_t size) {
  const asp_rebound_law *law = input->words->choice.law;
  if (input->wall && law->measured && asp_wall_surface(input->wall))
    aspi_append(
        text, size,
        "the coefficients of '%s' were measured on a wall with a roughness of its own; on a "
        "rough wall that counts twice",
        law->name);
}

static void draws_from_gaussian(const asp_check_input *input, char *text, size_t size) {
  const asp_spread_model *spread = input->wall ? asp_wall_spread(input->wall) : NULL;
  if (spread && input->words->file && !spread->prepare && strcmp(spread->name, "none") != 0)
    aspi_append(text, size,
                "'spread %s' draws from a Gaussian wall with the slopes of '%s', whose own law is "
                "'spread traced'",
                spread->name, input->words->file);
}

bool asp_warning(const asp_check_input *input, int index, char *text, size_t size) {
  static ask *const doubts[] = {
      is_high,       is_soft,       has_no_sampling, has_odd_heights,     is_coarse,
      holds_nothing, blows_off,     is_rough_twice,  draws_from_gaussian, has_other_density,
      yields_never,  sticks_always, has_other_sizes};
  *text = '\0';
  if (index < 0 || (size_t)index >= sizeof doubts / sizeof *doubts)
    return false;
  doubts[index](input, text, size);
  return true;
}
