/* Viscosity and Young's modulus over the temperature T (K), and what follows from them.
 *
 *   P  = min(1, mu_c/mu(T))      an impact sticks with this probability, besides what its law holds
 *                                (Walsh et al. 1990; Sreedharan & Tafti 2010)
 *   vft   log10 mu = A + B/(T - C)
 *   watt  log10(10 mu) = 10^7 m/(T - 423.15)^2 + c
 *         m = 0.00835 SiO2 + 0.00601 Al2O3 - 0.109
 *         c = 0.0415 SiO2 + 0.0192 Al2O3 + 0.0276 Fe2O3 + 0.016 CaO - 3.92
 *   exp   E  = E0 exp(-K T)
 *   table straight lines of the logarithm
 *
 * mu in Pa s; the oxides in percent of the mass of these four and MgO. The modulus is that of both
 * sides, as of ash on ash, at the mean of the particle's and the wall's temperature. No original
 * was seen: the forms are as other public codes have them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound/heat.h"
#include "base/error.h"
#include "base/table.h"

#include <gsl/gsl_interp.h>
#include <math.h>

#define LN_10 2.3025850929940457

/* Percent by which the oxides may miss 100. */
#define SHARES_OFF 5.0

enum { A, B, C, N_VFT };
static const aspi_keyword vft_parameters[N_VFT] = {
    [A] = {"a", "", 0, -1e3, 1e3, "log10 of the viscosity in Pa s where the temperature is high",
           .word = ""},
    [B] = {"b", "K", 0, 0, 1e6, "how fast it falls", .above = true, .word = ""},
    [C] = {"c", "K", 0, 0, 1e5, "temperature at which it is infinite", .word = ""},
};

static double vft(const aspi_curve *curve, double kelvin) {
  const double *p = curve->parameters;
  return LN_10 * (p[A] + p[B] / (kelvin - p[C])) + log(curve->unit);
}

static asp_code vft_begin(aspi_curve *curve, asp_error *error) {
  (void)error;
  curve->least = curve->parameters[C];
  return ASP_OK;
}

enum { SIO2, AL2O3, FE2O3, CAO, MGO, N_WATT };
static const aspi_keyword watt_parameters[N_WATT] = {
    [SIO2] = {"sio2", "", 0, 0, 100, "percent of the mass, here and below", .word = ""},
    [AL2O3] = {"al2o3", "", 0, 0, 100, "see sio2", .word = ""},
    [FE2O3] = {"fe2o3", "", 0, 0, 100, "all iron as this oxide", .word = ""},
    [CAO] = {"cao", "", 0, 0, 100, "see sio2", .word = ""},
    [MGO] = {"mgo", "", 0, 0, 100, "see sio2", .word = ""},
};

static double sum_of(const double *p) {
  return p[SIO2] + p[AL2O3] + p[FE2O3] + p[CAO] + p[MGO];
}

static double watt(const aspi_curve *curve, double kelvin) {
  const double *p = curve->parameters, share = 100 / sum_of(p), off = kelvin - 423.15;
  double m = share * (0.00835 * p[SIO2] + 0.00601 * p[AL2O3]) - 0.109;
  double c = share * (0.0415 * p[SIO2] + 0.0192 * p[AL2O3] + 0.0276 * p[FE2O3] + 0.016 * p[CAO]);
  return LN_10 * (m * 1e7 / (off * off) + c - 3.92 - 1) + log(curve->unit);
}

static asp_code watt_begin(aspi_curve *curve, asp_error *error) {
  const double sum = sum_of(curve->parameters);
  curve->least = 423.15;
  return fabs(sum - 100) <= SHARES_OFF
             ? ASP_OK
             : aspi_fail(error, ASP_EARG,
                         "SIO2 AL2O3 FE2O3 CAO MGO of 'watt' are %g %% in all; they must be 100 to "
                         "within %g: leave out the other oxides, and make these five 100",
                         sum, SHARES_OFF);
}

enum { E0, K, N_EXP };
static const aspi_keyword exp_parameters[N_EXP] = {
    [E0] = {"e0", "stress", 0, 0, INFINITY, "modulus if it grew on to 0 K", .above = true,
            .word = ""},
    [K] = {"k", "1/K", 0, 0, 1, "share that is lost per kelvin", .word = ""},
};

static double exponential(const aspi_curve *curve, double kelvin) {
  return log(curve->parameters[E0]) - curve->parameters[K] * kelvin;
}

