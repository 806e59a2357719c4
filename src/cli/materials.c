/* asperity materials: the presets and the user's own, with unit and source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

/* A field in quotes, with quotes inside it doubled. */
static void print_quoted(FILE *out, const char *text) {
  putc('"', out);
  for (; *text; text++) {
    if (*text == '"')
      putc('"', out);
    putc(*text, out);
  }
  putc('"', out);
}

static void print_row(FILE *out, const asp_material *m) {
  cli_print_field(out, asp_material_name(m));
  fputc(',', out);
  print_quoted(out, asp_material_title(m));
  double yield_stress = asp_material_get(m, "yield_stress");
  fprintf(out, ",%.10g,%.10g,%.10g,", asp_material_get(m, "youngs_modulus"),
          asp_material_get(m, "poissons_ratio"), asp_material_get(m, "density"));
  if (yield_stress > 0)
    fprintf(out, "%.10g", yield_stress);
  putc(',', out);
  print_quoted(out, asp_material_source(m));
  putc('\n', out);
}

static asp_materials *own_of(const cli_option *option) {
  if (!option->value)
    return NULL;
  asp_error error;
  asp_materials *own = asp_materials_read(option->value, &error);
  if (!own)
    cli_bad_file(option, &error);
  return own;
}

static int run(int argc, char **argv) {
  enum { MATERIALS, OUTPUT, N };
  cli_option options[N + 1] = {
      [MATERIALS] = {"materials", "FILE", "your own, which go before presets of the same name",
                     NULL},
      [OUTPUT] = {"output", "FILE", "write there instead of to the screen", NULL}};
  cli_parse(&cli_materials, argc, argv, options, false);
  asp_materials *own = own_of(&options[MATERIALS]);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, NULL);
  FILE *out = cli_output_stream(output);
  fputs("name,title,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa,source\n", out);
  for (int i = 0; own && i < asp_materials_count(own); i++)
    print_row(out, asp_materials_at(own, i));
  for (int i = 0; i < asp_material_count(); i++)
    if (asp_materials_find(own, asp_material_name(asp_material_at(i)), NULL) == asp_material_at(i))
      print_row(out, asp_material_at(i));
  cli_output_close(output);
  asp_materials_free(own);
  return 0;
}

const cli_command cli_materials = {
    .name = "materials",
    .summary = "the material presets and your own: values, units, sources",
    .detail =
        "One row a material. The yield stress counts for particles; where it is empty the\n"
        "material is meant for walls. The presets' numbers were not checked against the\n"
        "originals of their sources. Your own materials are a file with the same columns, of\n"
        "which title, yield_stress_pa and source may be left out; edit the output of this\n"
        "command.\n",
    .run = run,
};
