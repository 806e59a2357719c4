/* Pictures by gnuplot: a pipe to it, a terminal chosen by the file's ending, and one template for
 * all; see plot.h. Nothing that a user wrote reaches gnuplot as a command: it draws to its standard
 * output, which is the file, so that it gets no path; it reads no start-up files; and texts go
 * through cli_plot_label.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/plot.h"
#include "base/number.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

enum { LABEL_MOST = 300, TITLE_MOST = 2000, SIDE_LEAST = 100, SIDE_MOST = 10000 };

/* Mean width of a letter of a title in pixels, and the share of the range beyond the outermost
 * mark. */
#define LETTER 8.0
#define ROOM 0.04

/* examples/look.gp, line by line. */
static const char *const look[] = {
#include "look.inc"
};

/* An axis: ends that are given, the range of the rows, and the bounds of that. */
typedef struct axis {
  double from, to, low, high, least, most;
  bool log;
} axis;

struct cli_plot {
  FILE *pipe, *file;
  const char *path;
  double range[2]; /* of --range; NAN: not given */
  int series;      /* of the picture so far */
  /* The panel. */
  bool has_panel, own_range, equal;
  axis x, y;
  FILE *command; /* its plot command, as it grows */
  char *text;
  size_t size;
  char caption[TITLE_MOST];
  /* The series. */
  cli_shape shape;
  char style[80];
  size_t rows, outside;
};

/* Reads --size and --range. */
static void read_look(const cli_call *call, cli_plot *plot, int size[2]) {
  const char *sides = cli_value(call, "size"), *range = cli_value(call, "range");
  char end;
  plot->range[0] = plot->range[1] = NAN;
  if (sides && (sscanf(sides, "%5dx%5d%c", &size[0], &size[1], &end) != 2 || size[0] < SIDE_LEAST ||
                size[1] < SIDE_LEAST || size[0] > SIDE_MOST || size[1] > SIDE_MOST))
    cli_bad_usage("--size is '%s'; it must be WIDTHxHEIGHT, each %d to %d pixels", sides,
                  SIDE_LEAST, SIDE_MOST);
  if (!range)
    return;
  char *colon, *last = NULL;
  plot->range[0] = aspi_number(range, &colon);
  plot->range[1] = *colon == ':' ? aspi_number(colon + 1, &last) : NAN;
  if (!last || *last || last == colon + 1 || !(plot->range[0] < plot->range[1]))
    cli_bad_usage("--range is '%s'; it must be FROM:TO, with FROM < TO", range);
}

static const char *terminal_of(const char *path) {
  const char *ending = strrchr(path, '.');
  if (ending && strcasecmp(ending, ".png") == 0)
    return "pngcairo size %d,%d font 'sans,11'";
  if (ending && strcasecmp(ending, ".svg") == 0)
    return "svg size %d,%d font 'sans,14' background 'white'";
  if (ending && strcasecmp(ending, ".pdf") == 0)
    return "pdfcairo size %d/96.,%d/96. font 'sans,11'";
  cli_bad_usage("--plot is '%s'; the file must end in .png, .svg or .pdf", path);
}

/* A gnuplot that reads from the returned stream and writes to a file. */
static FILE *start(int file) {
  fflush(NULL);
  int out = dup(STDOUT_FILENO);
  FILE *stream = dup2(file, STDOUT_FILENO) < 0 ? NULL : popen("exec gnuplot -d", "w");
  if (!stream || dup2(out, STDOUT_FILENO) < 0)
    cli_fail("cannot start gnuplot: %s", strerror(errno));
  close(out);
  return stream;
}

void cli_plot_check(const cli_call *call) {
  cli_plot plot;
  terminal_of(cli_value(call, "plot"));
  read_look(call, &plot, (int[2]){0, 0});
  cli_file_check(cli_value(call, "plot"));
  if (system("exec gnuplot --version > /dev/null 2>&1") != 0)
    cli_fail("cannot run gnuplot; is it installed? Debian: apt-get install gnuplot-nox");
}

/* Writes a title as a gnuplot string, broken behind semicolons into lines of at most `letters`
 * letters; longer clauses at spaces. */
static void put_title(FILE *out, const char *text, double letters) {
  double used = 0;
  fputc('\'', out);
  for (const char *word = text; *word;) {
    size_t clause = strcspn(word, ";") + 1;
    size_t length = (double)clause <= letters ? clause : strcspn(word, " ");
    length = length < strlen(word) ? length : strlen(word);
    if (used > 0 && used + (double)length > letters) {
      fputs("'.\"\\n\".'", out);
      used = 0;
    }
    fprintf(out, "%s%.*s", used > 0 ? " " : "", (int)length, word);
    used += (double)length + 1;
    word += length + (word[length] == ' ');
  }
  fputs("'.\"\\n\"", out); /* some room above the keys */
}

