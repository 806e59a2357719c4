/* asperity compare: impacts of a model or a simulation against measured coefficients of
 * restitution, at the data's own angles, speeds and sizes: moments, the share of measured points
 * within the model's 5 to 95 % band, the two-sample distance of Kolmogorov and Smirnov with its
 * p-value, shares of deposits, one score over all, and a picture.
 *
 * Each measured impact is compared with the model's impacts at its own place: those that have its
 * angle (and speed, and size), or else those near it, which together weigh as much as it does. So
 * a bin of measurements at different angles has a model sample of the same angles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/compare.h"
#include "cli/window.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  BIN,
  NEAR,
  MEASURED,
  OUTPUT = MEASURED + MEASURED_OPTION_COUNT,
  PLOT,
  N = PLOT + PLOT_OPTIONS
};

static const char *const names[COR_BOTH] = {"cor_n", "cor_t"};

/* Width of bins in degrees, for impacts that were not measured again and again at some places; and
 * how far impacts of the model may be from a place where none has it: degrees, and shares of speed
 * and of size. */
#define WIDTH "10"
#define FAR "2,0.1,0.1"

/* Places are the same that differ by less: in degrees, and as a share. */
#define SAME_ANGLE 1e-4
#define SAME_SHARE 1e-4

/* So many impacts at a place itself are enough; with fewer, those near it count. */
enum { ENOUGH = 20 };

/* With so many measurements at each place, on average, every place is a bin of its own. */
enum { ROWS_EACH = 4 };

typedef struct reach {
  double degrees, speed, size;
} reach;

static int by_angle(const void *left, const void *right) {
  const scatter_point *a = left, *b = right;
  return (a->degrees > b->degrees) - (a->degrees < b->degrees);
}

