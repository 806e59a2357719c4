/* Angles and their sines against the C library's in long double: inline, for one, and for many. */
#include "check.h"

#include "angle.h"

#include <float.h>

#define STEPS 200000

enum { MANY = 3 };

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
  double worst = 0, scale[] = {1, 1e-140, 1e140};
  for (int i = 0; i < STEPS; i++) {
    double rise = share(i) * scale[i % 3], run = (1 + 0.3 * share(i / 2)) * scale[i % 3];
    double up[MANY] = {rise, run, -rise}, along[MANY] = {run, rise, run}, angle[MANY];
    asp_angle_n(MANY, up, along, angle);
    for (int k = 0; k < MANY; k++) {
      long double should = atan2l(up[k], along[k]);
      worst = fmax(worst, ulps(asp_angle(up[k], along[k]), should));
      worst = fmax(worst, ulps(angle[k], should));
      assert_near(asp_angle_one(up[k], along[k]), angle[k], 0);
    }
  }
  check_ulps(worst, 2);
  assert_near(asp_arc(0, 0), 0, 0);
  assert_near(asp_arc(0, 3), 0, 0);
  assert_near(asp_arc(3, 0), ASP_PI / 2, 0);
}

static void turns(void **state) {
  (void)state;
  double sine = 0, cosine = 0;
  for (int i = 0; i < STEPS; i++) {
    double x = share(i) * ASP_PI / 2, angle[MANY] = {x, -x, ASP_PI / 2 - x}, s[MANY], c[MANY];
    asp_turn_n(MANY, angle, s, c);
    for (int k = 0; k < MANY; k++) {
      asp_turn by[] = {asp_turn_by(angle[k]), asp_turn_one(angle[k])};
      for (int way = 0; way < 2; way++) {
        sine = fmax(sine, ulps(by[way].sine, sinl(angle[k])));
        cosine = fmax(cosine, ulps(by[way].cosine, cosl(angle[k])));
      }
      assert_near(by[1].sine, s[k], 0);
      assert_near(by[1].cosine, c[k], 0);
    }
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
