/* The picture of a wall in space: its faces in a buffer of depths, so that what is in front hides
 * what is behind, however large or small the faces are; then pixels and dots for gnuplot.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"
#include "base/units.h"
#include "cli/map.h"
#include "contact/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Largest width and height in pixels; points of the buffer per pixel and direction; and how much of
 * the light has no direction. */
enum { WIDTH = 940, HEIGHT = 640, FINE = 2 };
#define AMBIENT 0.6

/* A dot counts as hidden if a face is in front of it by more than this share of the mesh. */
#define IN_FRONT 0.004

/* The length of the scale is about this share of the picture's width. */
#define SCALE_BAR 0.2

typedef struct picture {
  const cli_map *map;
  double axis[3][3]; /* to the right, up, toward the viewer */
  double light[3];
  int clip;            /* axis */
  double from, to;     /* ends of the clip along that axis */
  double lo[3], hi[3]; /* of what is drawn, along the axes of the picture */
  double scale;        /* points of the buffer per meter */
  int width, height;   /* pixels */
  float *depth;        /* of each point of the buffer */
  int *triangle;       /* -1: none */
} picture;

static double along(const picture *p, int axis, const double x[3]) {
  return aspi_dot(p->axis[axis], x);
}

static void take_view(picture *p, const cli_option *option) {
  double view[2] = {0, 0};
  if (cli_few(option, -360, 360, 2, view) != 2)
    cli_bad_usage("--view is '%s'; it must be AZ,EL in degrees, as -60,30", option->value);
  double az = aspi_radians(view[0]), el = aspi_radians(view[1]);
  const double right[3] = {-sin(az), cos(az), 0};
  const double toward[3] = {cos(el) * cos(az), cos(el) * sin(az), sin(el)};
  aspi_copy(right, p->axis[0]);
  aspi_copy(toward, p->axis[2]);
  aspi_cross(toward, right, p->axis[1]);
  for (int k = 0; k < 3; k++)
    p->light[k] = toward[k] + 0.25 * p->axis[1][k] - 0.2 * right[k];
  aspi_scale(1 / aspi_length(p->light), p->light);
}

static void take_clip(picture *p, const cli_option *option) {
  char *text = cli_copy(option->value), *part[3];
  for (int i = 0; i < 3; i++)
    part[i] = aspi_text_field(&text, ':');
  const char *axis = part[0] ? strstr("x y z", part[0]) : NULL;
  if (!axis || strlen(part[0]) != 1 || !part[1] || !part[2] || text)
    cli_bad_usage("--clip is '%s'; it must be AXIS:FROM:TO, as y:0: or z:-1mm:1mm", option->value);
  p->clip = (int)(axis - "x y z") / 2;
  p->from = -INFINITY;
  p->to = INFINITY;
  for (int i = 1; i < 3; i++)
    if (*part[i])
      cli_must(!aspi_quantity_read("--clip", part[i], "length", &aspi_si,
                                   i == 1 ? &p->from : &p->to, &cli_error));
}

static bool is_drawn(const picture *p, const double x[3]) {
  return x[p->clip] >= p->from && x[p->clip] <= p->to;
}

/* The extent of what is drawn. */
static void measure(picture *p) {
  const aspi_faces *f = p->map->faces;
  for (int k = 0; k < 3; k++) {
    p->lo[k] = INFINITY;
    p->hi[k] = -INFINITY;
  }
  for (size_t i = 0; i < f->triangles; i++) {
    double(*node)[3] = f->triangle[i].node;
    const int c = p->clip;
    if (fmax(node[0][c], fmax(node[1][c], node[2][c])) < p->from ||
        fmin(node[0][c], fmin(node[1][c], node[2][c])) > p->to)
      continue;
    for (int n = 0; n < 3; n++) {
      double x[3] = {node[n][0], node[n][1], node[n][2]};
      x[c] = fmin(p->to, fmax(p->from, x[c]));
      for (int k = 0; k < 3; k++) {
        p->lo[k] = fmin(p->lo[k], along(p, k, x));
        p->hi[k] = fmax(p->hi[k], along(p, k, x));
      }
    }
  }
  if (!(p->hi[0] > p->lo[0] || p->hi[1] > p->lo[1]))
    cli_bad_usage("--clip leaves nothing of the mesh to draw");
  double wide = p->hi[0] - p->lo[0], high = p->hi[1] - p->lo[1];
  double pixels = fmin(WIDTH / wide, HEIGHT / high);
  p->scale = FINE * pixels;
  p->width = (int)(wide * pixels) + 1;
  p->height = (int)(high * pixels) + 1;
}

/* Draws a triangle: each point of the buffer whose middle it covers, and which it is in front of.
 */
static void add_triangle(picture *p, int number) {
  const ContactTriangle *t = &p->map->faces->triangle[number];
  double s[3][3], least[2], most[2]; /* of the corners, in points of the buffer */
  const int size[2] = {p->width * FINE, p->height * FINE};
  for (int c = 0; c < 3; c++)
    for (int k = 0; k < 3; k++)
      s[c][k] = (along(p, k, t->node[c]) - p->lo[k]) * (k < 2 ? p->scale : 1);
  for (int k = 0; k < 2; k++) {
    least[k] = fmax(0, floor(fmin(s[0][k], fmin(s[1][k], s[2][k])) - 0.5));
    most[k] = fmin(size[k] - 1, ceil(fmax(s[0][k], fmax(s[1][k], s[2][k])) - 0.5));
  }
  double b[2] = {s[1][0] - s[0][0], s[1][1] - s[0][1]},
         c[2] = {s[2][0] - s[0][0], s[2][1] - s[0][1]};
  double area = b[0] * c[1] - b[1] * c[0];
  for (int j = (int)least[1]; j <= most[1] && fabs(area) > 0; j++)
    for (int i = (int)least[0]; i <= most[0]; i++) {
      double x = i + 0.5 - s[0][0], y = j + 0.5 - s[0][1];
      double u = (x * c[1] - y * c[0]) / area, v = (y * b[0] - x * b[1]) / area, w = 1 - u - v;
      size_t at = (size_t)j * (size_t)size[0] + (size_t)i;
      double z = w * s[0][2] + u * s[1][2] + v * s[2][2], point[3];
      if (u < 0 || v < 0 || w < 0 || z <= (double)p->depth[at])
        continue;
      for (int k = 0; k < 3; k++)
        point[k] = w * t->node[0][k] + u * t->node[1][k] + v * t->node[2][k];
      if (!is_drawn(p, point))
        continue;
      p->depth[at] = (float)z;
      p->triangle[at] = number;
    }
}

