/* asperity compare: impacts of a model or a simulation against measured coefficients of
 * restitution, by impact angle: moments, the share of measured points within the model's 5 to 95 %
 * band, the two-sample distance of Kolmogorov and Smirnov with its p-value, and a picture. */
#include "cli/compare.h"
#include "cli/window.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BIN, OUTPUT, PLOT, N };

static const char *const names[COR_BOTH] = {"cor_n", "cor_t"};

/* Fewer impacts than this have no 5 to 95 % band. */
enum { BAND_LEAST = 20 };

/* Widths of bins in degrees: of points, and around each row of means. */
#define WIDTH_POINTS "10"
#define WIDTH_MEANS "4"

static void describe(compare_sample *s) {
  s->mean = s->sd = s->median = s->low = s->high = NAN;
  if (s->count == 0)
    return;
  gsl_sort(s->values, 1, s->count);
  s->mean = gsl_stats_mean(s->values, 1, s->count);
  s->median = gsl_stats_median_from_sorted_data(s->values, 1, s->count);
  if (s->count > 1)
    s->sd = gsl_stats_sd_m(s->values, 1, s->count, s->mean);
  if (s->count < BAND_LEAST)
    return;
  s->low = gsl_stats_quantile_from_sorted_data(s->values, 1, s->count, 0.05);
  s->high = gsl_stats_quantile_from_sorted_data(s->values, 1, s->count, 0.95);
}

static int by_angle(const void *left, const void *right) {
  const scatter_point *a = left, *b = right;
  return (a->degrees > b->degrees) - (a->degrees < b->degrees);
}

/* How many of the points, which are in order of their angle, lie below an angle, or, with `closed`,
 * not above it. */
