/* A sphere and a cylinder along a coordinate axis; see contact.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "contact/contact.h"
#include "contact/vector.h"

/* The part of a vector across the axis. */
static void across(int axis, const double a[3], double c[3]) {
  aspi_copy(a, c);
  c[axis] = 0;
}

/* The time at which the distance from the axis is `touching`. It is `distance` at first and the
 * square root of a quadratic in time; 0 if it is beyond already and moves on, infinite for never.
 * rate: half the initial growth of its square; square: of the speed, > 0. */
static double chord_time(bool inside, double distance, double touching, double rate,
                         double square) {
  const double beyond = (distance - touching) * (distance + touching);
  const double root = sqrt(fmax(0.0, rate * rate - square * beyond));
  if (inside) {
    if (rate > 0)
      return beyond < 0 ? -beyond / (rate + root) : 0;
    return (root - rate) / square;
  }
  if (rate >= 0 || (beyond > 0 && !(root > 0)))
    return INFINITY;
  return beyond > 0 ? beyond / (root - rate) : 0;
}

bool aspi_cylinder_find(const ContactCylinder *cylinder, const ContactPath *path, double radius,
                        double latest, ContactTouch *touch) {
  double v[3], arm[3], n[3];
  across(cylinder->axis, path->v, v);
  aspi_subtract(path->x, cylinder->center, arm);
  across(cylinder->axis, arm, arm);
  const double distance = aspi_length(arm), square = aspi_dot(v, v);
  const bool inside = distance < cylinder->radius;
  const double touching = inside ? fmax(0.0, cylinder->radius - radius) : cylinder->radius + radius;
  if (!(square > 0))
    return false;
  const double rate = aspi_dot(arm, v), speed = sqrt(square);
  const bool touches = inside && fabs(distance - touching) <= TOUCHING * radius;
  const bool wide = inside && !(touching > 0); /* it goes back to the axis at the end */
  double time =
      wide ? path->left : chord_time(inside, touches ? touching : distance, touching, rate, square);
  if (!(time <= latest))
    return false;
  /* One that slides along the inside leaves the curve by its straight path: it touches now. */
  if (touches && !wide && time < path->left && fabs(rate) <= GRAZING * speed * distance)
    time = 0;
  aspi_add_scaled(arm, time, v, n);
  if (inside)
    aspi_scale(-1, n);
  const double length = aspi_length(n), approach = -aspi_dot(v, n);
  const bool slides = inside && time < path->left && fabs(approach) <= GRAZING * speed * length;
  if (!(length > 0) || !(wide || slides || approach > APPROACH * speed * length))
    return false;
  touch->time = time;
  aspi_copy(n, touch->n);
  aspi_scale(1 / length, touch->n);
  touch->overlap = inside ? length - touching : touching - length;
  if (touch->overlap <= TOUCHING * radius)
    touch->overlap = 0;
  touch->edge_sine = 0;
  touch->overlapped = touch->overlap > 0;
  return true;
}
