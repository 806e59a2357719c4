/* Angles and their sines against the C library's in long double: inline, for one, and for many. */
#include "check.h"

#include "angle.h"

#include <float.h>

#define STEPS 200000

enum { MANY = 3 * STEPS };

/* A number of 0 to 1 for each step, crowded towards 0 for every other one. */
static double share(int i) {
  double x = (i + 0.5) / STEPS;
  return i % 2 ? x : pow(x, 30);
}

/* |is - should| in units of the last place of `should`. */
static double ulps(double is, long double should) {
  double place = nextafter(fabs((double)should), INFINITY) - fabs((double)should);
  return (double)(fabsl(is - should) / place);
}

static void check_ulps(double worst, double limit) {
  if (!(worst <= limit))
    print_error("off by %g ulps\n", worst);
  assert_true(worst <= limit);
}

static void arcs(void **state) {
  (void)state;
  static double up[MANY], along[MANY], angle[MANY];
  double worst = 0, scale[] = {1, 1e-140, 1e140};
  for (int i = 0; i < MANY; i++) {
    int step = i / 3;
    double rise = share(step) * scale[step % 3];
    double run = (1 + 0.3 * share(step / 2)) * scale[step % 3];
    up[i] = i % 3 == 0 ? rise : i % 3 == 1 ? run : -rise;
    along[i] = i % 3 == 1 ? rise : run;
  }
  asp_angle_n(MANY, up, along, angle);
  for (int i = 0; i < MANY; i++) {
    long double should = atan2l(up[i], along[i]);
    worst = fmax(worst, ulps(asp_angle(up[i], along[i]), should));
    worst = fmax(worst, ulps(angle[i], should));
    assert_near(asp_angle_one(up[i], along[i]), angle[i], 0);
  }
  check_ulps(worst, 2);
  assert_near(asp_arc(0, 0), 0, 0);
  assert_near(asp_arc(0, 3), 0, 0);
  assert_near(asp_arc(3, 0), ASP_PI / 2, 0);
}

static void turns(void **state) {
  (void)state;
  static double angle[MANY], s[MANY], c[MANY];
  double sine = 0, cosine = 0;
  for (int i = 0; i < MANY; i++) {
    double x = share(i / 3) * ASP_PI / 2;
    angle[i] = i % 3 == 0 ? x : i % 3 == 1 ? -x : ASP_PI / 2 - x;
  }
  asp_turn_n(MANY, angle, s, c);
  for (int i = 0; i < MANY; i++) {
    asp_turn by[] = {asp_turn_by(angle[i]), asp_turn_one(angle[i])};
    for (int way = 0; way < 2; way++) {
      sine = fmax(sine, ulps(by[way].sine, sinl(angle[i])));
      cosine = fmax(cosine, ulps(by[way].cosine, cosl(angle[i])));
    }
    assert_near(by[1].sine, s[i], 0);
    assert_near(by[1].cosine, c[i], 0);
  }
  check_ulps(sine, 1.5);
  check_ulps(cosine, 1.5);
}

static void little_turns_are_turns(void **state) {
  (void)state;
  for (int i = 0; i < STEPS; i++) {
    double x = (2. * i / STEPS - 1) * ASP_PI / 4;
    asp_turn little = asp_turn_little(x), any = asp_turn_by(x);
    assert_near(little.sine, any.sine, 0);
    assert_near(little.cosine, any.cosine, 0);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(arcs),
      cmocka_unit_test(turns),
      cmocka_unit_test(little_turns_are_turns),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
