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

/* A word with its values, its default and its meaning; a choice of two words, or a word of its own,
 * that sets a flag; a number with its unit, place and range. The place is 0 for a number that
 * becomes another one. */
#define WORD(WITHIN, NAME, VALUES, STANDARD, TEXT)                                                 \
  { .within = WITHIN, .name = NAME, .values = VALUES, .standard = STANDARD, .text = TEXT }
#define FLAG(WITHIN, NAME, VALUES, MEMBER, STANDARD, TEXT)                                         \
  {                                                                                                \
    .within = WITHIN, .name = NAME, .values = VALUES, .standard = STANDARD, .text = TEXT,          \
    .flag = offsetof(asp_description, MEMBER)                                                      \
  }
#define NUMBER(WITHIN, NAME, VALUES, UNIT, PLACE, STANDARD, TEXT, ...)                             \
  {                                                                                                \
    .within = WITHIN, .name = NAME, .values = VALUES, .unit = UNIT, .standard = STANDARD,          \
    .text = TEXT, .number = PLACE, __VA_ARGS__                                                     \
  }
#define AT(member) offsetof(asp_description, member)
#define NOWHERE 0
#define FROM(LEAST, MOST) .least = LEAST, .most = MOST
#define POSITIVE .most = INFINITY, .above = true