static double brightness(const picture *p, int triangle) {
  double n[3];
  aspi_triangle_normal(&p->map->faces->triangle[triangle], n);
  return AMBIENT + (1 - AMBIENT) * fabs(aspi_dot(n, p->light));
}

/* A row per pixel: its place, the mean value there (0 where there is none), and what is laid
 * over it for shade and for edges: a gray from 0 to 255 and how opaque it is. */
static void print_pixels(FILE *out, const picture *p) {
  for (int j = 0; j < p->height; j++)
    for (int i = 0; i < p->width; i++) {
      double value = 0, bright = 0;
      int valued = 0, covered = 0;
      for (int k = 0; k < FINE * FINE; k++) {
        size_t at = (size_t)(j * FINE + k / FINE) * (size_t)(p->width * FINE) +
                    (size_t)(i * FINE + k % FINE);
        int triangle = p->triangle[at];
        if (triangle < 0)
          continue;
        double of = p->map->value[p->map->faces->face[triangle]];
        covered++;
        bright += brightness(p, triangle);
        valued += isfinite(of);
        value += isfinite(of) ? of : 0;
      }
      double cover = (double)covered / (FINE * FINE);
      double left = bright / (FINE * FINE); /* of the pixel's own color */
      double gray = left < 1 ? 255 * (1 - cover) / (1 - left) : 0;
      fprintf(out, "%d,%d,", i, j);
      cli_print_number(out, valued > 0 ? value / valued : 0, 5);
      fprintf(out, ",%.0f,%.0f\n", gray, 255 * (1 - left));
    }
}

/* The dots that no face hides. */
static size_t print_dots(FILE *out, const picture *p) {
  size_t seen = 0;
  double deep = IN_FRONT * (p->hi[0] - p->lo[0] + p->hi[1] - p->lo[1]);
  for (size_t i = 0; i < p->map->n_deposits; i++) {
    const cli_deposit *d = &p->map->deposits[i];
    double x = (along(p, 0, d->x) - p->lo[0]) * p->scale;
    double y = (along(p, 1, d->x) - p->lo[1]) * p->scale, z = along(p, 2, d->x) - p->lo[2];
    bool inside = x >= 0 && y >= 0 && x < p->width * FINE && y < p->height * FINE;
    size_t at = inside ? (size_t)y * (size_t)(p->width * FINE) + (size_t)x : 0;
    if (!inside || !is_drawn(p, d->x) || z + d->d_p + deep < (double)p->depth[at])
      continue;
    fprintf(out, "%.1f,%.1f,%.6g\n", x / FINE, y / FINE, d->d_p * 1e6);
    seen++;
  }
  return seen;
}

/* The directions of x, y and z, and a length. */
static void print_axes(FILE *out, const picture *p) {
  double longest = SCALE_BAR * p->width * FINE / p->scale;
  double length = pow(10, floor(log10(longest)));
  length *= length * 5 <= longest ? 5 : length * 2 <= longest ? 2 : 1;
  bool meters = length >= 1, millimeters = length >= 1e-3;
  for (int k = 0; k < 3; k++)
    fprintf(out, "%.4f,%.4f,%c\n", p->axis[0][k], p->axis[1][k], "xyz"[k]);
  fprintf(out, "%.2f,0,%g %s\n", length * p->scale / FINE,
          length * (meters        ? 1
                    : millimeters ? 1e3
                                  : 1e6),
          meters        ? "m"
          : millimeters ? "mm"
                        : "µm");
}

void cli_map_draw(const cli_call *call, const cli_map *map) {
  picture p = {.map = map};
  take_view(&p, cli_get(call, "view"));
  take_clip(&p, cli_get(call, "clip"));
  measure(&p);
  size_t n = (size_t)(p.width * FINE) * (size_t)(p.height * FINE);
  p.depth = cli_allocate(n, sizeof *p.depth);
  p.triangle = cli_allocate(n, sizeof *p.triangle);
  for (size_t i = 0; i < n; i++) {
    p.depth[i] = -INFINITY;
    p.triangle[i] = -1;
  }
  for (size_t i = 0; i < map->faces->triangles; i++)
    add_triangle(&p, (int)i);
  FILE *out = cli_plot_open(call);
  const cli_option *most = cli_get(call, "most");
  fprintf(out, "%d,%d,%s,%g\n", p.width, p.height, map->label,
          most->value ? cli_number(most, 1e-300, 1e300) : 0);
  fputs("\n\n", out);
  print_pixels(out, &p);
  fputs("\n\n", out);
  size_t seen = print_dots(out, &p);
  fprintf(out, "nan,nan,nan\n\n\n%zu,%zu,deposits\n\n\n", seen, map->n_deposits);
  print_axes(out, &p);
  free(p.depth);
  free(p.triangle);
  cli_plot_close(call, out, "faces");
}
