/* Pictures by gnuplot, all from one template: a title, panels in a row or a grid, and in each panel
 * series of rows. Ranges of the axes, keys and what the frame cuts off are the template's business;
 * colors and marks come from examples/look.gp, by name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_PLOT_H
#define ASP_CLI_PLOT_H

#include "cli/cli.h"

typedef struct cli_plot cli_plot;

/* Opens the picture of --plot, of `width` x `height` pixels or of --size if given. The layout is
 * "rows,columns" of panels; NULL if the panels are placed by cli_plot_place. --title replaces the
 * title, which is broken into lines that fit. */
CLI_FORMAT(5, 6)
cli_plot *cli_plot_open(const cli_call *call, int width, int height, const char *layout,
                        const char *title, ...);
/* Draws the picture, and prints its path on stderr. */
void cli_plot_close(cli_plot *plot);

/* A user's text as gnuplot shows it letter by letter, cut after some 300 bytes. Every text in a
 * title or a key that is not a constant of this program must go through it. */
typedef struct cli_label {
  char text[1600];
} cli_label;
cli_label cli_plot_label(const char *text);
/* A number of three digits, with a power of ten where it is far from 1. */
cli_label cli_plot_number(double value);
/* The name of a file in words: without folders and ending. */
cli_label cli_plot_file(const char *path);

/* A wall in numbers: its file's name, R_q, lambda_c and Phi_R, or sigma. */
cli_label cli_plot_wall(const asp_description *words, const asp_wall *wall);

/* Begins a panel; both labels may hold gnuplot's markup. */
void cli_plot_panel(cli_plot *plot, const char *x, const char *y);
/* A panel of CoR_N (t 0) or CoR_T (t 1) over the impact angle. The axis shows 0 to 1, and of what
 * lies beyond at most 0 to 3 or -1 to 2: ratios to a vanishing component have no bounds. */
void cli_plot_coefficient(cli_plot *plot, int t);

/* Settings of a panel before its series: its place, in shares of the picture; a caption. */
void cli_plot_place(cli_plot *plot, double left, double bottom, double width, double height);
CLI_FORMAT(2, 3) void cli_plot_caption(cli_plot *plot, const char *format, ...);
/* Ends of an axis, 'x' or 'y'; NAN: as the series have it. */
void cli_plot_axis(cli_plot *plot, char axis, double from, double to);
void cli_plot_log(cli_plot *plot, const char *axes);
/* A panel with ranges of its own, also with --range; `equal`: one scale for both axes. */
void cli_plot_scale(cli_plot *plot, bool equal);
/* For gnuplot's own commands, between series only. */
FILE *cli_plot_stream(cli_plot *plot);

/* Shape that is drawn for each row. */
typedef enum cli_shape {
  CLI_LINE,   /* x, y */
  CLI_HISTO,  /* x, y: steps about each x */
  CLI_STAIRS, /* x, y: steps from each x */
  CLI_BARS,   /* x, y */
  CLI_MARKS,  /* x, y */
  CLI_ERRORS, /* x, y, sd */
  CLI_BAND,   /* x, y, sd: a line in a band */
  CLI_BOX,    /* left, right, y, sd: a level in a box */
  CLI_CELLS,  /* left, right, low, high, value of the palette */
  CLI_IMAGE   /* x, y, value of the palette */
} cli_shape;

/* Begins a series in a style of look.gp, or in one of 1 to 6. Rows that are no numbers are gaps. It
 * ends with its name in the key; a series without rows has only that. */
CLI_FORMAT(3, 4)
void cli_plot_series(cli_plot *plot, cli_shape shape, const char *style, ...);
void cli_plot_put(cli_plot *plot, const double *row);
#define cli_plot_row(plot, ...) cli_plot_put(plot, (double[5]){__VA_ARGS__})
CLI_FORMAT(2, 3) void cli_plot_end(cli_plot *plot, const char *name, ...);

#endif
