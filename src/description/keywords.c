/* The keywords of a description in one table, which parser, canonical text, messages, help and
 * pages read. Models, laws and their parameters have their own records.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "description/description.h"
#include "base/error.h"
#include "base/units.h"

#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#define AT(member) offsetof(asp_description, member)
#define NUMBER(UNIT, MEMBER) .unit = UNIT, .number = AT(MEMBER)
#define FROM(LEAST, MOST) .least = LEAST, .most = MOST
#define POSITIVE .most = INFINITY, .above = true
#define SCATTER                                                                                    \
  NUMBER("", choice.scatter), FROM(0, 2), .above = true, .fittable = true, .default_value = 0.1
#define WORD(WITHIN, NAME, VALUES, STANDARD, TEXT)                                                 \
  .within = WITHIN, .name = NAME, .values = VALUES, .default_text = STANDARD, .text = TEXT
#define SETS(MEMBER, VALUE) .flag = AT(MEMBER), .sets = VALUE

/* Within what, name, values, default, meaning. */
const aspi_keyword aspi_keywords[] = {
    {WORD("", "surface",
          "smooth | sigma ANGLE [lambda_c L] | rq R lambda_c L [L_along lay DIRECTION] | profile "
          "FILE | map FILE [lay DIRECTION]; for rq R also ra R or sq R, for lambda_c L also rdq S "
          "or rsm L [sampling LR], behind sq sdq S or sal L",
          "smooth", "the roughness of the wall"),
     .printed = ASPI_PRINT},
    {WORD("", "spread", "MODEL", "visible; traced on a measured wall, none on a smooth one",
          "the distribution of the tilt of the face that is hit"),
     .printed = ASPI_PRINT_IF_ROUGH, .needs = ASPI_ROUGH},
    {WORD("", "rebound", "LAW [PARAMETER VALUE]...", "bons", "the velocity after a hit"),
     .printed = ASPI_PRINT, .fittable = true},
    {WORD("", "materials", "NAME...", "",
          "materials of particles and walls: in a script one name for each atom type, in a command "
          "one for the particles and one for the wall"),
     .in_si = true, .needs = ASPI_PAIR},
    {WORD("", "friction", "F", "0.3", "coefficient of friction of all pairs of materials"),
     NUMBER("", friction), FROM(0, INFINITY), .fittable = true, .default_value = NAN,
     .needs = ASPI_NO_MU},
    {WORD("", "surface_energy", "G", "0.8 J/m2",
          "surface energy of all pairs of materials, half of their work of adhesion"),
     NUMBER("energy/area", surface_energy), FROM(0, INFINITY), .fittable = true,
     .default_value = NAN, .needs = ASPI_PAIR | ASPI_STICKS},
    {WORD("", "adhesion", "F", "1; for 'remove' by the size",
          "median of the share of a smooth contact's adhesion with which grains stick, and with "
          "which "
          "they are held against a flow"),
     NUMBER("", choice.flow.adhesion), FROM(0, 1), .above = true, .in_si = true,
     .needs = ASPI_PAIR | ASPI_STICKS},
    {WORD("", "yield_stress", "Y", "the material's", "yield stress of all particles"),
     NUMBER("stress", yield_stress), FROM(0, INFINITY), .fittable = true, .default_value = NAN,
     .needs = ASPI_PAIR | ASPI_NO_RATE},
    {WORD("", "deposit", "freeze | delete | off", "freeze",
          "what the wall does with particles that stick; off: nothing sticks"),
     .printed = ASPI_PRINT, .choice = AT(deposit)},
    {WORD("", "grain", "sphere | lever S", "sphere", "the shape of the grains")},
    {WORD("", "erosion", "LAW [PARAMETER VALUE]... [density RHO] [face mean | tilted]", "none",
          "the mass that impacts wear off the wall"),
     .in_si = true},
    {WORD("", "seed", "N", "1", "seed of the random draws"), NUMBER("", seed),
     FROM(0, 4294967295.0), .default_value = 1, .whole = true, .printed = ASPI_PRINT},
    {WORD("surface", "smooth", "", "", NULL), .after = "", SETS(kind, ASPI_SMOOTH),
     .printed = ASPI_PRINT},
    {WORD("surface", "sigma", "ANGLE", "", "atan of the rms slope, for particles of any size"),
     .after = "", NUMBER("degrees", sigma), FROM(0.001, 54), .fittable = true, .default_value = 5,
     SETS(kind, ASPI_SIGMA)},
    {WORD("surface", "rq", "R", "", "rms height"), .after = "", NUMBER("length", r_q), POSITIVE,
     .fittable = true, SETS(kind, ASPI_GAUSSIAN)},
    {WORD("surface", "lambda_c", "L [L_along]", "",
          "correlation length, at which the autocorrelation is 1/e; with a lay the one across it, "
          "then the one along it; with sigma: sets the face length (default: particle diameter)"),
     .after = "rq ra sq sigma", NUMBER("length", lambda_c), POSITIVE, .fittable = true},
    {WORD("surface", "ra", "R", "", "mean absolute height: R_q = 1.2533 R_a"), .after = "",
     NUMBER("length", r_q), POSITIVE, SETS(kind, ASPI_GAUSSIAN), .printed = ASPI_PRINT_NEVER},
    {WORD("surface", "sq", "R", "", "rms height of an area: the same as rq"), .after = "",
     NUMBER("length", r_q), POSITIVE, SETS(kind, ASPI_GAUSSIAN), .printed = ASPI_PRINT_NEVER},
    {WORD("surface", "rdq", "S", "",
          "rms slope of a profile, or its angle with a unit: lambda_c = 1.4142 R_q/R_dq"),
     .after = "rq ra", NUMBER("", spacing), POSITIVE, .printed = ASPI_PRINT_NEVER},
    {WORD("surface", "rsm", "L [sampling LR]", "",
          "mean width of elements by ISO 4287; depends on the sampling length, so that rdq is "
          "better"),
     .after = "rq ra", NUMBER("length", spacing), POSITIVE, .printed = ASPI_PRINT_NEVER},
    {WORD("surface", "sampling", "LR", "", "sampling length of rsm: the cut-off"), .after = "rsm",
     NUMBER("length", sampling), POSITIVE, .printed = ASPI_PRINT_NEVER},
    {WORD("surface", "sdq", "S", "",
          "rms slope of an area, or its angle with a unit: lambda_c = 2 S_q/S_dq"),
     .after = "sq", NUMBER("", spacing), POSITIVE, .printed = ASPI_PRINT_NEVER},
    {WORD("surface", "sal", "L", "",
          "length at which the autocorrelation is 0.2: lambda_c = 0.7882 S_al"),
     .after = "sq", NUMBER("length", spacing), POSITIVE, .printed = ASPI_PRINT_NEVER},
    {WORD("surface", "profile", "FILE", "", "a measured profile, or several: FILE,FILE,..."),
     .after = "", .string = AT(file), SETS(kind, ASPI_PROFILE)},
    {WORD("surface", "map", "FILE", "", "a measured map"), .after = "", .string = AT(file),
     SETS(kind, ASPI_MAP)},
    {WORD("surface", "lay", "X Y Z | axial | circumferential | ANGLE", "",
          "direction of the lay: a vector along the wall, or an angle from a cylinder's axis"),
     .unit = "degrees", FROM(-180, 180)},
    {WORD("surface", "dp_bins", "N", "16; of a map 6",
          "number of diameters for which a measured wall is prepared"),
     NUMBER("", bins), FROM(1, ASP_BINS_MAX), .whole = true, .needs = ASPI_SIZES},
    {WORD("spread", "plane", "", "", "faces tilt in the plane of incidence only"),
     SETS(choice.isotropic, false), .printed = ASPI_PRINT},
    {WORD("spread", "isotropic", "", "yes", "faces tilt all around"), SETS(choice.isotropic, true),
     .printed = ASPI_PRINT},
    {WORD("spread", "collisions", "single | multiple", "multiple",
          "single: a rebound into the wall is drawn again; multiple: it hits the next face"),
     .choice = AT(choice.multiple), .printed = ASPI_PRINT},
    {WORD("erosion", "density", "RHO", "that of the wall's material", "density of the wall"),
     NUMBER("density", choice.erosion.density), POSITIVE},
    {WORD("erosion", "face", "mean | tilted", "mean",
          "take the impact angle on the mean wall, or on each face that is hit"),
     .choice = AT(choice.erosion.tilted), .printed = ASPI_PRINT},
    {WORD("grain", "sphere", "", "", NULL), .after = "", .printed = ASPI_PRINT_NEVER},
    {WORD("grain", "lever", "S", "",
          "an equivalent sphere whose center of mass is off by N(0, S d_p) per axis, drawn anew "
          "at each impact"),
     .after = "", NUMBER("", choice.lever), FROM(0, 0.5), .above = true, .fittable = true,
     .default_value = 0.05},
    {WORD("yield_stress", "scatter", "S", "0",
          "sd of the logarithm of the yield stress, which each grain has of its own; its median is "
          "the "
          "one given; also behind 'yield_rate'"),
     SCATTER, .needs = ASPI_HAS_YIELD},
    {WORD("rebound", "scatter", "S", "0", NULL), .after = "yield_rate", SCATTER,
     .needs = ASPI_HAS_YIELD},
    {WORD("rebound", "temperature", "T", "that of each particle, where it has one",
          "temperature of the particles"),
     NUMBER("K", choice.heat.temperature), FROM(0, 1e5), .above = true, .fittable = true,
     .default_value = 1300, .needs = ASPI_IS_HOT},
    {WORD("rebound", "soften_modulus", "exp E0 K | table FILE", "no",
          "Young's modulus of particle and wall at the mean of their temperatures"),
     .in_si = true, .needs = ASPI_PAIR},
    {WORD("soften_modulus", "wall_temperature", "T", "", "temperature of the wall"),
     NUMBER("K", choice.heat.wall_temperature), FROM(0, 1e5), .above = true, .needed = true},
    {WORD("materials", "file", "FILE", "",
          "materials of your own, as `asperity materials` prints them"),
     .string = AT(materials_file)},
    {WORD("deposit", "remove", "[u_tau U] gas_density RHO gas_viscosity NU", "no",
          "a flow along the wall takes away what freezes, at the rate of Reeks & Hall 2001"),
     .in_si = true, .needs = ASPI_FREEZES | ASPI_PAIR},
    {WORD("deposit", "viscosity",
          "critical MU vft A B C | critical MU watt SIO2 AL2O3 FE2O3 CAO MGO | critical MU table "
          "FILE",
          "no",
          "an impact sticks with the probability min(1, MU/mu(T)), besides what its law holds"),
     .in_si = true, .needs = ASPI_STICKS},
    {WORD("viscosity", "critical", "MU", "",
          "viscosity from which down all impacts stick; 1e4 Pa s is usual"),
     NUMBER("viscosity", choice.heat.critical), POSITIVE, .needed = true},
    {WORD("remove", "u_tau", "U", "",
          "friction velocity of the flow; needed, but where the flow is computed (OpenFOAM)"),
     NUMBER("speed", choice.flow.u_tau), POSITIVE},
    {WORD("remove", "gas_density", "RHO", "", "density of the gas"),
     NUMBER("density", choice.flow.density), POSITIVE, .needed = true},
    {WORD("remove", "gas_viscosity", "NU", "", "kinematic viscosity of the gas"),
     NUMBER("length2/time", choice.flow.viscosity), POSITIVE, .needed = true},
    {WORD("adhesion", "adhesion_spread", "S", "1",
          "geometric standard deviation of the share; each grain has its own"),
     NUMBER("", choice.flow.spread), FROM(1, INFINITY)},
    {.name = NULL},
};