cli_plot *cli_plot_open(const cli_call *call, int width, int height, const char *layout,
                        const char *format, ...) {
  cli_plot *plot = cli_allocate(1, sizeof *plot);
  plot->path = cli_value(call, "plot");
  const char *terminal = terminal_of(plot->path), *own = cli_value(call, "title");
  int size[2] = {width, height};
  read_look(call, plot, size);
  plot->file = cli_file_open(plot->path);
  signal(SIGPIPE, SIG_IGN);
  plot->pipe = start(fileno(plot->file));
  fputs("set term ", plot->pipe);
  fprintf(plot->pipe, terminal, size[0], size[1]);
  fputc('\n', plot->pipe);
  for (size_t i = 0; i < sizeof look / sizeof *look; i++)
    fputs(look[i], plot->pipe);
  char title[TITLE_MOST];
  va_list args;
  va_start(args, format);
  vsnprintf(title, sizeof title, format, args);
  va_end(args);
  if (own)
    strcpy(title, cli_plot_label(own).text);
  fprintf(plot->pipe, "set multiplot %s%s title ", layout ? "layout " : "", layout ? layout : "");
  put_title(plot->pipe, title, size[0] / LETTER);
  fputc('\n', plot->pipe);
  return plot;
}

/* ---- panels ---- */

static axis new_axis(void) {
  return (axis){NAN, NAN, INFINITY, -INFINITY, -INFINITY, INFINITY, false};
}

/* Prints the range of an axis: its given ends, or those of the rows with some room. */
static void put_axis(const cli_plot *plot, char name, const axis *a) {
  double low = fmax(a->low, a->least), high = fmin(a->high, a->most);
  if (!(low <= high))
    low = a->log ? 1 : 0, high = a->log ? 10 : 1;
  double room = ROOM * (high - low), factor = a->log ? pow(high / low, ROOM) : 1;
  if (low == high) {
    room = fabs(low) > 0 ? 0.1 * fabs(low) : 1;
    factor = 2;
  }
  low = isfinite(a->from) ? a->from : a->log ? low / factor : low - room;
  high = isfinite(a->to) ? a->to : a->log ? high * factor : high + room;
  if (a->log)
    fprintf(plot->pipe, "set logscale %c\n", name);
  fprintf(plot->pipe, "set %crange [%.10g:%.10g]\n", name, low, high);
}

static void finish_panel(cli_plot *plot) {
  if (!plot->has_panel)
    return;
  plot->has_panel = false;
  put_axis(plot, 'x', &plot->x);
  put_axis(plot, 'y', &plot->y);
  if (plot->equal)
    fputs("set size ratio -1\n", plot->pipe);
  fclose(plot->command);
  fprintf(plot->pipe, "set title '%s'\nplot NaN notitle%s\n", plot->caption, plot->text);
  free(plot->text);
}

void cli_plot_panel(cli_plot *plot, const char *x, const char *y) {
  finish_panel(plot);
  plot->has_panel = true;
  plot->own_range = plot->equal = false;
  plot->x = plot->y = new_axis();
  if (plot->range[0] < plot->range[1]) {
    plot->y.from = plot->y.least = plot->range[0];
    plot->y.to = plot->y.most = plot->range[1];
  }
  plot->command = open_memstream(&plot->text, &plot->size);
  if (!plot->command)
    cli_fail("out of memory");
  *plot->caption = '\0';
  fprintf(plot->pipe,
          "unset logscale\nunset arrow\nunset object\nunset label\nset size noratio\n"
          "set xtics autofreq\nset format '%%g'\nset xlabel '%s'\nset ylabel '%s'\n",
          x, y);
}

void cli_plot_coefficient(cli_plot *plot, int t) {
  cli_plot_panel(plot, "impact angle α_1 / degrees", t ? "CoR_T" : "CoR_N");
  cli_plot_axis(plot, 'x', -3, 93);
  fputs("set xtics 15\n", plot->pipe);
  plot->y.low = 0;
  plot->y.high = 1;
  if (isnan(plot->y.from)) {
    plot->y.least = t ? -1 : 0;
    plot->y.most = t ? 2 : 3;
  }
}

void cli_plot_place(cli_plot *plot, double left, double bottom, double width, double height) {
  fprintf(plot->pipe, "set origin %g,%g\nset size %g,%g\n", left, bottom, width, height);
}

void cli_plot_caption(cli_plot *plot, const char *format, ...) {
  va_list args;
  va_start(args, format);
  vsnprintf(plot->caption, sizeof plot->caption, format, args);
  va_end(args);
}

void cli_plot_axis(cli_plot *plot, char name, double from, double to) {
  axis *a = name == 'x' ? &plot->x : &plot->y;
  if (name == 'y' && plot->range[0] < plot->range[1] && !plot->own_range)
    return;
  a->from = from;
  a->to = to;
  a->least = isfinite(from) ? from : -INFINITY;
  a->most = isfinite(to) ? to : INFINITY;
}