/* How many of the points, which are in order of their angle, lie below it. */
static size_t count_below(const scatter_impacts *impacts, double angle) {
  size_t low = 0, high = impacts->count;
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (impacts->points[middle].degrees < angle)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

static bool is_near(double is, double wanted, double share) {
  return isnan(wanted) || fabs(is - wanted) <= share * wanted;
}

static bool same_place(const measured_row *a, const measured_row *b) {
  return fabs(a->degrees - b->degrees) <= SAME_ANGLE &&
         (isnan(a->v1) || is_near(a->v1, b->v1, SAME_SHARE)) &&
         (isnan(a->d_p) || is_near(a->d_p, b->d_p, SAME_SHARE));
}

/* ---- the bins' rows ---------------------------------------------------------------------------
 */

static size_t count_places(const measured *data) {
  size_t places = 0;
  for (size_t i = 0; i < data->count; i++)
    places += i == 0 || !same_place(&data->rows[i], &data->rows[i - 1]);
  return places;
}

/* Which interval of that width an angle is in; the last one ends with 90 degrees. */
static double interval_of(const measured_row *row, double width) {
  return floor(fmin(row->degrees, 90 - 1e-6) / width + 1e-9);
}

/* Each row of means; else each place, where there are many rows at one, or intervals of angle. */
static void make_bins(comparison *c, const cli_option *bin) {
  const measured *data = &c->data;
  bool places = !data->means && !bin->value && data->count >= ROWS_EACH * count_places(data);
  cli_option width_option = *bin;
  width_option.value = bin->value ? bin->value : WIDTH;
  double width = cli_number(&width_option, 0.1, 90);
  c->bins = cli_allocate(data->count, sizeof *c->bins);
  for (size_t i = 0; i < data->count; i++) {
    const measured_row *row = &data->rows[i], *last = i ? row - 1 : row;
    bool joins =
        i > 0 && !data->means &&
        (places ? same_place(row, last) : interval_of(row, width) <= interval_of(last, width));
    if (!joins)
      c->bins[c->count++] = (compare_bin){.first = i};
    c->bins[c->count - 1].end = i + 1;
  }
  for (size_t b = 0; b < c->count; b++) {
    compare_bin *on = &c->bins[b];
    double n = (double)(on->end - on->first);
    for (size_t i = on->first; i < on->end; i++) {
      on->degrees += data->rows[i].degrees / n;
      on->v1 += data->rows[i].v1 / n;
      on->d_p += data->rows[i].d_p / n;
      on->data_deposits += data->rows[i].deposit;
    }
    on->deposits_p = NAN;
    for (int k = 0; k < COR_BOTH; k++)
      on->in_band[k] = on->distance[k] = on->p[k] = NAN;
  }
}

/* ---- impacts at a place -----------------------------------------------------------------------
 */

/* The impacts that weigh in a bin, and how much. */
typedef struct weights {
  double *of;    /* of each impact */
  size_t *which; /* those that have a weight */
  size_t count;
} weights;

static bool is_around(const scatter_point *p, const measured_row *at, const reach *far) {
  return is_near(p->v1, at->v1, far->speed) && is_near(p->d_p, at->d_p, far->size);
}

static size_t count_near(const scatter_impacts *impacts, const measured_row *at, const reach *far) {
  size_t found = 0;
  const scatter_point *p = impacts->points;
  for (size_t i = count_below(impacts, at->degrees - far->degrees);
       i < impacts->count && p[i].degrees <= at->degrees + far->degrees; i++)
    found += is_around(&p[i], at, far);
  return found;
}

/* Gives the impacts around a place, no farther than that, a weight of `rows` together. */
static void weigh(const scatter_impacts *impacts, const measured_row *at, const reach *far,
                  double rows, weights *w) {
  double each = rows / (double)count_near(impacts, at, far);
  const scatter_point *p = impacts->points;
  for (size_t i = count_below(impacts, at->degrees - far->degrees);
       i < impacts->count && p[i].degrees <= at->degrees + far->degrees; i++) {
    if (!is_around(&p[i], at, far))
      continue;
    if (!(w->of[i] > 0))
      w->which[w->count++] = i;
    w->of[i] += each;
  }
}

/* The model's sample in a bin, and its deposits. */
static void sample_model(const comparison *c, const reach *far, weights *w, compare_bin *b) {
  static const reach same = {SAME_ANGLE, SAME_SHARE, SAME_SHARE};
  const measured_row *rows = c->data.rows;
  b->from = 90;
  b->to = 0;
  w->count = 0;
  for (size_t i = b->first, next; i < b->end; i = next) {
    for (next = i + 1; next < b->end && same_place(&rows[i], &rows[next]);)
      next++;
    double n = (double)(next - i);
    size_t at = count_near(&c->impacts, &rows[i], &same);
    bool exact = at >= ENOUGH || (at > 0 && at == count_near(&c->impacts, &rows[i], far));
    weigh(&c->impacts, &rows[i], exact ? &same : far, n, w);
    double wide = exact ? 0 : far->degrees;
    b->from = fmax(0, fmin(b->from, rows[i].degrees - wide));
    b->to = fmin(90, fmax(b->to, rows[i].degrees + wide));
  }
  double total = 0, stuck = 0, squares = 0;
  for (size_t i = 0; i < w->count; i++) {
    double weight = w->of[w->which[i]];
    total += weight;
    squares += weight * weight;
    stuck += c->impacts.points[w->which[i]].deposit ? weight : 0;
  }
  b->model_all = total > 0 ? total * total / squares : 0;
  b->model_deposits = total > 0 ? stuck / total * b->model_all : 0;
  for (int k = 0; k < COR_BOTH; k++) {
    sample *s = &b->model[k];
    s->values = cli_allocate(w->count, sizeof *s->values);
    for (size_t i = 0; i < w->count; i++)
      if (isfinite(c->impacts.points[w->which[i]].cor[k]))
        s->values[s->count++] =
            (sample_value){c->impacts.points[w->which[i]].cor[k], w->of[w->which[i]]};
    sample_describe(s);
  }
  while (w->count > 0)
    w->of[w->which[--w->count]] = 0;
}

static void sample_data(const measured *data, compare_bin *b) {
  for (int k = 0; k < COR_BOTH; k++) {
    sample *s = &b->data[k];
    const measured_row *row = &data->rows[b->first];
    *s = (sample){.mean = row->cor[k], .sd = row->sd[k], .median = NAN, .low = NAN, .high = NAN};
    if (data->means)
      continue;
    s->values = cli_allocate(b->end - b->first, sizeof *s->values);
    for (size_t i = b->first; i < b->end; i++)
      if (isfinite(data->rows[i].cor[k]))
        s->values[s->count++] = (sample_value){data->rows[i].cor[k], 1};
    sample_describe(s);
  }
}

/* Rows of means without speeds and sizes, as many as there may be, by a window that moves over the
 * impacts. */
static void sample_by_window(comparison *c, double far, int which) {
  cli_window *window = cli_window_create(c->impacts.points, c->impacts.count, which);
  for (size_t i = 0; i < c->count; i++) {
    compare_bin *b = &c->bins[i];
    size_t at = count_below(&c->impacts, b->degrees + SAME_ANGLE) -
                count_below(&c->impacts, b->degrees - SAME_ANGLE);
    size_t around =
        count_below(&c->impacts, b->degrees + far) - count_below(&c->impacts, b->degrees - far);
    bool exact = at >= ENOUGH || (at > 0 && at >= around);
    double wide = exact ? 0 : far, slack = exact ? SAME_ANGLE : 0;
    b->from = fmax(0, b->degrees - wide);
    b->to = fmin(90, b->degrees + wide);
    cli_window_move(window, b->from - slack, b->to + slack);
    sample *s = &b->model[which];
    *s = (sample){.count = cli_window_count(window)};
    s->mean = s->sd = s->median = s->low = s->high = NAN;
    s->size = (double)s->count;
    if (s->count > 0) {
      cli_window_moments(window, &s->mean, &s->sd);
      s->sd = s->count > 1 ? s->sd : NAN;
      s->median = cli_window_quantile(window, 0.5);
    }
    if (s->count >= 20) {
      s->low = cli_window_quantile(window, 0.05);
      s->high = cli_window_quantile(window, 0.95);
    }
  }
  cli_window_free(window);
}

/* ---- one bin ----------------------------------------------------------------------------------
 */

bool cli_compare_has_both(const compare_bin *b, int which) {
  return isfinite(b->data[which].mean) && b->model[which].count > 0;
}

bool cli_compare_is_drawn(const comparison *c, const compare_bin *b, int which) {
  return c->names[1] ? cli_compare_has_both(b, which) : b->model[which].count > 0;
}

/* A mean whose standard error is known, against the model's. */
static double p_of_means(const sample *model, const measured_row *row, int which) {
  double error = isfinite(row->se[which]) ? row->se[which] : row->sd[which] / sqrt(row->n);
  double own = model->sd / sqrt(model->size);
  double z = fabs(model->mean - row->cor[which]) / hypot(error, isfinite(own) ? own : 0);
  return isfinite(z) ? erfc(z / sqrt(2)) : NAN;
}

static void compare_bin_of(const comparison *c, compare_bin *b) {
  size_t rows = b->end - b->first;
  for (int k = 0; k < COR_BOTH; k++) {
    const sample *m = &b->model[k], *d = &b->data[k];
    if (!cli_compare_has_both(b, k))
      continue;
    if (c->data.means) {
      b->p[k] = p_of_means(m, &c->data.rows[b->first], k);
      continue;
    }
    if (isfinite(m->low))
      b->in_band[k] = sample_within(d, m->low, m->high);
    b->distance[k] = sample_distance(m, d);
    b->p[k] = sample_p_value(m, d, b->distance[k]);
  }
  if (c->data.has_outcome && b->model_all >= 1 && b->model_deposits + b->data_deposits > 0)
    b->deposits_p = shares_p_value((size_t)(b->model_deposits + 0.5), (size_t)(b->model_all + 0.5),
                                   (size_t)b->data_deposits, rows);
}

static void compare_all(comparison *c, const reach *far) {
  bool by_window = c->data.means && !c->data.has_speed && !c->data.has_size;
  weights w = {cli_allocate(c->impacts.count, sizeof *w.of),
               cli_allocate(c->impacts.count, sizeof *w.which), 0};
  for (int k = 0; k < COR_BOTH && by_window; k++)
    sample_by_window(c, far->degrees, k);
  for (size_t i = 0; i < c->count; i++) {
    compare_bin *b = &c->bins[i];
    if (!by_window)
      sample_model(c, far, &w, b);
    sample_data(&c->data, b);
    compare_bin_of(c, b);
  }
  free(w.of);
  free(w.which);
}

/* ---- output -----------------------------------------------------------------------------------
 */

/* A field; nothing where there is no number. */
static void print(FILE *out, double value) {
  if (isfinite(value))
    fprintf(out, ",%.6g", value);
  else
    fputc(',', out);
}

typedef struct score {
  double difference2, in_sd2, in_band, distance, *p;
  size_t differences, in_sds, bands, distances, ps, model_n, data_n;
} score;

static void add(double value, double *sum, size_t *count) {
  if (!isfinite(value))
    return;
  *sum += value;
  (*count)++;
}

static void print_bin(FILE *out, const comparison *c, const compare_bin *b, int k, score *s) {
  const sample *m = &b->model[k], *d = &b->data[k];
  double off = m->mean - d->mean, in_sd = off / (d->sd > 0 ? d->sd : NAN);
  fprintf(out, "%s,%g,%g,%zu", names[k], b->from, b->to, m->count);
  print(out, m->mean);
  print(out, m->sd);
  print(out, m->median);
  print(out, m->low);
  print(out, m->high);
  print(out, c->data.means ? c->data.rows[b->first].n : (double)d->count);
  print(out, d->mean);
  print(out, d->sd);
  print(out, d->median);
  print(out, in_sd);
  print(out, b->in_band[k]);
  print(out, b->distance[k]);
  print(out, b->p[k]);
  print(out, b->degrees);
  print(out, b->v1);
  print(out, b->d_p * 1e6);
  print(out, off);
  fputc('\n', out);
  s->model_n += m->count;
  s->data_n += d->count;
  add(off * off, &s->difference2, &s->differences);
  add(in_sd * in_sd, &s->in_sd2, &s->in_sds);
  add(b->in_band[k], &s->in_band, &s->bands);
  add(b->distance[k], &s->distance, &s->distances);
  if (isfinite(b->p[k]))
    s->p[s->ps++] = b->p[k];
}

/* Shares of deposits, as means. */
static void print_deposits(FILE *out, const comparison *c, const compare_bin *b, score *s) {
  double rows = (double)(b->end - b->first), share = b->model_deposits / b->model_all;
  double data = c->data.has_outcome ? b->data_deposits / rows : NAN;
  fprintf(out, "deposits,%g,%g,%.0f", b->from, b->to, b->model_all);
  print(out, share);
  fputs(",,,,", out);
  print(out, c->data.has_outcome ? rows : NAN);
  print(out, data);
  fputs(",,,,,", out);
  print(out, b->deposits_p);
  print(out, b->degrees);
  print(out, b->v1);
  print(out, b->d_p * 1e6);
  print(out, share - data);
  fputc('\n', out);
  if (isfinite(b->deposits_p))
    s->p[s->ps++] = b->deposits_p;
}

static void print_overall(FILE *out, const score *s, double p) {
  fprintf(out, "overall,,,%zu,,,,,,%zu,,,", s->model_n, s->data_n);
  print(out, sqrt(s->in_sd2 / (double)s->in_sds));
  print(out, s->in_band / (double)s->bands);
  print(out, s->distance / (double)s->distances);
  print(out, p);
  fputs(",,,", out);
  print(out, sqrt(s->difference2 / (double)s->differences));
  fputc('\n', out);
}

static const char note[] =
    "# note: deposits have no coefficients and are left out of means and bands; their shares are "
    "compared\n"
    "# where the data tell outcomes. Coefficients and constants that were fitted to measurements "
    "hold the\n"
    "# roughness of the measured wall already; with a rough wall they count it twice.\n";

static void print_all(FILE *out, const comparison *c) {
  score s = {.p = cli_allocate(3 * c->count, sizeof *s.p)};
  double each[3];
  size_t n_each = 0;
  fputs(note, out);
  fprintf(out, "# %zu rebounds, %zu deposits\n", c->impacts.count - c->impacts.deposits,
          c->impacts.deposits);
  fputs("coefficient,alpha_from_deg,alpha_to_deg,model_n,model_mean,model_sd,model_median,"
        "model_p05,model_p95,data_n,data_mean,data_sd,data_median,mean_difference_in_data_sd,"
        "data_in_model_band,ks_distance,p_value,alpha1_deg,v1_m_s,dp_um,mean_difference\n",
        out);
  for (int k = 0; k < 3; k++) {
    s.ps = 0;
    for (size_t i = 0; i < c->count; i++)
      if (k < COR_BOTH)
        print_bin(out, c, &c->bins[i], k, &s);
      else if (c->data.has_outcome)
        print_deposits(out, c, &c->bins[i], &s);
    if (s.ps > 0)
      each[n_each++] = combine_independent(s.p, s.ps);
  }
  print_overall(out, &s, combine_dependent(each, n_each));
  free(s.p);
}

/* Warns of bins that have only one of both, and fails where there is none with both. */
static void check_bins(const comparison *c) {
  size_t both = 0;
  for (int k = 0; k < COR_BOTH; k++) {
    size_t no_model = 0, with_data = 0;
    for (size_t i = 0; i < c->count; i++) {
      bool data = isfinite(c->bins[i].data[k].mean);
      with_data += data;
      no_model += data && c->bins[i].model[k].count == 0;
    }
    if (no_model > 0)
      cli_warn("%s: %zu of %zu bins with data are empty of impacts near them (see --near)",
               names[k], no_model, with_data);
    both += with_data - no_model;
  }
  if (both == 0)
    cli_bad_usage("no bin has both impacts and data; the angles%s%s do not overlap",
                  c->data.has_speed ? ", speeds" : "", c->data.has_size ? ", sizes" : "");
}

/* Whether the comment that the impacts begin with names a fitted law or constant. */
static void warn_double(const scatter_impacts *impacts) {
  static const char *const fitted[] = {"grant_tabakoff", "rebound table", "yield_rate"};
  for (size_t i = 0; impacts->rough && i < sizeof fitted / sizeof *fitted; i++)
    if (strstr(impacts->comment, fitted[i])) {
      cli_warn("the impacts are from a rough wall with '%s', which was fitted to measurements: "
               "roughness is counted twice",
               fitted[i]);
      return;
    }
}

/* Impacts of a file without speeds or sizes are taken for those of any. */
static void leave_out(comparison *c) {
  bool speeds = false, sizes = false;
  for (size_t i = 0; i < c->impacts.count && !(speeds && sizes); i++) {
    speeds = speeds || isfinite(c->impacts.points[i].v1);
    sizes = sizes || isfinite(c->impacts.points[i].d_p);
  }
  bool no_speeds = c->data.has_speed && !speeds, no_sizes = c->data.has_size && !sizes;
  if (no_speeds || no_sizes)
    cli_warn("%s: no %s of impacts in it; those of the data are not looked at", c->names[0],
             no_speeds && no_sizes ? "speeds and sizes"
             : no_speeds           ? "speeds"
                                   : "sizes");
  for (size_t i = 0; i < c->data.count; i++) {
    c->data.rows[i].v1 = no_speeds ? NAN : c->data.rows[i].v1;
    c->data.rows[i].d_p = no_sizes ? NAN : c->data.rows[i].d_p;
  }
  c->data.has_speed = c->data.has_speed && speeds;
  c->data.has_size = c->data.has_size && sizes;
}

/* ---- impacts alone ----------------------------------------------------------------------------
 */

/* Takes the impacts themselves for rows, whose places are those of the table. */
static void take_impacts(comparison *c) {
  const scatter_impacts *impacts = &c->impacts;
  c->data = (measured){.rows = cli_allocate(impacts->count, sizeof *c->data.rows),
                       .count = impacts->count,
                       .has_outcome = true};
  for (size_t i = 0; i < impacts->count; i++) {
    const scatter_point *p = &impacts->points[i];
    c->data.rows[i] = (measured_row){.degrees = p->degrees,
                                     .v1 = p->v1,
                                     .d_p = p->d_p,
                                     .cor = {p->cor[COR_N], p->cor[COR_T]},
                                     .deposit = p->deposit};
  }
  measured_sort(&c->data);
}

/* What is in a bin, in place of the model's sample. */
static void sample_impacts(comparison *c) {
  for (size_t i = 0; i < c->count; i++) {
    compare_bin *b = &c->bins[i];
    sample_data(&c->data, b);
    for (int k = 0; k < COR_BOTH; k++) {
      b->model[k] = b->data[k];
      b->data[k] = (sample){.mean = NAN, .sd = NAN};
    }
    b->from = c->data.rows[b->first].degrees;
    b->to = c->data.rows[b->end - 1].degrees;
  }
}

static void print_impacts(FILE *out, const comparison *c) {
  fprintf(out, "# %zu rebounds, %zu deposits\n", c->impacts.count - c->impacts.deposits,
          c->impacts.deposits);
  fputs("alpha1_deg,alpha_from_deg,alpha_to_deg,v1_m_s,dp_um,impacts,capture_share,n,cor_n_mean,"
        "cor_n_sd,cor_n_median,cor_n_p05,cor_n_p95,cor_t_mean,cor_t_sd,cor_t_median,cor_t_p05,"
        "cor_t_p95\n",
        out);
  for (size_t i = 0; i < c->count; i++) {
    const compare_bin *b = &c->bins[i];
    double all = (double)(b->end - b->first);
    fprintf(out, "%.6g,%.6g,%.6g", b->degrees, b->from, b->to);
    print(out, b->v1);
    print(out, b->d_p * 1e6);
    print(out, all);
    print(out, b->data_deposits / all);
    print(out, all - b->data_deposits);
    for (int k = 0; k < COR_BOTH; k++) {
      const sample *s = &b->model[k];
      print(out, s->mean);
      print(out, s->sd);
      print(out, s->median);
      print(out, s->low);
      print(out, s->high);
    }
    fputc('\n', out);
  }
}

/* ---- the command ------------------------------------------------------------------------------
 */

/* DEGREES[,SPEED[,SIZE]] */
static reach reach_of(const cli_option *option) {
  reach far = {0, 0.1, 0.1};
  cli_list list = cli_numbers(option, 0, 90);
  if (list.count < 1 || list.count > 3)
    cli_bad_usage("--%s is '%s'; it must be %s", option->name, option->value, option->argument);
  far.degrees = list.values[0];
  far.speed = list.count > 1 ? list.values[1] : far.speed;
  far.size = list.count > 2 ? list.values[2] : far.size;
  free(list.values);
  return far;
}

/* Impacts as the data look at them. */
static void take_view(comparison *c) {
  measured_need_view(c->names[1], &c->data, c->impacts.sideways);
  if (c->data.view != MEASURED_SPACE)
    return;
  size_t missing = 0;
  for (size_t i = 0; i < c->impacts.count; i++) {
    scatter_point *p = &c->impacts.points[i];
    missing += isfinite(p->cor[COR_T]) && isnan(p->cor_t_space);
    p->cor[COR_T] = p->cor_t_space;
  }
  if (missing > 0)
    cli_bad_usage("%s: the data are of rebounds in space, and these impacts have no speed v2 or "
                  "cor_v_space to compare with",
                  c->names[0]);
}

static void free_comparison(comparison *c) {
  for (size_t i = 0; i < c->count; i++)
    for (int k = 0; k < COR_BOTH; k++) {
      free(c->bins[i].model[k].values);
      free(c->bins[i].data[k].values);
    }
  free(c->bins);
  scatter_free_impacts(&c->impacts);
  measured_free(&c->data);
}

static void table_impacts(comparison *c, const cli_option *bin) {
  take_impacts(c);
  make_bins(c, bin);
  sample_impacts(c);
}

static void compare_with(comparison *c, const cli_option *options) {
  reach far = reach_of(&options[NEAR]);
  c->data = measured_read(c->names[1], &options[MEASURED]);
  qsort(c->impacts.points, c->impacts.count, sizeof *c->impacts.points, by_angle);
  leave_out(c);
  take_view(c);
  make_bins(c, &options[BIN]);
  compare_all(c, &far);
  check_bins(c);
  warn_double(&c->impacts);
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [BIN] = {"bin", "DEGREES",
               "width of the bins of single impacts; without it every place that was measured "
               "often is one, else " WIDTH,
               NULL},
      [NEAR] = {"near", "DEGREES[,SPEED[,SIZE]]",
                "how far impacts may be from a place that none has: degrees, shares", FAR},
      MEASURED_OPTIONS(MEASURED),
      [OUTPUT] = CLI_OUTPUT_OPTION,
      CLI_PLOT_OPTIONS(PLOT, "draw it; .png, .svg or .pdf"),
  };
  cli_option standard[N];
  memcpy(standard, options, sizeof standard);
  int first = cli_parse(&cli_compare, argc, argv, options, true);
  bool alone = argc - first == 1;
  if (argc - first != 2 && !alone)
    cli_bad_usage("compare: IMPACTS or IMPACTS and DATA are expected, one file or two; see "
                  "'asperity compare --help'");
  for (int i = NEAR; i < OUTPUT && alone; i++)
    if (options[i].value != standard[i].value)
      cli_bad_usage("--%s has no effect without DATA", options[i].name);
  for (int i = first; i < argc; i++)
    cli_keep_input(options, argv[i]);
  comparison c = {.names = {argv[first], alone ? NULL : argv[first + 1]},
                  .impacts = scatter_read_impacts(argv[first])};
  if (alone)
    table_impacts(&c, &options[BIN]);
  else
    compare_with(&c, options);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, NULL);
  (alone ? print_impacts : print_all)(cli_output_stream(output), &c);
  cli_output_close(output);
  if (options[PLOT].value)
    cli_compare_plot(&options[PLOT], &c);
  free_comparison(&c);
  return 0;
}