static double in_table(const aspi_curve *curve, double kelvin) {
  const double *t = curve->kelvin, *value = curve->log_value;
  size_t i = gsl_interp_bsearch(t, kelvin, 0, curve->n_points - 1);
  return value[i] + (kelvin - t[i]) / (t[i + 1] - t[i]) * (value[i + 1] - value[i]) +
         log(curve->unit);
}

const aspi_curve_form aspi_curve_forms[] = {
    {"vft", "viscosity", "log10 of the viscosity in Pa s is A + B/(T - C)",
     "Vogel, Fulcher and Tammann, recalled", N_VFT, vft_parameters, vft, vft_begin},
    {"watt", "viscosity", "by the oxides of coal ash",
     "Watt & Fereday 1969, as code_saturne has it (its code was seen, the original was not)",
     N_WATT, watt_parameters, watt, watt_begin},
    {"exp", "soften_modulus", "E0 exp(-K T)",
     "El-Batsh, as one open code has it, with 3e20 and 0.02365", N_EXP, exp_parameters, exponential,
     NULL},
    {"table", "viscosity soften_modulus", "as measured, in a file",
     "temperature_k with viscosity_pa_s or youngs_modulus_pa", 0, NULL, in_table, NULL},
    {.name = NULL},
};

static asp_code add_point(aspi_curve *c, const aspi_table *file, const int at[2],
                          asp_error *error) {
  const size_t n = c->n_points;
  double value = 0;
  if (n == ASPI_CURVE_POINTS)
    return aspi_table_fail(file, error, "there are more than %d rows", ASPI_CURVE_POINTS);
  asp_code code = aspi_table_number(file, at[0], 0, 1e5, &c->kelvin[n], NULL, error);
  if (!code)
    code = aspi_table_number(file, at[1], 1e-30, 1e30, &value, NULL, error);
  if (!code && n > 0 && !(c->kelvin[n] > c->kelvin[n - 1]))
    return aspi_table_fail(file, error, "the temperature is %g K behind %g K; it must rise",
                           c->kelvin[n], c->kelvin[n - 1]);
  c->log_value[c->n_points++] = log(value);
  return code;
}

asp_code aspi_curve_read(aspi_curve *c, const char *column, asp_error *error) {
  aspi_table *file = aspi_table_open(NULL, c->file, 0, error);
  if (!file)
    return ASP_EDATA;
  const int at[2] = {aspi_table_need(file, "temperature_k", error),
                     aspi_table_need(file, column, error)};
  asp_code code = at[0] < 0 || at[1] < 0 ? ASP_EDATA : ASP_OK;
  for (bool found = true; found && !code;) {
    code = aspi_table_row(file, &found, error);
    if (!code && found)
      code = add_point(c, file, at, error);
  }
  if (!code && c->n_points < 2)
    code = aspi_table_fail(file, error, "there is one row; there must be two or more");
  aspi_table_close(file);
  return code;
}

static asp_code check_curve(const aspi_curve *c, const char *of, double kelvin, asp_error *error) {
  if (!c->form)
    return ASP_OK;
  const bool is_table = c->n_points > 0;
  const double least = is_table ? c->kelvin[0] : c->least,
               most = is_table ? c->kelvin[c->n_points - 1] : INFINITY;
  if (kelvin <= most && (is_table ? kelvin >= least : kelvin > least))
    return ASP_OK;
  return aspi_fail(error, ASP_ERANGE,
                   is_table ? "%s is asked for at %g K; its %s is from %g to %g K"
                            : "%s is asked for at %g K; its form '%s' is for more than %g K",
                   of, kelvin, c->form->name, least, most);
}

asp_code aspi_heat_check(const aspi_heat *heat, double kelvin, asp_error *error) {
  if (!(kelvin > 0))
    return aspi_fail(error, ASP_ERANGE,
                     "the temperature of a particle is %g K; it must be more than 0, as what the "
                     "wall does depends on it",
                     kelvin);
  asp_code code = check_curve(&heat->viscosity, "the viscosity", kelvin, error);
  return code ? code
              : check_curve(&heat->modulus, "Young's modulus",
                            0.5 * (kelvin + heat->wall_temperature), error);
}

double aspi_heat_share(const aspi_heat *heat, double kelvin) {
  const aspi_curve *of = &heat->viscosity;
  return of->form ? exp(fmin(0, log(heat->critical) - of->form->log_value(of, kelvin))) : 0;
}

void aspi_heat_soften(const aspi_heat *heat, double kelvin, asp_pair *pair) {
  const aspi_curve *of = &heat->modulus;
  if (of->form)
    pair->modulus =
        exp(of->form->log_value(of, 0.5 * (kelvin + heat->wall_temperature))) / pair->give;
}
