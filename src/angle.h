/* Angles and their sines as short straight code, for one contact and for vector loops. A contact
 * waits for the way from the velocities over the angle to the tilted face, and the C library's
 * functions, made for every argument, take longer one after the other. Minimax polynomials (Remez)
 * in x^2, off by less than 4e-18 of the result; results are within 2 ulps (test_angle). */
#ifndef ASP_ANGLE_H
#define ASP_ANGLE_H

#include "asperity.h"

#include <math.h>
#include <stdbool.h>

#define ASP_TAN_PI_8 0.41421356237309503
#define ASP_PI_2_REST 6.123233995736766e-17 /* what the double nearest to pi/2 lacks */

/* atan x - x for |x| <= tan(pi/8). Powers in pairs: shorter than Horner's chain. */
static inline double asp_arc_less(double x) {
  double z = x * x, z2 = z * z, z4 = z2 * z2;
  double a = (-0.333333333333332 + 0.19999999999954082 * z) +
             z2 * (-0.14285714280248607 + 0.11111110786143891 * z);
  double b = (-0.09090897836635449 + 0.07692061640434325 * z) +
             z2 * (-0.06663120420279234 + 0.058480091666042656 * z);
  double c = (-0.05039846567312988 + 0.03807834596048355 * z) + z2 * -0.017922304788068354;
  return x * z * (a + z4 * (b + z4 * c));
}

/* atan2(rise, run) for rise, run >= 0; 0 where both are 0. Less than pi/8 is the arc itself; more
 * is taken from pi/4 or pi/2. */
static inline double asp_arc(double rise, double run) {
  bool flat = rise <= ASP_TAN_PI_8 * run, steep = run < ASP_TAN_PI_8 * rise;
  double up = flat ? rise : steep ? -run : rise - run;
  double along = flat ? run : steep ? rise : rise + run;
  double from = flat ? 0 : steep ? ASP_PI / 2 : ASP_PI / 4;
  double rest = flat ? 0 : steep ? ASP_PI_2_REST : ASP_PI_2_REST / 2;
  double x = along > 0 ? up / along : 0;
  return from + (x + (asp_arc_less(x) + rest));
}

/* atan2(rise, run) for run >= 0 */
static inline double asp_angle(double rise, double run) {
  return copysign(asp_arc(fabs(rise), run), rise);
}

/* The angle of a slope, atan p. */
static inline double asp_arc_of(double p) {
  return fabs(p) <= ASP_TAN_PI_8 ? p + asp_arc_less(p) : asp_angle(p, 1);
}

typedef struct asp_turn {
  double sine, cosine;
} asp_turn;

/* Sine and cosine of |x| <= pi/4. */
static inline asp_turn asp_turn_little(double x) {
  double z = x * x, z2 = z * z, half = 0.5 * z, near_one = 1 - half;
  double s = (-0.16666666666666632 + 0.008333333333322424 * z) +
             z2 * ((-0.00019841269829816655 + 2.755731369510871e-06 * z) +
                   z2 * (-2.5050758633795602e-08 + 1.589682677161083e-10 * z));
  double c = (0.0416666666666666 - 0.0013888888888874138 * z) +
             z2 * ((2.480158728949188e-05 - 2.7557314355244547e-07 * z) +
                   z2 * (2.0875723683074305e-09 - 1.1359669715971236e-11 * z));
  return (asp_turn){x + x * z * s, near_one + (((1 - near_one) - half) + z2 * c)};
}

/* Sine and cosine of |x| <= pi/2: those of what is left to pi/2, exchanged, beyond pi/4. */
static inline asp_turn asp_turn_by(double x) {
  double size = fabs(x);
  bool steep = size > ASP_PI / 4;
  asp_turn turn = asp_turn_little(steep ? (ASP_PI / 2 - size) + ASP_PI_2_REST : size);
  return (asp_turn){copysign(steep ? turn.cosine : turn.sine, x), steep ? turn.sine : turn.cosine};
}

/* The same with a branch, for one angle that is rarely beyond pi/4. */
static inline asp_turn asp_turn_of(double x) {
  return fabs(x) <= ASP_PI / 4 ? asp_turn_little(x) : asp_turn_by(x);
}

/* asp_angle and asp_turn_by out of line, with fused multiplications and additions where the machine
 * has them: for one contact, and for n. They agree to the bit, for no sum above is one of two
 * products, of which either could be fused. */
double asp_angle_one(double rise, double run);
asp_turn asp_turn_one(double x);
void asp_angle_n(size_t n, const double *rise, const double *run, double *angle);
void asp_turn_n(size_t n, const double *x, double *sine, double *cosine);

#endif