static const asp_keyword keywords[] = {
    WORD("", "surface",
         "smooth | sigma ANGLE [lambda_c L] | rq R lambda_c L [L_along lay DIRECTION] | profile "
         "FILE | map FILE [lay DIRECTION]; for rq R also ra R or sq R, for lambda_c L also rdq S "
         "or rsm L [sampling LR], behind sq sdq S or sal L",
         "smooth", "the roughness of the wall"),
    WORD("", "spread", "MODEL", "visible; profile on a measured wall, none on a smooth one",
         "the distribution of the tilt of the face that is hit"),
    WORD("", "rebound", "LAW [PARAMETER VALUE]...", "bons", "the velocity after a hit"),
    WORD("", "materials", "NAME...", "",
         "materials of particles and walls: in a script one name for each atom type, in a command "
         "one for the particles and one for the wall"),
    NUMBER("", "friction", "F", "", AT(friction), "0.3",
           "coefficient of friction of all pairs of materials", FROM(0, INFINITY), .may_fit = true),
    NUMBER("", "surface_energy", "G", "energy/area", AT(surface_energy), "0.8 J/m2",
           "surface energy of all pairs of materials", FROM(0, INFINITY), .may_fit = true),
    NUMBER("", "yield_stress", "Y", "stress", AT(yield_stress), "the material's",
           "yield stress of all particles", FROM(0, INFINITY), .may_fit = true),
    WORD("", "deposit", "freeze | delete | off", "freeze",
         "what the wall does with particles that stick; off: nothing sticks"),
    WORD("", "grain", "sphere | lever S", "sphere", "the shape of the grains"),
    WORD("", "erosion", "LAW [PARAMETER VALUE]... [density RHO] [face mean | tilted]", "none",
         "the mass that impacts wear off the wall"),
    NUMBER("", "seed", "N", "", AT(seed), "1", "seed of the random draws", FROM(0, 4294967295.0),
           .fallback = 1, .whole = true),
    NUMBER("surface", "sigma", "ANGLE", "degrees", AT(sigma), "",
           "atan of the rms slope, for particles of any size", FROM(0.001, 54), .may_fit = true),
    NUMBER("surface", "rq", "R", "length", AT(r_q), "", "rms height", POSITIVE, .may_fit = true),
    NUMBER("surface", "lambda_c", "L [L_along]", "length", AT(lambda_c), "",
           "correlation length, at which the autocorrelation is 1/e; with a lay the one across it, "
           "then the one along it; behind sigma, that of the faces (as long as the particle)",
           POSITIVE, .may_fit = true),
    NUMBER("surface", "ra", "R", "length", NOWHERE, "", "mean absolute height: R_q = 1.2533 R_a",
           POSITIVE),
    NUMBER("surface", "sq", "R", "length", NOWHERE, "", "rms height of an area: the same as rq",
           POSITIVE),
    NUMBER("surface", "rdq", "S", "", NOWHERE, "",
           "rms slope of a profile, or its angle with a unit: lambda_c = 1.4142 R_q/R_dq",
           POSITIVE),
    NUMBER(
        "surface", "rsm", "L [sampling LR]", "length", NOWHERE, "",
        "mean width of elements by ISO 4287; depends on the sampling length, so that rdq is better",
        POSITIVE),
    NUMBER("surface", "sampling", "LR", "length", NOWHERE, "",
           "sampling length of rsm: the cut-off", POSITIVE),
    NUMBER("surface", "sdq", "S", "", NOWHERE, "",
           "rms slope of an area, or its angle with a unit: lambda_c = 2 S_q/S_dq", POSITIVE),
    NUMBER("surface", "sal", "L", "length", NOWHERE, "",
           "length at which the autocorrelation is 0.2: lambda_c = 0.7882 S_al", POSITIVE),
    WORD("surface", "profile", "FILE", "", "a measured profile"),
    WORD("surface", "map", "FILE", "", "a measured map"),
    NUMBER("surface", "lay", "X Y Z | axial | circumferential | ANGLE", "degrees", NOWHERE, "",
           "direction of the lay: a vector along the wall, or an angle from a cylinder's axis",
           FROM(-180, 180)),
    NUMBER("surface", "dp_bins", "N", "", AT(bins), "16; of a map 6",
           "number of diameters for which a measured wall is prepared", FROM(1, ASP_BINS_MAX),
           .whole = true),
    WORD("spread", "plane", "", "", "faces tilt in the plane of incidence only"),
    FLAG("spread", "isotropic", "", choice.isotropic, "yes", "faces tilt all around"),
    FLAG("spread", "collisions", "single | multiple", choice.multiple, "multiple",
         "single: a rebound into the wall is drawn again; multiple: it hits the next face"),
    NUMBER("erosion", "density", "RHO", "density", AT(choice.erosion.density),
           "that of the wall's material", "density of the wall", POSITIVE),
    FLAG("erosion", "face", "mean | tilted", choice.erosion.tilted, "mean",
         "take the impact angle on the mean wall, or on each face that is hit"),
    NUMBER("grain", "lever", "S", "", AT(choice.lever), "",
           "an equivalent sphere whose center of mass is off by N(0, S d_p) per axis, drawn anew "
           "at each impact",
           FROM(0, 0.5), .above = true, .may_fit = true),
    FLAG("rebound", "scatter_twice", "", choice.scatter_twice, "no",
         "allow the law's own scatter on a rough wall"),
    WORD("materials", "file", "FILE", "",
         "materials of your own, as `asperity materials` prints them"),
    WORD("deposit", "remove",
         "[u_tau U] gas_density RHO gas_viscosity NU [adhesion MEDIAN] [adhesion_spread S]", "no",
         "a flow along the wall takes away what freezes, at the rate of Reeks & Hall 2001"),
    NUMBER("remove", "u_tau", "U", "speed", AT(choice.flow.u_tau), "",
           "friction velocity of the flow; needed, but where the flow is computed (OpenFOAM)",
           POSITIVE),
    NUMBER("remove", "gas_density", "RHO", "density", AT(choice.flow.density), "",
           "density of the gas", POSITIVE),
    NUMBER("remove", "gas_viscosity", "NU", "length2/time", AT(choice.flow.viscosity), "",
           "kinematic viscosity of the gas", POSITIVE),
    NUMBER("remove", "adhesion", "MEDIAN", "", AT(choice.flow.adhesion), "by the size",
           "median of adhesion over that of a smooth contact", FROM(0, 1), .above = true),
    NUMBER("remove", "adhesion_spread", "S", "", AT(choice.flow.spread), "by the size",
           "geometric standard deviation of the adhesion", FROM(1, INFINITY)),
};

int aspi_keyword_count(void) {
  return (int)(sizeof keywords / sizeof *keywords);
}

const asp_keyword *asp_keyword_at(int index) {
  return index >= 0 && index < aspi_keyword_count() ? &keywords[index] : NULL;
}

const asp_keyword *aspi_keyword_find(const char *within, const char *name) {
  for (int i = 0; i < aspi_keyword_count(); i++)
    if (strcmp(keywords[i].within, within) == 0 && strcmp(keywords[i].name, name) == 0)
      return &keywords[i];
  return NULL;
}

void aspi_keyword_choice(const asp_keyword *k, const asp_description *d, char word[20]) {
  bool flag;
  memcpy(&flag, (const char *)d + k->flag, sizeof flag);
  int length = (int)strcspn(k->values, " ");
  snprintf(word, 20, "%.*s", flag ? 20 : length, flag ? strrchr(k->values, ' ') + 1 : k->values);
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
