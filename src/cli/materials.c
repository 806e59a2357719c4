/* asperity materials: the presets, with units and sources.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"
#include "rebound/materials.h"

#include <math.h>

static void print_row(FILE *out, const asp_material *m) {
  cli_row(out, "%s,", m->name);
  cli_print_quoted(out, m->title);
  cli_row(out, ",%.10g,%.10g,%.10g,%.10g,", m->youngs_modulus, m->poissons_ratio, m->density,
          m->yield_stress > 0 ? m->yield_stress : NAN);
  cli_print_quoted(out, m->source);
  putc('\n', out);
}

static void run(cli_call *call) {
  FILE *out = cli_output_open(call, "output", NULL);
  fputs("name,title,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa,source\n", out);
  for (int i = 0; i < asp_material_count(); i++)
    print_row(out, asp_material_at(i));
  cli_file_close(out);
}

static const cli_option options[] = {{.name = NULL}};

const cli_command cli_materials = {
    .name = "materials",
    .summary = "the material presets: values, units, sources",
    .detail =
        "One row per material. The yield stress counts for particles; a material without one is\n"
        "meant for walls. The presets' numbers were not checked against the originals of their\n"
        "sources. Your own materials are a file with the same columns, of which title,\n"
        "yield_stress_pa and source may be left out (edit the output of this command); 'materials\n"
        "NAME NAME file FILE' in a description reads it.\n",
    .examples = "  $ asperity materials\n"
                "  $ asperity materials | cut -d, -f1\n",
    .options = options,
    .run = run,
};
