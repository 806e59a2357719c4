/* The words of the clause `surface` that are more than a number or a file: the lay, and the numbers
 * of instruments.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/units.h"
#include "base/number.h"
#include "description/words.h"
#include "surface/instrument.h"

#include <math.h>

static asp_code read_angle(aspi_words *r, const aspi_keyword *k, const char *first) {
  double *angle = r->d->lay_numbers;
  asp_code code = aspi_quantity_read(k->name, first, k->unit, &r->d->units, angle, r->error);
  r->d->lay = ASP_LAY_ANGLE;
  return code ? code : aspi_check_range(r->error, "lay", "degrees", *angle, k->least, k->most);
}

static asp_code read_vector(aspi_words *r, const char *first) {
  asp_description *d = r->d;
  double *v = d->lay_numbers;
  asp_code code = aspi_quantity_read("lay", first, "", &d->units, &v[0], r->error);
  for (int i = 1; i < 3 && !code; i++) {
    const char *given = aspi_words_word(r, "lay");
    code = given ? aspi_quantity_read("lay", given, "", &d->units, &v[i], r->error) : ASP_EARG;
  }
  if (code)
    return code;
  double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  d->lay = ASP_LAY_VECTOR;
  if (length > 0 && isfinite(length))
    return ASP_OK;
  return aspi_fail(r->error, ASP_EARG,
                   "lay is %g %g %g; it must be a vector of a finite length > 0", v[0], v[1], v[2]);
}

asp_code aspi_lay_read(aspi_words *r, const aspi_keyword *k) {
  static const char *const directions[] = {"axial", "circumferential"};
  asp_description *d = r->d;
  for (int i = 0; i < 2; i++)
    if (aspi_words_accept(r, directions[i])) {
      d->lay = ASP_LAY_ANGLE;
      d->lay_word = directions[i];
      return ASP_OK;
    }
  bool is_number = aspi_words_number_next(r);
  const char *first = aspi_words_word(r, k->name);
  if (!first)
    return ASP_EARG;
  if (!is_number)
    return aspi_fail(r->error, ASP_EARG, "lay is '%.100s'; it must be %s", first, k->values);
  return aspi_words_number_next(r) ? read_vector(r, first) : read_angle(r, k, first);
}

void aspi_lay_write(aspi_line *l, const asp_description *d, const aspi_keyword *k) {
  (void)k;
  if (d->lay_word)
    aspi_line_word(l, d->lay_word);
  for (int i = 0; i < (d->lay == ASP_LAY_VECTOR ? 3 : 1) && !d->lay_word; i++)
    aspi_line_number(l, d->lay_numbers[i]);
}

/* L, or of a wall with a lay L L_along. */
asp_code aspi_lambda_c_read(aspi_words *r, const aspi_keyword *k) {
  asp_description *d = r->d;
  asp_code code = aspi_words_number(r, k, &d->lambda_c);
  if (code || d->kind == ASPI_SIGMA || !aspi_words_number_next(r))
    return code;
  code = aspi_words_number(r, k, &d->lambda_along);
  return code || aspi_words_next_is(r, "lay")
             ? code
             : aspi_fail(r->error, ASP_EARG,
                         "behind 'lambda_c L L_along', 'lay' and its direction are expected");
}

void aspi_lambda_c_write(aspi_line *l, const asp_description *d, const aspi_keyword *k) {
  aspi_line_value(l, d, k->name, k->unit, d->lambda_c);
  if (d->lambda_along > 0)
    aspi_line_value(l, d, "", k->unit, d->lambda_along);
}

/* A steeper slope without a unit is an angle whose unit was forgotten: r_q is at most lambda_c. */
#define SLOPE_MOST 1.5

