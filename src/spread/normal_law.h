/* The standard normal law where samplers need it fast, from tables of polynomials that the build
 * makes (make_normal_table.c): within 4e-16 in probability, and without the exponential function.
 */
#ifndef ASP_SPREAD_NORMAL_LAW_H
#define ASP_SPREAD_NORMAL_LAW_H

/* Q(x) = 1 - Phi(x) over cells of 1/PER_UNIT from 0 on, by polynomials of seventh degree in units
 * of a cell around its end. Beyond the last Q has nothing left, in doubles, next to 1. */
enum { ASP_TAIL_PER_UNIT = 16, ASP_TAIL_CELLS = 133 };

/* The quantile from p = LEAST to 1/2 over cells of an eighth of an octave, 1/2 in one more, by
 * polynomials of ninth degree in what the mantissa (1 to 2) has over the middle of the cell. */
enum { ASP_NORMAL_OCTAVES = 35, ASP_NORMAL_PER_OCTAVE = 8, ASP_NORMAL_TERMS = 10 };
enum { ASP_NORMAL_CELLS = ASP_NORMAL_OCTAVES * ASP_NORMAL_PER_OCTAVE + 1 };
#define ASP_NORMAL_LEAST 0x1p-36

#endif
