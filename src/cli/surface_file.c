/* asperity surface: how a measured file is read, as the options tell, and what is said of it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"
#include "cli/surface.h"
#include "base/number.h"
#include "base/text.h"
#include "base/units.h"
#include "surface/describe.h"

#include <math.h>
#include <string.h>

/* Meters in a unit, with a number in front if any; 0: not a unit. */
static double unit_of(const char *text) {
  char *end;
  double factor = aspi_number(text, &end);
  return (end > text ? factor : 1) * aspi_unit_meters(end, strlen(end));
}

static void read_unit(const cli_option *option, aspi_profile_options *read) {
  char *text = cli_copy(option->value), *first = aspi_text_field(&text, ','),
       *second = aspi_text_field(&text, ',');
  read->unit_x = unit_of(first);
  read->unit_z = unit_of(second ? second : first);
  if (!(read->unit_x > 0 && read->unit_z > 0))
    cli_bad_usage(
        "--%s is '%s'; units of length are m cm mm um nm in mil, or lengths such as 63nm, "
        "one, or two for positions and heights",
        option->name, option->value);
}

static void read_step(const cli_option *option, aspi_profile_options *read) {
  cli_list steps = cli_lengths(option);
  if (steps.count > 2)
    cli_bad_usage("--%s is '%s'; it must be one length, or two", option->name, option->value);
  read->step[0] = steps.values[0];
  read->step[1] = steps.values[steps.count - 1];
}

static aspi_profile_options read_options(const cli_call *call) {
  aspi_profile_options read = aspi_profile_options_default();
  const cli_option *form = cli_get(call, "form");
  if (cli_value(call, "unit"))
    read_unit(cli_get(call, "unit"), &read);
  if (cli_value(call, "step"))
    read_step(cli_get(call, "step"), &read);
  if (cli_value(call, "missing"))
    read.missing = cli_number(cli_get(call, "missing"), -1e300, 1e300);
  if (cli_value(call, "spikes"))
    read.spikes = cli_number(cli_get(call, "spikes"), 1, 1e6);
  if (cli_value(call, "lambda_s"))
    read.lambda_s = cli_length(cli_get(call, "lambda_s"));
  read.x_column = cli_value(call, "x-column");
  read.column = cli_value(call, "column");
  read.row = (int)cli_whole(cli_get(call, "row"), 1, 1000000);
  read.form = strcmp(form->value, "none") == 0 ? -1 : (int)cli_whole(form, 0, ASP_FORM_MAX);
  read.fill = cli_choice(cli_get(call, "gaps"));
  return read;
}

void cli_surface_describe(FILE *out, const cli_measured *m) {
  const asp_heights_numbers *n = &m->numbers;
  double length = aspi_heights_extent(m->heights).total;
  size_t points = 0, profiles = 0;
  for (const asp_heights *h = m->heights; h; h = h->next, profiles++)
    points += h->columns;
  fputs("# profile ", out);
  cli_print_comment(out, m->name);
  fprintf(out, ": %s\n", m->report.text);
  fprintf(out,
          "# length %.6g um, spacing %.6g um, %zu points; R_q %.6g um, R_a %.6g um, lambda_c (1/e "
          "lag) %.6g um, phi_r %.4g, rms slope %.4g\n",
          length * 1e6, length / (double)points * 1e6, points, n->s_q * 1e6, n->s_a * 1e6,
          n->lambda_1 * 1e6, n->s_q / n->lambda_1, n->s_dq);
  fprintf(out,
          "# %.4g lambda_c long: %s leaves the mean tilt at 2 deg uncertain by about %.2g %% of "
          "sigma\n",
          length / n->lambda_1, profiles > 1 ? "this" : "one such profile",
          100 * ASP_LENGTH_ERROR(length / n->lambda_1));
}

cli_measured cli_surface_read(const cli_call *call, const char *file, bool is_map,
                              const cli_list *sizes) {
  const aspi_profile_options how = read_options(call);
  cli_measured m = {.name = file};
  m.heights = cli_made(aspi_read(NULL, file, is_map, &how, &m.report, &cli_error));
  if (aspi_heights_judge(m.heights, sizes->least, &m.numbers, &cli_error))
    cli_bad_usage("%s: %s", file, cli_error.text);
  aspi_extent extent = aspi_heights_extent(m.heights);
  if (sizes->least < extent.spacing)
    cli_bad_usage("--dp is %gum; the %s's points are %gum apart and do not resolve it",
                  sizes->least * 1e6, aspi_kind_of_rows(m.heights->rows), extent.spacing * 1e6);
  if (*m.report.warnings)
    cli_warn("%s: %s", file, m.report.warnings);
  if (aspi_sampling_check(sizes->least, extent.spacing, extent.length, m.numbers.lambda_2,
                          &cli_error))
    cli_warn("%s: %s", file, cli_error.text);
  return m;
}