/* A slope, or an angle with its unit. */
asp_code aspi_slope_read(aspi_words *r, const aspi_keyword *k) {
  double *slope = &r->d->spacing;
  const char *given = aspi_words_word(r, k->name);
  if (!given)
    return ASP_EARG;
  char *end;
  aspi_number(given, &end);
  asp_code code =
      aspi_quantity_read(k->name, given, *end ? "degrees" : k->unit, &r->d->units, slope, r->error);
  if (!code && *end)
    *slope = tan(aspi_radians(*slope));
  else if (!code && *slope > SLOPE_MOST)
    return aspi_fail(r->error, ASP_EARG, "%s is %s, a slope of %.0f degrees; say %sdeg?", k->name,
                     given, aspi_degrees(atan(*slope)), given);
  return code ? code : aspi_keyword_check(k, given, *slope, r->error);
}

/* lambda_c of L [sampling LR]; without LR in the middle of what any sampling length makes of L. */
static asp_code convert_rsm(aspi_words *r) {
  asp_description *d = r->d;
  if (!aspi_is_given(d, "sampling")) {
    double factors = aspi_r_sm_factor(ASPI_RSM_LEAST) * aspi_r_sm_factor(ASPI_RSM_MOST);
    d->lambda_c = d->spacing / sqrt(factors);
    return ASP_OK;
  }
  d->lambda_c = aspi_lambda_of_r_sm(d->spacing, d->sampling);
  return isfinite(d->lambda_c)
             ? ASP_OK
             : aspi_fail(r->error, ASP_EARG,
                         "rsm is %.3g of the sampling length; the table reaches from %.3g to %.3g: "
                         "say rdq or lambda_c instead",
                         d->spacing / d->sampling, aspi_r_sm_share(ASPI_RSM_MOST),
                         aspi_r_sm_share(ASPI_RSM_LEAST));
}

/* The words of which one must follow the height. */
static asp_code fail_spacing(aspi_words *r, const char *height) {
  char list[160] = "";
  for (const aspi_keyword *k = aspi_keywords; k->name; k++)
    if (k->after && aspi_words_in_list(height, k->after))
      aspi_append(list, sizeof list, "%s%s %s", *list ? ", " : "", k->name, k->values);
  return aspi_fail(r->error, ASP_EARG,
                   "'surface %s R' needs a length or a slope: %s; if you know only the height, see "
                   "src/wall/from_a_drawing.md",
                   height, list);
}

/* rq and lambda_c of the numbers that instruments print. */
static asp_code convert(aspi_words *r) {
  asp_description *d = r->d;
  static const char heights[] = "rq ra sq", spacings[] = "lambda_c rdq rsm sdq sal";
  const char *height = aspi_given_of(d, heights, 0), *spacing = aspi_given_of(d, spacings, 0);
  if (!spacing)
    return fail_spacing(r, height);
  asp_code code = aspi_words_check_one(r, spacings);
  if (!code && strcmp(spacing, "lambda_c") != 0 && aspi_is_fit(d, "rq"))
    code = aspi_fail(r->error, ASP_EARG, "a fit of rq needs lambda_c, not %s", spacing);
  if (strcmp(height, "ra") == 0)
    d->r_q = aspi_r_q_of_r_a(d->r_q);
  if (strcmp(spacing, "rdq") == 0)
    d->lambda_c = aspi_lambda_of_r_dq(d->r_q, d->spacing);
  else if (strcmp(spacing, "sdq") == 0)
    d->lambda_c = aspi_lambda_of_s_dq(d->r_q, d->spacing);
  else if (strcmp(spacing, "sal") == 0)
    d->lambda_c = aspi_lambda_of_s_al(d->spacing);
  else if (strcmp(spacing, "rsm") == 0 && !code)
    code = convert_rsm(r);
  aspi_set_given(d, "rq");
  aspi_set_given(d, "lambda_c");
  return code;
}

asp_code aspi_surface_finish(aspi_words *r) {
  asp_description *d = r->d;
  if (aspi_is_given(d, "lay") && d->kind != ASPI_MAP && !(d->lambda_along > 0))
    return aspi_fail(
        r->error, ASP_EARG,
        "'lay' needs two correlation lengths, across it and along it, or a map: surface "
        "rq R lambda_c L L_along lay DIRECTION");
  return d->kind == ASPI_GAUSSIAN ? convert(r) : ASP_OK;
}
