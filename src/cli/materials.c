/* asperity materials: the presets and the user's own, with unit and source.
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
  const char *path = cli_value(call, "materials");
  asp_error error;
  aspi_materials *own = path ? aspi_materials_read(path, &error) : NULL;
  if (path && !own)
    cli_bad_usage("--materials: %s", error.text);
  FILE *out = cli_output_open(call, "output", NULL);
  fputs("name,title,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa,source\n", out);
  for (int i = 0; own && i < aspi_materials_count(own); i++)
    print_row(out, aspi_materials_at(own, i));
  for (int i = 0; i < asp_material_count(); i++)
    if (aspi_materials_find(own, asp_material_name(asp_material_at(i)), NULL) == asp_material_at(i))
      print_row(out, asp_material_at(i));
  cli_file_close(out);
}

static const cli_option options[] = {
    {"materials", "FILE", "file of your own materials; they override presets of the same name",
     NULL},
    {.name = NULL}};

const cli_command cli_materials = {
    .name = "materials",
    .summary = "the material presets and your own: values, units, sources",
    .detail =
        "One row per material. The yield stress counts for particles; a material without one is\n"
        "meant for walls. The presets' numbers were not checked against the originals of their\n"
        "sources. Your own materials are a file with the same columns, of which title,\n"
        "yield_stress_pa and source may be left out; edit the output of this command.\n",
    .examples = "  $ asperity materials\n"
                "  $ asperity materials | cut -d, -f1\n",
    .options = options,
    .run = run,
};