const aspi_keyword *aspi_keyword_find(const char *name) {
  for (const aspi_keyword *k = aspi_keywords; k->name; k++)
    if (!*k->within && strcmp(k->name, name) == 0)
      return k;
  return NULL;
}

asp_code aspi_keyword_check(const aspi_keyword *k, const char *given, double value,
                            asp_error *error) {
  if (!k->whole)
    return aspi_quantity_check(k->name, given, k->unit, value, k->least, k->most, k->above, error);
  if (value >= k->least && value <= k->most && !(value > floor(value)))
    return ASP_OK;
  return aspi_fail(error, ASP_EARG, "%s is %.15g; it must be a whole number from %.0f to %.0f",
                   k->name, value, k->least, k->most);
}

void aspi_keyword_names(const char *within, char *list, size_t size) {
  for (const aspi_keyword *k = aspi_keywords; k->name; k++)
    if (strcmp(k->within, within) == 0 && k->text)
      aspi_append(list, size, "%s%s", *list ? " " : "", k->name);
}

_Static_assert(sizeof aspi_keywords / sizeof *aspi_keywords <= CHAR_BIT * sizeof(uint64_t),
               "each keyword needs a bit in asp_description.given");
_Static_assert(sizeof(bool) == 1, "flags and choices are bytes");