static size_t count_below(const scatter_point *points, size_t count, double angle, bool closed) {
  size_t low = 0, high = count;
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    double a = points[middle].degrees;
    if (a < angle || (closed && a <= angle))
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

/* The sample of an interval, of points in order of their angle. */
static compare_sample sample_of(const scatter_point *points, size_t count, int which,
                                const compare_bin *b) {
  size_t first = count_below(points, count, b->from, false);
  size_t end = count_below(points, count, b->to, b->closed);
  compare_sample s = {malloc((end - first + 1) * sizeof *s.values), 0, 0, 0, 0, 0, 0};
  if (!s.values)
    cli_fail("out of memory");
  for (size_t i = first; i < end; i++)
    if (isfinite(points[i].cor[which]))
      s.values[s.count++] = points[i].cor[which];
  describe(&s);
  return s;
}

/* What is told of the sample in a window; its values are not kept. */
static compare_sample sample_in(const cli_window *window) {
  compare_sample s = {NULL, cli_window_count(window), NAN, NAN, NAN, NAN, NAN};
  if (s.count == 0)
    return s;
  cli_window_moments(window, &s.mean, &s.sd);
  if (s.count == 1)
    s.sd = NAN;
  s.median = cli_window_quantile(window, 0.5);
  if (s.count >= BAND_LEAST) {
    s.low = cli_window_quantile(window, 0.05);
    s.high = cli_window_quantile(window, 0.95);
  }
  return s;
}

static double share_within(const compare_sample *s, double low, double high) {
  size_t within = 0;
  for (size_t i = 0; i < s->count; i++)
    within += s->values[i] >= low && s->values[i] <= high;
  return (double)within / (double)s->count;
}

/* The largest distance between two empirical distributions; equal values are passed together. */
static double largest_distance(const compare_sample *a, const compare_sample *b) {
  double most = 0;
  for (size_t i = 0, k = 0; i < a->count && k < b->count;) {
    double x = fmin(a->values[i], b->values[k]);
    while (i < a->count && a->values[i] <= x)
      i++;
    while (k < b->count && b->values[k] <= x)
      k++;
    most = fmax(most, fabs((double)i / (double)a->count - (double)k / (double)b->count));
  }
  return most;
}

/* The probability of such a distance or more when both come from one law: Kolmogorov's limit with
 * Stephens' 1970 term for finite samples. */
static double p_value(double distance, double n, double m) {
  double root = sqrt(n * m / (n + m)), x = (root + 0.12 + 0.11 / root) * distance, p = 0;
  if (x < 0.2)
    return 1; /* to ten digits; the sum would need many terms */
  for (int k = 1; k <= 100; k++) {
    double term = exp(-2.0 * k * k * x * x);
    p += k % 2 ? term : -term;
    if (term < 1e-17)
      break;
  }
  return fmin(1, fmax(0, 2 * p));
}

static void compare_points(compare_bin *b) {
  if (b->model.count == 0 || b->data.count == 0)
    return;
  if (isfinite(b->model.low))
    b->in_band = share_within(&b->data, b->model.low, b->model.high);
  b->distance = largest_distance(&b->model, &b->data);
  b->p = p_value(b->distance, (double)b->model.count, (double)b->data.count);
}

static compare_bin *allocate_bins(size_t count) {
  compare_bin *bins = calloc(count, sizeof *bins);
  if (!bins)
    cli_fail("out of memory");
  for (size_t i = 0; i < count; i++)
    bins[i].in_band = bins[i].distance = bins[i].p = NAN;
  return bins;
}

/* Equal bins over 0 to 90 degrees. */
static compare_bin *bins_of_points(const scatter_impacts *impacts, const scatter_data *data,
                                   int which, double width, size_t count) {
  compare_bin *bins = allocate_bins(count);
  for (size_t i = 0; i < count; i++) {
    compare_bin *b = &bins[i];
    b->from = (double)i * width;
    b->to = fmin(90, b->from + width);
    b->middle = (b->from + b->to) / 2;
    b->closed = b->to >= 90;
    b->data = sample_of(data->points, data->n_points, which, b);
    b->model = sample_of(impacts->points, impacts->count, which, b);
    compare_points(b);
  }
  return bins;
}

typedef struct placed {
  double degrees;
  size_t row;
} placed;

static int by_place(const void *left, const void *right) {
  const placed *a = left, *b = right;
  return (a->degrees > b->degrees) - (a->degrees < b->degrees);
}

/* The rows of means, by their angle. */
static placed *order_of(const scatter_data *data) {
  placed *order = malloc(data->n_means * sizeof *order);
  if (!order)
    cli_fail("out of memory");
  for (size_t i = 0; i < data->n_means; i++)
    order[i] = (placed){data->means[i].degrees, i};
  qsort(order, data->n_means, sizeof *order, by_place);
  return order;
}

/* A bin around each row of means. */
static compare_bin *bins_of_means(const scatter_impacts *impacts, const scatter_data *data,
                                  int which, double width) {
  compare_bin *bins = allocate_bins(data->n_means);
  placed *order = order_of(data);
  cli_window *window = cli_window_create(impacts->points, impacts->count, which);
  for (size_t i = 0; i < data->n_means; i++) {
    const scatter_mean *row = &data->means[order[i].row];
    compare_bin *b = &bins[order[i].row];
    b->middle = row->degrees;
    b->from = fmax(0, b->middle - width / 2);
    b->to = fmin(90, b->middle + width / 2);
    cli_window_move(window, b->from, b->to);
    b->data = (compare_sample){NULL, 0, row->mean[which], row->sd[which], NAN, NAN, NAN};
    b->model = sample_in(window);
  }
  cli_window_free(window);
  free(order);
  return bins;
}

static compare_bin *bins_of(const scatter_impacts *impacts, const scatter_data *data, int which,
                            double width, size_t *count) {
  *count = data->n_means > 0 ? data->n_means : (size_t)ceil(90 / width - 1e-9);
  return data->n_means > 0 ? bins_of_means(impacts, data, which, width)
                           : bins_of_points(impacts, data, which, width, *count);
}

static void free_bins(compare_bin *bins, size_t count) {
  for (size_t i = 0; i < count; i++) {
    free(bins[i].model.values);
    free(bins[i].data.values);
  }
  free(bins);
}

/* A field; nothing where there is no number. */
static void print(FILE *out, double value) {
  if (isfinite(value))
    fprintf(out, ",%.6g", value);
  else
    fputc(',', out);
}

static void print_bin(FILE *out, const compare_bin *b, const char *name) {
  const compare_sample *m = &b->model, *d = &b->data;
  fprintf(out, "%s,%g,%g,%zu", name, b->from, b->to, m->count);
  print(out, m->mean);
  print(out, m->sd);
  print(out, m->median);
  print(out, m->low);
  print(out, m->high);
  print(out, d->values ? (double)d->count : NAN);
  print(out, d->mean);
  print(out, d->sd);
  print(out, d->median);
  print(out, (m->mean - d->mean) / (d->sd > 0 ? d->sd : NAN));
  print(out, b->in_band);
  print(out, b->distance);
  print(out, b->p);
  fputc('\n', out);
}

bool cli_compare_has_data(const compare_bin *b) {
  return isfinite(b->data.mean);
}

/* Warns of bins that have only one of both, and fails where there is none with both. */
static void check_bins(const comparison *c, int which, size_t *both) {
  size_t no_model = 0, with_data = 0;
  for (size_t i = 0; i < c->count; i++) {
    const compare_bin *b = &c->bins[which][i];
    with_data += cli_compare_has_data(b);
    no_model += cli_compare_has_data(b) && b->model.count == 0;
  }
  if (no_model > 0)
    cli_warn("%s: %zu of %zu bins with data are empty of impacts", names[which], no_model,
             with_data);
  *both += with_data - no_model;
}

static const char note[] =
    "# note: deposits are left out. Coefficients and constants that were fitted to measurements "
    "hold "
    "the\n"
    "# roughness of the measured wall already; with a rough wall they count it twice.\n";

/* Whether the comment that the impacts begin with names a fitted law or constant. */
static void warn_double(const scatter_impacts *impacts) {
  static const char *const fitted[] = {"grant_tabakoff", "--rebound table", "rebound table",
                                       "yield-rate", "yield_rate"};
  for (size_t i = 0; impacts->rough && i < sizeof fitted / sizeof *fitted; i++)
    if (strstr(impacts->comment, fitted[i])) {
      cli_warn("the impacts are from a rough wall with '%s', which was fitted to measurements: "
               "roughness is counted twice",
               fitted[i]);
      return;
    }
}

static void print_all(FILE *out, const comparison *c) {
  fputs(note, out);
  fprintf(out, "# %zu rebounds, %zu deposits\n", c->impacts.count, c->impacts.deposits);
  fputs("coefficient,alpha_from_deg,alpha_to_deg,model_n,model_mean,model_sd,model_median,"
        "model_p05,model_p95,data_n,data_mean,data_sd,data_median,mean_difference_in_data_sd,"
        "data_in_model_band,ks_distance,p_value\n",
        out);
  for (int which = 0; which < COR_BOTH; which++)
    for (size_t i = 0; i < c->count; i++)
      print_bin(out, &c->bins[which][i], names[which]);
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [BIN] = {"bin", "DEGREES",
               "width of the bins; without it " WIDTH_POINTS " for points, " WIDTH_MEANS
               " around each mean",
               NULL},
      [OUTPUT] = {"output", "FILE", "write there instead of to the screen", NULL},
      [PLOT] = {"plot", "FILE", "draw both; .png, .svg or .pdf", NULL},
  };
  int first = cli_parse(&cli_compare, argc, argv, options, true);
  if (argc - first != 2)
    cli_bad_usage("compare: IMPACTS and DATA are expected, two files; see 'asperity compare "
                  "--help'");
  comparison c = {.impacts = scatter_read_impacts(argv[first]),
                  .data = scatter_read_data(argv[first + 1])};
  if (!options[BIN].value)
    options[BIN].value = c.data.n_means ? WIDTH_MEANS : WIDTH_POINTS;
  double width = cli_number(&options[BIN], 0.1, 90);
  qsort(c.impacts.points, c.impacts.count, sizeof *c.impacts.points, by_angle);
  if (c.data.n_points > 0)
    qsort(c.data.points, c.data.n_points, sizeof *c.data.points, by_angle);
  size_t both = 0;
  for (int which = 0; which < COR_BOTH; which++) {
    c.bins[which] = bins_of(&c.impacts, &c.data, which, width, &c.count);
    check_bins(&c, which, &both);
  }
  if (both == 0)
    cli_fail("no bin has both impacts and data; the angles do not overlap");
  warn_double(&c.impacts);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, NULL);
  print_all(cli_output_stream(output), &c);
  cli_output_close(output);
  if (options[PLOT].value)
    cli_compare_plot(&options[PLOT], &c);
  for (int which = 0; which < COR_BOTH; which++)
    free_bins(c.bins[which], c.count);
  scatter_free_impacts(&c.impacts);
  scatter_free_data(&c.data);
  return 0;
}

const cli_command cli_compare = {
    .name = "compare",
    .summary = "impacts of a model or a simulation against measured coefficients",
    .detail =
        "asperity compare IMPACTS DATA: IMPACTS is the output of 'asperity cor', the ledger of a\n"
        "wall (CSV or .npy), or a LIGGGHTS dump local file of its array (of its columns alpha1,\n"
        "cor_n, cor_t and outcome; delta_alpha for tilts).\n"
        "DATA is CSV in degrees: points alpha1_deg,cor_n,cor_t, or means and standard deviations\n"
        "alpha1_deg,cor_n_mean,cor_n_sd,cor_t_mean,cor_t_sd; missing fields are left empty. By\n"
        "angle: moments, the model's 5 to 95 % band and the share of the points in it, the\n"
        "two-sample distance of Kolmogorov and Smirnov and its p-value.\n",
    .run = run,
};
