/* The words of a description, as one table: parser, messages, help and pages are made of it. Models
 * of the tilt, laws and their parameters are records of their own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "description/description.h"
#include "base/error.h"
#include "spread/sizes.h"

#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#define NUMBER(member) offsetof(asp_description, member)

static const asp_keyword keywords[] = {
    {.name = "surface",
     .within = "",
     .values =
         "smooth | sigma ANGLE [lambda_c L] | rq R lambda_c L [L_along lay DIRECTION] | profile "
         "FILE | map "
         "FILE [lay DIRECTION]; for rq R also ra R or sq R, for lambda_c L also rdq S or rsm L "
         "[sampling LR], behind sq sdq S or sal L",
     .standard = "smooth",
     .text = "the roughness of the wall"},
    {.name = "spread",
     .within = "",
     .values = "MODEL",
     .standard = "visible; profile on a measured wall, none on a smooth one",
     .text = "the distribution of the tilt of the face that is hit"},
    {.name = "rebound",
     .within = "",
     .values = "LAW [PARAMETER VALUE]...",
     .standard = "bons",
     .text = "the velocity after a hit"},
    {.name = "materials",
     .within = "",
     .values = "NAME...",
     .standard = "",
     .text = "materials of particles and walls: in a script one name for each atom type, in a "
             "command one for the particles and one for the wall"},
    {.name = "friction",
     .within = "",
     .may_fit = true,
     .values = "F",
     .unit = "",
     .number = NUMBER(friction),
     .most = INFINITY,
     .standard = "0.3",
     .text = "coefficient of friction of all pairs of materials"},
    {.name = "surface_energy",
     .within = "",
     .may_fit = true,
     .values = "G",
     .unit = "energy/area",
     .number = NUMBER(surface_energy),
     .most = INFINITY,
     .standard = "0.8 J/m2",
     .text = "surface energy of all pairs of materials"},
    {.name = "yield_stress",
     .within = "",
     .may_fit = true,
     .values = "Y",
     .unit = "stress",
     .number = NUMBER(yield_stress),
     .most = INFINITY,
     .standard = "the material's",
     .text = "yield stress of all particles"},
    {.name = "deposit",
     .within = "",
     .values = "freeze | delete | off",
     .standard = "freeze",
     .text = "what the wall does with particles that stick; off: nothing sticks"},
    {.name = "grain",
     .within = "",
     .values = "sphere | lever S",
     .standard = "sphere",
     .text = "the shape of the grains"},
    {.name = "erosion",
     .within = "",
     .values = "LAW [PARAMETER VALUE]... [density RHO] [face mean | tilted]",
     .standard = "none",
     .text = "the mass that impacts wear off the wall"},
    {.name = "seed",
     .within = "",
     .values = "N",
     .unit = "",
     .number = NUMBER(seed),
     .fallback = 1,
     .most = 4294967295.0,
     .whole = true,
     .standard = "1",
     .text = "seed of the random draws"},

    {.name = "sigma",
     .within = "surface",
     .may_fit = true,
     .values = "ANGLE",
     .unit = "degrees",
     .number = NUMBER(sigma),
     .least = 0.001,
     .most = 54,
     .standard = "",
     .text = "atan of the rms slope, for particles of any size"},
    {.name = "rq",
     .within = "surface",
     .may_fit = true,
     .values = "R",
     .unit = "length",
     .number = NUMBER(r_q),
     .most = INFINITY,
     .above = true,
     .standard = "",
     .text = "rms height"},
    {.name = "lambda_c",
     .within = "surface",
     .may_fit = true,
     .values = "L [L_along]",
     .unit = "length",
     .number = NUMBER(lambda_c),
     .most = INFINITY,
     .above = true,
     .standard = "",
     .text =
         "correlation length, at which the autocorrelation is 1/e; with a lay the one across it, "
         "then the one along it; behind sigma, that of the faces (as long as the particle)"},
    {.name = "ra",
     .within = "surface",
     .values = "R",
     .unit = "length",
     .most = INFINITY,
     .above = true,
     .standard = "",
     .text = "mean absolute height: R_q = 1.2533 R_a"},
    {.name = "sq",
     .within = "surface",
     .values = "R",
     .unit = "length",
     .most = INFINITY,
     .above = true,
     .standard = "",
     .text = "rms height of an area: the same as rq"},
    {.name = "rdq",
     .within = "surface",
     .values = "S",
     .unit = "",
     .most = INFINITY,
     .above = true,
     .standard = "",
     .text = "rms slope of a profile, or its angle with a unit: lambda_c = 1.4142 R_q/R_dq"},
    {.name = "rsm",
     .within = "surface",
     .values = "L [sampling LR]",
     .unit = "length",
     .most = INFINITY,
     .above = true,
     .standard = "",
     .text = "mean width of elements by ISO 4287; depends on the sampling length, so that rdq is "
             "better"},
    {.name = "sampling",
     .within = "surface",
     .values = "LR",
     .unit = "length",
     .most = INFINITY,
     .above = true,
     .standard = "",
     .text = "sampling length of rsm: the cut-off"},
    {.name = "sdq",
     .within = "surface",
     .values = "S",
     .unit = "",
     .most = INFINITY,
     .above = true,
     .standard = "",
     .text = "rms slope of an area, or its angle with a unit: lambda_c = 2 S_q/S_dq"},
    {.name = "sal",
     .within = "surface",
     .values = "L",
     .unit = "length",
     .most = INFINITY,
     .above = true,
     .standard = "",
     .text = "length at which the autocorrelation is 0.2: lambda_c = 0.7882 S_al"},
    {.name = "profile",
     .within = "surface",
     .values = "FILE",
     .standard = "",
     .text = "a measured profile"},
    {.name = "map",
     .within = "surface",
     .values = "FILE",
     .standard = "",
     .text = "a measured map"},
    {.name = "lay",
     .within = "surface",
     .values = "X Y Z | axial | circumferential | ANGLE",
     .unit = "degrees",
     .least = -180,
     .most = 180,
     .standard = "",
     .text = "direction of the lay: a vector along the wall, or an angle from a cylinder's axis"},
    {.name = "dp_bins",
     .within = "surface",
     .values = "N",
     .unit = "",
     .number = NUMBER(bins),
     .least = 1,
     .most = ASP_BINS_MAX,
     .whole = true,
     .standard = "16; of a map 6",
     .text = "number of diameters for which a measured wall is prepared"},

    {.name = "plane",
     .within = "spread",
     .values = "",
     .standard = "",
     .text = "faces tilt in the plane of incidence only"},
    {.name = "isotropic",
     .within = "spread",
     .values = "",
     .standard = "yes",
     .text = "faces tilt all around"},
    {.name = "collisions",
     .within = "spread",
     .values = "single | multiple",
     .standard = "multiple",
     .text = "single: a rebound into the wall is drawn again; multiple: it hits the next face"},

    {.name = "density",
     .within = "erosion",
     .values = "RHO",
     .unit = "density",
     .number = NUMBER(choice.erosion.density),
     .most = INFINITY,
     .above = true,
     .standard = "that of the wall's material",
     .text = "density of the wall"},
    {.name = "face",
     .within = "erosion",
     .values = "mean | tilted",
     .standard = "mean",
     .text = "take the impact angle on the mean wall, or on each face that is hit"},

    {.name = "lever",
     .within = "grain",
     .may_fit = true,
     .values = "S",
     .unit = "",
     .number = NUMBER(choice.lever),
     .most = 0.5,
     .above = true,
     .standard = "",
     .text = "an equivalent sphere whose center of mass is off by N(0, S d_p) per axis, drawn anew "
             "at each impact"},

    {.name = "scatter_twice",
     .within = "rebound",
     .values = "",
     .standard = "no",
     .text = "allow the law's own scatter on a rough wall"},
    {.name = "file",
     .within = "materials",
     .values = "FILE",
     .standard = "",
     .text = "materials of your own, as `asperity materials` prints them"},
    {.name = "remove",
     .within = "deposit",
     .values = "[u_tau U] gas_density RHO [mean_free_path L] [work W]",
     .standard = "no",
     .text = "a flow along the wall removes particles that would stick"},
    {.name = "u_tau",
     .within = "remove",
     .values = "U",
     .unit = "speed",
     .number = NUMBER(choice.flow.u_tau),
     .most = INFINITY,
     .above = true,
     .standard = "",
     .text = "friction velocity of the flow; needed, but where the flow is computed (OpenFOAM)"},
    {.name = "gas_density",
     .within = "remove",
     .values = "RHO",
     .unit = "density",
     .number = NUMBER(choice.flow.density),
     .most = INFINITY,
     .above = true,
     .standard = "",
     .text = "density of the gas"},
    {.name = "mean_free_path",
     .within = "remove",
     .values = "L",
     .unit = "length",
     .number = NUMBER(choice.flow.mean_free_path),
     .most = INFINITY,
     .standard = "0",
     .text = "mean free path of the gas"},
    {.name = "work",
     .within = "remove",
     .values = "W",
     .unit = "energy/area",
     .number = NUMBER(choice.flow.work),
     .fallback = ASPI_REMOVAL_WORK,
     .most = INFINITY,
     .standard = "0.039 J/m2",
     .text = "work of adhesion"},
};

int aspi_keyword_count(void) {
  return (int)(sizeof keywords / sizeof *keywords);
}

const asp_keyword *asp_keyword_at(int index) {
  return index >= 0 && index < aspi_keyword_count() ? &keywords[index] : NULL;
}

static int index_of(const char *within, const char *name) {
  int i = 0;
  while (strcmp(keywords[i].within, within) != 0 || strcmp(keywords[i].name, name) != 0)
    i++;
  return i;
}

const asp_keyword *aspi_keyword_find(const char *within, const char *name) {
  return &keywords[index_of(within, name)];
}

asp_code aspi_keyword_check(const asp_keyword *k, double value, asp_error *error) {
  if (!k->whole)
    return k->above ? aspi_check_positive(error, k->name, "", value)
                    : aspi_check_range(error, k->name, "", value, k->least, k->most);
  if (value >= k->least && value <= k->most && !(value > floor(value)))
    return ASP_OK;
  return aspi_fail(error, ASP_EARG, "%s is %.15g; it must be a whole number from %.0f to %.0f",
                   k->name, value, k->least, k->most);
}

void aspi_keyword_names(const char *within, char *list, size_t size) {
  *list = '\0';
  for (int i = 0; i < aspi_keyword_count(); i++) {
    size_t used = strlen(list);
    if (strcmp(keywords[i].within, within) == 0)
      snprintf(list + used, size - used, "%s%s", used ? " " : "", keywords[i].name);
  }
}

_Static_assert(sizeof keywords / sizeof *keywords <= CHAR_BIT * sizeof(uint64_t),
               "each keyword needs a bit in asp_description.given");
