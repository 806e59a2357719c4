/* Reads the clause `surface`: heights by numbers, as a wall or as an instrument has them, or by a
 * file, and the lay.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/units.h"
#include "base/number.h"
#include "base/quantity.h"
#include "description/words.h"
#include "surface/instrument.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static asp_code read_angle(aspi_words *r, const char *first) {
  asp_description *d = r->d;
  const asp_keyword *k = aspi_keyword_find("surface", "lay");
  asp_code code =
      aspi_quantity_read("lay", first, k->unit, &d->units, &d->lay_numbers[0], r->error);
  d->lay = ASP_LAY_ANGLE;
  return code ? code
              : aspi_check_range(r->error, "lay", "degrees", d->lay_numbers[0], k->least, k->most);
}

static asp_code read_vector(aspi_words *r, const char *first) {
  asp_description *d = r->d;
  double *v = d->lay_numbers;
  asp_code code = aspi_quantity_read("lay", first, "", &d->units, &v[0], r->error);
  for (int i = 1; i < 3 && !code; i++) {
    const char *what =
        i == 1 ? "the second number of the lay's vector" : "the third number of the lay's vector";
    const char *given = aspi_words_word(r, what);
    code = given ? aspi_quantity_read(what, given, "", &d->units, &v[i], r->error) : ASP_EARG;
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

static asp_code read_lay(aspi_words *r) {
  static const char *const directions[] = {"axial", "circumferential"};
  asp_description *d = r->d;
  aspi_set_given(d, "lay");
  for (int i = 0; i < 2; i++)
    if (aspi_words_take(r, directions[i])) {
      d->lay = ASP_LAY_ANGLE;
      d->lay_word = directions[i];
      return ASP_OK;
    }
  const char *first = aspi_words_word(r, "lay");
  if (!first)
    return ASP_EARG;
  char *end;
  aspi_number(first, &end);
  if (end == first)
    return aspi_fail(r->error, ASP_EARG, "lay is '%.100s'; it must be %s", first,
                     aspi_keyword_find("surface", "lay")->values);
  return aspi_words_number_next(r) ? read_vector(r, first) : read_angle(r, first);
}

/* L [L_along lay DIRECTION] */
static asp_code read_lambda_c(aspi_words *r) {
  asp_description *d = r->d;
  asp_code code = aspi_words_number(r, "surface", "lambda_c", &d->lambda_c);
  if (code || !aspi_words_number_next(r))
    return code;
  code = aspi_words_number(r, "surface", "lambda_c", &d->lambda_along);
  if (!code && !aspi_words_take(r, "lay"))
    code = aspi_fail(r->error, ASP_EARG,
                     "behind 'lambda_c L L_along', 'lay' and its direction are expected");
  return code ? code : read_lay(r);
}

/* A slope, or an angle with its unit. */
static asp_code read_slope(aspi_words *r, const char *name, double *slope) {
  const char *given = aspi_words_word(r, name);
  if (!given)
    return ASP_EARG;
  char *end;
  aspi_number(given, &end);
  asp_code code =
      aspi_quantity_read(name, given, *end ? "degrees" : "", &r->d->units, slope, r->error);
  if (!code && *end)
    *slope = tan(aspi_radians(*slope));
  return code ? code : aspi_quantity_check(name, given, "", *slope, 0, INFINITY, true, r->error);
}

static asp_code read_rdq(aspi_words *r) {
  double slope;
  asp_code code = read_slope(r, "rdq", &slope);
  r->d->lambda_c = code ? NAN : aspi_lambda_of_r_dq(r->d->r_q, slope);
  return code;
}

static asp_code read_sdq(aspi_words *r) {
  double slope;
  asp_code code = read_slope(r, "sdq", &slope);
  r->d->lambda_c = code ? NAN : aspi_lambda_of_s_dq(r->d->r_q, slope);
  return code;
}

static asp_code read_sal(aspi_words *r) {
  double length;
  asp_code code = aspi_words_number(r, "surface", "sal", &length);
  r->d->lambda_c = code ? NAN : aspi_lambda_of_s_al(length);
  return code;
}

/* L [sampling LR]; without LR in the middle of what any sampling length makes of L. */
static asp_code read_rsm(aspi_words *r) {
  asp_description *d = r->d;
  double length, sampling;
  asp_code code = aspi_words_number(r, "surface", "rsm", &length);
  if (code)
    return code;
  d->r_sm = length;
  d->lambda_c = length / sqrt(aspi_r_sm_factor(ASPI_RSM_LEAST) * aspi_r_sm_factor(ASPI_RSM_MOST));
  if (!aspi_words_take(r, "sampling"))
    return ASP_OK;
  d->r_sm = NAN;
  if ((code = aspi_words_number(r, "surface", "sampling", &sampling)))
    return code;
  d->lambda_c = aspi_lambda_of_r_sm(length, sampling);
  return isfinite(d->lambda_c)
             ? ASP_OK
             : aspi_fail(r->error, ASP_EARG,
                         "rsm is %.3g of the sampling length; the table reaches from %.3g to %.3g: "
                         "say rdq or lambda_c instead",
                         length / sampling, aspi_r_sm_share(ASPI_RSM_MOST),
                         aspi_r_sm_share(ASPI_RSM_LEAST));
}

