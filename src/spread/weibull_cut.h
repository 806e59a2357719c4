/* What the steepest face takes off a Weibull law, exp(-x^k), as exp(-exp(k ln x)) from two tables
 * of polynomials that the build makes (make_weibull_table.c): the logarithm of a mantissa over
 * eighths of an octave, within 2e-13, and exp(-exp y) for y from FIRST, where it is 1e-5, to where
 * it is less than the last bit of 1, within 1e-11 of itself. */
#ifndef ASP_SPREAD_WEIBULL_CUT_H
#define ASP_SPREAD_WEIBULL_CUT_H

enum { ASP_CUT_PER_UNIT = 64, ASP_CUT_CELLS = 78, ASP_CUT_OCTAVES = 6 };
#define ASP_CUT_FIRST 2.4375

#endif
