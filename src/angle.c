/* The angles of one contact; see angle.h. */
#include "angle.h"
#include "machine.h"

ASP_EACH_MACHINE
double asp_angle_one(double rise, double run) {
  return asp_angle(rise, run);
}

ASP_EACH_MACHINE
asp_turn asp_turn_one(double x) {
  return asp_turn_of(x);
}