const cli_command cli_compare = {
    .name = "compare",
    .arguments = "IMPACTS [DATA]",
    .summary = "impacts of a model or a simulation, alone or against measured coefficients",
    .detail =
        "asperity compare IMPACTS [DATA]: IMPACTS is the output of 'asperity cor', the ledger of "
        "a\n"
        "wall (CSV or .npy), or a dump local file of its array (of its columns alpha1, cor_n, "
        "cor_t\n"
        "and outcome; v1 and d_p where the data have them). Alone it is tabled and drawn: for "
        "each\n"
        "place, or interval of angle, the share that sticks, and of the n others both "
        "coefficients.\n" MEASURED_FORMS
        "\nAt the data's own angles, and speeds and sizes where they have them: moments, the "
        "model's\n"
        "5 to 95 % band and the share of the points in it, the two-sample distance of Kolmogorov\n"
        "and Smirnov and its p-value (of means: by their standard errors, where they have them).\n"
        "Deposits have no coefficients; where the data tell outcomes, their shares are compared\n"
        "(Fisher's exact test). The last row, `overall`, is the score: the root mean square of "
        "the\n"
        "differences of means (absolute, and in the data's sd), the mean share in the band, the\n"
        "mean distance, and one p-value (Fisher's over the places, Cauchy's over the kinds).\n",
    .run = run,
};
