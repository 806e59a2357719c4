/* asperity materials: the presets, with unit, source, and whether the original was seen. */
#include "cli/cli.h"

static int run(int argc, char **argv) {
  enum { OUTPUT, N };
  cli_option options[N + 1] = {
      [OUTPUT] = {"output", "FILE", "write there instead of to the screen", NULL}};
  cli_parse(&cli_materials, argc, argv, options, false);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, NULL);
  FILE *out = cli_output_stream(output);
  fputs("name,title,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa,source\n", out);
  for (int i = 0; i < asp_material_count(); i++) {
    const asp_material *m = asp_material_at(i);
    fprintf(out, "%s,\"%s\",%g,%g,%g,", m->name, m->title, m->youngs_modulus, m->poissons_ratio,
            m->density);
    if (m->yield_stress > 0)
      fprintf(out, "%g", m->yield_stress);
    fprintf(out, ",\"%s\"\n", m->source);
  }
  cli_output_close(output);
  return 0;
}

const cli_command cli_materials = {
    .name = "materials",
    .summary = "the material presets: values, units, sources",
    .detail = "One row a material. The yield stress counts for particles; where it is empty the\n"
              "preset is meant for walls. A source says whether the original was seen.\n",
    .run = run,
};