void cli_plot_log(cli_plot *plot, const char *axes) {
  plot->x.log = strchr(axes, 'x');
  plot->y.log = strchr(axes, 'y');
}

void cli_plot_scale(cli_plot *plot, bool equal) {
  plot->own_range = true;
  plot->equal = equal;
  plot->y = new_axis();
}

FILE *cli_plot_stream(cli_plot *plot) {
  return plot->pipe;
}

/* ---- series ---- */

/* gnuplot's style for each shape, and the one drawn under it without a name; then the columns of a
 * row that hold its extent: left, right, y, low, high. Low and high are y - sd and y + sd if the
 * caller's row has an sd at `low`. */
static const struct {
  int columns;
  const char *draw, *under;
  int left, right, y, low, high;
} shapes[] = {
    [CLI_LINE] = {2, "1:2 with lines ls %s", "", 0, 0, 1, 1, 1},
    [CLI_HISTO] = {2, "1:2 with histeps ls %s", "", 0, 0, 1, 1, 1},
    [CLI_STAIRS] = {2, "1:2 with steps ls %s", "", 0, 0, 1, 1, 1},
    [CLI_BARS] = {2, "1:2 with boxes ls %s fs solid 0.35 noborder", "", 0, 0, 1, 1, 1},
    [CLI_MARKS] = {2, "1:2 with points ls %s", "", 0, 0, 1, 1, 1},
    [CLI_ERRORS] = {4, "1:2:3:4 with yerrorbars ls %s dt 1", "", 0, 0, 1, 2, 3},
    [CLI_BAND] = {4, "1:2 with lines ls %s",
                  "1:3:4 with filledcurves ls %s fs transparent solid 0.2 noborder", 0, 0, 1, 2, 3},
    [CLI_BOX] = {5, "1:3:($2-$1):(0) with vectors nohead ls %s",
                 "1:3:1:2:4:5 with boxxyerror ls %s fs transparent solid 0.25 noborder", 0, 1, 2, 3,
                 4},
    [CLI_CELLS] = {5, "1:3:1:2:3:4:5 with boxxyerror fs solid noborder lc %s", "", 0, 1, 2, 2, 3},
    [CLI_IMAGE] = {3, "1:2:3 with image", "", 0, 0, 1, 1, 1},
};

void cli_plot_series(cli_plot *plot, cli_shape shape, const char *style, ...) {
  va_list args;
  va_start(args, style);
  vsnprintf(plot->style, sizeof plot->style, style, args);
  va_end(args);
  plot->shape = shape;
  plot->rows = plot->outside = 0;
  fprintf(plot->pipe, "$s%d << EOD\n", plot->series);
}

static void widen(axis *a, double low, double high) {
  if (!(a->log && !(low > 0)))
    a->low = fmin(a->low, low);
  a->high = fmax(a->high, high);
}

void cli_plot_put(cli_plot *plot, const double *row) {
  cli_shape shape = plot->shape;
  double all[5];
  memcpy(all, row, sizeof all);
  int low = shapes[shape].low, high = shapes[shape].high;
  double y = row[shapes[shape].y];
  if (shape == CLI_ERRORS || shape == CLI_BAND || shape == CLI_BOX) {
    double sd = isfinite(row[low]) ? row[low] : 0;
    all[low] = plot->y.log ? fmax(y - sd, plot->y.least) : y - sd;
    all[high] = y + sd;
  }
  bool whole = true;
  for (int i = 0; i < shapes[shape].columns; i++) {
    whole = whole && isfinite(all[i]);
    fprintf(plot->pipe, "%.8g ", all[i]);
  }
  fputc('\n', plot->pipe);
  if (!whole)
    return;
  plot->rows++;
  plot->outside += y < plot->y.least || y > plot->y.most;
  widen(&plot->x, all[shapes[shape].left], all[shapes[shape].right]);
  widen(&plot->y, all[low], all[high]);
}

/* Marks that the frame cuts off are counted in the caption. */
static void count_outside(cli_plot *plot, const char *name) {
  size_t used = strlen(plot->caption);
  if (plot->outside > 0 && (plot->shape == CLI_MARKS || plot->shape == CLI_ERRORS))
    snprintf(plot->caption + used, sizeof plot->caption - used, "%s{/=9 outside: %zu of %zu %s}",
             used ? "; " : "", plot->outside, plot->rows, name);
}