/* Numbers for the spacing of heights that instruments print, and the heights they go with. */
static const struct {
  const char *name, *beside;
  asp_code (*read)(aspi_words *r);
} spacings[] = {{"lambda_c", "rq ra sq", read_lambda_c},
                {"rdq", "rq ra", read_rdq},
                {"rsm", "rq ra", read_rsm},
                {"sdq", "sq", read_sdq},
                {"sal", "sq", read_sal}};
enum { SPACINGS = sizeof spacings / sizeof *spacings };

static asp_code read_spacing(aspi_words *r, const char *heights) {
  char list[160] = "";
  for (int i = 0; i < SPACINGS; i++) {
    if (!aspi_words_in_list(heights, spacings[i].beside))
      continue;
    if (aspi_words_take(r, spacings[i].name)) {
      aspi_set_given(r->d, spacings[i].name);
      if (i > 0 && aspi_is_fit(r->d, "rq"))
        return aspi_fail(r->error, ASP_EARG, "a fit of rq needs lambda_c, not %s",
                         spacings[i].name);
      asp_code code = spacings[i].read(r);
      aspi_set_given(r->d, "lambda_c");
      return code;
    }
    size_t used = strlen(list);
    snprintf(list + used, sizeof list - used, "%s%s %s", used ? ", " : "", spacings[i].name,
             aspi_keyword_find("surface", spacings[i].name)->values);
  }
  return aspi_fail(
      r->error, ASP_EARG,
      "behind 'surface %s', one of these is expected: %s; if you know only the height, "
      "see the page src/wall/from_a_drawing.md",
      heights, list);
}

static asp_code read_heights(aspi_words *r, const char *heights) {
  asp_description *d = r->d;
  d->kind = ASPI_GAUSSIAN;
  asp_code code = aspi_words_number(r, "surface", heights, &d->r_q);
  if (strcmp(heights, "ra") == 0)
    d->r_q = aspi_r_q_of_r_a(d->r_q);
  aspi_set_given(d, "rq");
  return code ? code : read_spacing(r, heights);
}

static asp_code read_kind(aspi_words *r) {
  asp_description *d = r->d;
  asp_code code = ASP_OK;
  if (aspi_words_take(r, "smooth")) {
    d->kind = ASPI_SMOOTH;
    return ASP_OK;
  }
  if (aspi_words_take(r, "sigma")) {
    d->kind = ASPI_SIGMA;
    code = aspi_words_number(r, "surface", "sigma", &d->sigma);
    return code || !aspi_words_take(r, "lambda_c")
               ? code
               : aspi_words_number(r, "surface", "lambda_c", &d->lambda_c);
  }
  static const char *const heights[] = {"rq", "ra", "sq"};
  int k = 0;
  while (k < 3 && !aspi_words_take(r, heights[k]))
    k++;
  if (k < 3) {
    code = read_heights(r, heights[k]);
  } else if (aspi_words_next_is(r, "rz")) {
    return aspi_fail(r->error, ASP_EARG,
                     "rz does not give rq: R_z/R_q grows from 2.8 to 5.0 with the sampling length; "
                     "say rq R or ra R");
  } else if (aspi_words_take(r, "profile")) {
    d->kind = ASPI_PROFILE;
    code = aspi_words_file(r, "the file of 'surface profile'", &d->file);
  } else if (aspi_words_take(r, "map")) {
    d->kind = ASPI_MAP;
    code = aspi_words_file(r, "the file of 'surface map'", &d->file);
  } else {
    const char *given = aspi_words_word(r, "the value of 'surface'");
    return !given ? ASP_EARG
                  : aspi_fail(r->error, ASP_ENAME, "surface is '%.100s'; it must be %s", given,
                              aspi_keyword_find("", "surface")->values);
  }
  for (bool more = true; more && !code;) {
    if (aspi_words_take_once(r, "dp_bins", &code))
      code = code ? code : aspi_words_number(r, "surface", "dp_bins", &d->bins);
    else if (d->kind == ASPI_MAP && aspi_words_take_once(r, "lay", &code))
      code = code ? code : read_lay(r);
    else
      more = false;
  }
  return code;
}

asp_code aspi_words_surface(aspi_words *r) {
  asp_code code = read_kind(r);
  if (code || !aspi_words_next_is(r, "lay") || aspi_is_given(r->d, "lay"))
    return code;
  return aspi_fail(r->error, ASP_EARG,
                   "'lay' needs two correlation lengths, across it and along it, or a map: surface "
                   "rq R lambda_c L L_along lay DIRECTION");
}
