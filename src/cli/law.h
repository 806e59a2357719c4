/* The options that name a rebound law and the materials it works on, shared by the commands that
 * evaluate one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_LAW_H
#define ASP_CLI_LAW_H

#include "cli/cli.h"

/* Their places in a command's table of options, counted from the first of them, which come last in
 * the table: the keywords of the laws' parameters, as many as there are, end it. */
enum {
  LAW_PARTICLE,
  LAW_WALL,
  LAW_MATERIALS,
  LAW_REBOUND,
  LAW_TABLE,
  LAW_SET,
  LAW_SCATTER_TWICE,
  LAW_MU,
  LAW_GAMMA,
  LAW_YIELD,
  LAW_ADHESION,
  LAW_REMOVE,
  LAW_KEYWORDS,
  LAW_KEYWORDS_MOST = 16,
  LAW_OPTIONS = LAW_KEYWORDS + LAW_KEYWORDS_MOST
};

#define CLI_LAW_OPTIONS(first)                                                                     \
  [(first) +                                                                                       \
      LAW_PARTICLE] = {"particle", "MATERIAL", "see 'asperity materials'", "ard"},                 \
      [(first) + LAW_WALL] = {"wall", "MATERIAL", "see 'asperity materials'", "hastelloy-x"},      \
      [(first) +                                                                                   \
          LAW_MATERIALS] = {"materials", "FILE", "your own, which go before the presets", NULL},   \
      [(first) + LAW_REBOUND] = {"rebound", "LAW", "see 'asperity rebound --list'", "bons"},       \
      [(first) + LAW_TABLE] = {"table", "FILE",                                                    \
                               "for --rebound table: alpha1_deg,[v1_m_s,]cor_n,cor_t", NULL},      \
      [(first) + LAW_SET] = {"set", "NAME=VALUE,...", "parameters of the law", NULL},              \
      [(first) + LAW_SCATTER_TWICE] = {"scatter-twice", NULL,                                      \
                                       "take a law's own scatter on a rough wall too", NULL},      \
      [(first) + LAW_MU] = {"mu", "NUMBER",                                                        \
                            "friction; with bons a constant fitted to its form, not Coulomb's",    \
                            "0.3"},                                                                \
      [(first) + LAW_GAMMA] = {"gamma", "J_PER_M2", "surface energy", "0.8"},                      \
      [(first) +                                                                                   \
          LAW_YIELD] = {"yield", "PA", "yield stress; the material's where not given", NULL},      \
      [(first) + LAW_ADHESION] = {"adhesion", "on|off", "whether particles can stick", "on"},      \
      [(first) + LAW_REMOVE] = {                                                                   \
          "remove", "U_TAU,GAS_DENSITY[,MEAN_FREE_PATH[,WORK]]",                                   \
          "a flow whose shear takes away what sticks (SI; El-Batsh, secondary)", NULL}

/* A law with its parameters, and what it works on. */
typedef struct cli_law {
  asp_wall *wall;     /* smooth; the law, its parameters and table, deposits; to be prepared */
  asp_materials *own; /* NULL: none */
  asp_cor_table *table;
  const asp_material *particle;
} cli_law;

/* Puts the keywords of all laws' parameters into the table of options, of which the first of a law
 * is given: `contact_area` becomes --contact-area A,B,C. */
void cli_law_add_keywords(cli_option *first);

/* Reads the law from the options, of which the first is given; exits on bad ones. */
cli_law cli_law_read(const cli_option *first);
void cli_law_free(cli_law *law);

/* Whether an option of the table, by its place, is one of this law's own: its table, or the keyword
 * of a parameter. */
bool cli_law_takes(const cli_option *first, int place, const asp_rebound_law *law);

/* Prepares its wall for contacts; exits where that fails. */
void cli_law_prepare(cli_law *law);

/* The pair of the particle and the wall material of that name, to be freed. */
asp_pair *cli_law_pair(const cli_option *first, const cli_law *law, const char *wall);

/* The file of --materials; NULL where none is given. */
asp_materials *cli_materials_of(const cli_option *option);

/* A line on stderr when a measured law acts on a rough wall. */
void cli_law_warn_double(const cli_law *law);

#endif