void cli_plot_end(cli_plot *plot, const char *format, ...) {
  char name[TITLE_MOST];
  va_list args;
  va_start(args, format);
  vsnprintf(name, sizeof name, format, args);
  va_end(args);
  fprintf(plot->pipe, "%sEOD\n", plot->rows ? "" : "NaN NaN NaN NaN NaN\n");
  count_outside(plot, name);
  int number = plot->series++;
  if (plot->rows == 0 && !*name)
    return;
  const char *draw = shapes[plot->shape].draw, *under = shapes[plot->shape].under;
  if (plot->rows > 0 && *under) {
    fprintf(plot->command, ", $s%d using ", number);
    fprintf(plot->command, under, plot->style);
    fputs(" notitle", plot->command);
  }
  if (plot->rows > 0)
    fprintf(plot->command, ", $s%d using ", number);
  else
    fputs(", keyentry", plot->command);
  fprintf(plot->command, plot->rows > 0 ? draw : strchr(draw, ' '), plot->style);
  fprintf(plot->command, *name ? " title '%s'" : " notitle", name);
}

void cli_plot_close(cli_plot *plot) {
  finish_panel(plot);
  fputs("unset multiplot\n", plot->pipe);
  if (pclose(plot->pipe) != 0)
    cli_fail("gnuplot failed; no picture '%s' is drawn", plot->path);
  cli_file_close(plot->file);
  fprintf(stderr, "picture: %s\n", plot->path);
  free(plot);
}

/* ---- texts ---- */

/* The bytes of the UTF-8 character that a text begins with; 0 where it is none. */
static size_t character_length(const char *text) {
  const unsigned char *c = (const unsigned char *)text;
  size_t length = *c < 0x80 ? 1 : *c >= 0xc2 && *c < 0xe0 ? 2 : (*c & 0xf0) == 0xe0 ? 3 : 4;
  if (length == 4 && !(*c >= 0xf0 && *c < 0xf5))
    return 0;
  for (size_t i = 1; i < length; i++)
    if ((c[i] & 0xc0) != 0x80)
      return 0;
  return length;
}

/* Replacement of a character in a string of gnuplot's enhanced text in single quotes: its marks get
 * a backslash; quotes are written by their codes, so that no text can end the string. */
static const char *replacement(char c) {
  static const struct {
    char from;
    const char *to;
  } list[] = {{'\'', "\\047"}, {'`', "\\140"}, {'\\', "\\\\"}, {'^', "\\^"}, {'_', "\\_"},
              {'{', "\\{"},    {'}', "\\}"},   {'@', "\\@"},   {'~', "\\~"}, {'&', "\\046"}};
  for (size_t i = 0; i < sizeof list / sizeof *list; i++)
    if (list[i].from == c)
      return list[i].to;
  return NULL;
}

cli_label cli_plot_label(const char *text) {
  cli_label label = {""};
  char *out = label.text;
  const char *end = text + strlen(text), *cut = end - text > LABEL_MOST ? text + LABEL_MOST : end;
  while (text < cut) {
    size_t length = character_length(text);
    bool control = length == 1 && ((unsigned char)*text < 0x20 || *text == 0x7f);
    const char *other = length == 0 ? "?" : control ? " " : replacement(*text);
    length += length == 0;
    size_t put = other ? strlen(other) : length;
    memcpy(out, other ? other : text, put);
    out += put;
    text += length;
  }
  strcpy(out, text < end ? "..." : "");
  return label;
}

cli_label cli_plot_number(double value) {
  cli_label label;
  int exponent = fabs(value) > 0 ? (int)floor(log10(fabs(value))) : 0;
  if (exponent >= -3 && exponent < 6)
    snprintf(label.text, sizeof label.text, "%.3g", value);
  else
    snprintf(label.text, sizeof label.text, "%.3g·10^{%d}", value / pow(10, exponent), exponent);
  return label;
}

cli_label cli_plot_file(const char *path) {
  const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
  char *words = cli_copy(name), *ending = strrchr(words, '.');
  if (ending && ending > words)
    *ending = '\0';
  for (char *c = words; *c; c++)
    if (*c == '_')
      *c = ' ';
  cli_label label = cli_plot_label(words);
  free(words);
  return label;
}

cli_label cli_plot_wall(const asp_description *words, const asp_wall *wall) {
  const asp_surface *surface = asp_wall_surface(wall);
  const char *file = asp_description_word(words, "file");
  cli_label label = {"smooth wall"};
  if (surface && strcmp(asp_description_word(words, "surface"), "sigma") == 0)
    snprintf(label.text, sizeof label.text, "σ = %.4g°",
             cli_degrees(atan(asp_surface_slope_rms(surface))));
  else if (surface)
    snprintf(label.text, sizeof label.text, "%.1400s%sR_q = %.3g µm, λ_c = %.3g µm, Φ_R = %.3g",
             file ? cli_plot_file(file).text : "", file ? ", " : "", asp_surface_r_q(surface) * 1e6,
             asp_surface_lambda_c(surface) * 1e6, asp_surface_phi_r(surface));
  return label;
}
