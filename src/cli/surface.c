/* asperity surface: what a particle of a given size finds on a wall. */
#include "cli/cli.h"

#include <math.h>

static void print_row(FILE *out, const asp_surface *surface, double d_p) {
  double slope = asp_surface_slope(surface, d_p);
  fprintf(out, "%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,0,%.6g,,\n", d_p * 1e6,
          asp_surface_r_q(surface) * 1e6, asp_surface_lambda_c(surface) * 1e6,
          asp_surface_phi_r(surface), asp_surface_kappa(surface, d_p), slope,
          cli_degrees(atan(slope)));
}

static int run(int argc, char **argv) {
  enum { RQ, LAMBDA_C, DP, OUTPUT, N };
  cli_option options[N + 1] = {
      [RQ] = {"rq", "LENGTH", "rms height of the wall", NULL},
      [LAMBDA_C] = {"lambda-c", "LENGTH", "correlation length: autocorrelation 1/e", NULL},
      [DP] = {"dp", "LENGTHS", "particle diameters: a list or from:to:step", "10um"},
      [OUTPUT] = {"output", "FILE", "write there instead of to the screen", NULL},
  };
  cli_parse(&cli_surface, argc, argv, options, false);
  asp_error error;
  asp_surface *surface =
      asp_surface_create(cli_length(&options[RQ]), cli_length(&options[LAMBDA_C]), &error);
  if (!surface)
    cli_bad_input("%s", error.text);
  cli_list sizes = cli_lengths(&options[DP]);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, NULL);
  FILE *out = cli_output_stream(output);
  fputs("dp_um,rq_um,lambda_c_um,phi_r,kappa,slope_rms,angle_mean_deg,angle_sd_deg,angle_kurtosis,"
        "kl_normal\n",
        out);
  for (size_t i = 0; i < sizes.count; i++)
    print_row(out, surface, sizes.values[i]);
  cli_output_close(output);
  asp_surface_free(surface);
  return 0;
}

const cli_command cli_surface = {
    .name = "surface",
    .summary = "which slopes a particle of a given size finds on a wall",
    .detail = "A row per diameter, by the closed form for a Gaussian profile closed by a disc.\n",
    .run = run,
};
