/* A small engine: one grain hops along a rough plane under gravity until it lies in a valley. From
 * one face of the wall to the next it meets the mean wall.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <asperity_engine.h>
#include <math.h>
#include <stdio.h>

int main(void) {
  const double gravity = 9.81, n[3] = {0, 0, 1};
  asp_error error;
  asp_wall *wall = asp_wall_from_text("surface rq 5um lambda_c 40um rebound walton 0.8 0.3 0 "
                                      "deposit off",
                                      0, 0, &error);
  if (!wall) {
    fprintf(stderr, "%s\n", error.text);
    return 1;
  }
  asp_particle grain = {.d_p = 200e-6, .density = 2650};
  asp_key key = {1, asp_key_wall("plane"), 1, 0, 0},
          at_rest = {1, asp_key_wall("valleys"), 1, 0, 0};
  asp_valley valley = {0};
  asp_impact impact;
  double x[2] = {0, 0}, v[3] = {1, 0, -1}, face[2] = {0, 0};
  int faces = 0;
  do {
    double along[3] = {x[0] - face[0], x[1] - face[1], 0};
    double length = asp_wall_face_length(wall, &grain, along, n);
    int is_new = faces == 0 || hypot(along[0], along[1]) >= length;
    key.impact++;
    if (is_new) {
      at_rest.impact++;
      faces++;
      face[0] = x[0];
      face[1] = x[1];
      valley = asp_wall_valley(wall, &grain, v, n, &at_rest);
      asp_wall_impact(wall, &grain, v, n, &key, &impact);
    } else
      asp_wall_impact_mean(wall, &grain, v, n, &key, &impact);
    double flight = 2 * impact.v2[2] / gravity;
    for (int d = 0; d < 3; d++)
      grain.omega[d] = impact.omega[d];
    for (int d = 0; d < 2; d++) {
      x[d] += impact.v2[d] * flight;
      v[d] = impact.v2[d];
    }
    v[2] = -impact.v2[2];
  } while (0.5 * v[2] * v[2] > gravity * valley.height && key.impact < 1000);
  printf("the grain hits %u times, %d faces, and comes %.3g mm far and %.3g mm aside; its valley "
         "is %.2g um deep\n",
         (unsigned)key.impact, faces, 1e3 * x[0], 1e3 * x[1], 1e6 * valley.height);
  asp_wall_free(wall);
}
