/* No largest step: spheres in closed rooms, with steps of half a diameter to fifty, at rest and
 * moving. Nobody crosses a wall, nobody is lost, and walls at rest keep every speed. It drives the
 * wall as an engine does, without one. steps [IMPACTS]      of each case; 20 000 where none is
 * given, 1 000 000 for the long run
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <algorithm>

#include "alone.h"
#include "contact/vector.h"
#include "dem/shapes/mesh.h"
#include "dem/shapes/primitive.h"

using namespace asperity;

namespace {

const double DIAMETER = 1, SPEED = 1;

double uniform(double lo, double hi) {
  static uint64_t state = 2463534242;
  state = state * 6364136223846793005ULL + 1442695040888963407ULL;
  return lo + (hi - lo) * static_cast<double>(state >> 11) / 9007199254740992.0;
}

/* A sphere of 20 * 4^levels triangles, each node at a radius of its own, or all at one. */
std::vector<ContactTriangle> ball(int levels, double least, double most) {
  std::vector<ContactTriangle> triangles;
  const double o[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int x = 0; x < 2; x++)
    for (int y = 2; y < 4; y++)
      for (int z = 4; z < 6; z++) {
        ContactTriangle t;
        aspi_copy(o[x], t.node[0]);
        aspi_copy(o[y], t.node[1]);
        aspi_copy(o[z], t.node[2]);
        triangles.push_back(t);
      }
  for (int level = 0; level < levels; level++) {
    std::vector<ContactTriangle> finer;
    for (const ContactTriangle &t : triangles) {
      double mid[3][3];
      for (int k = 0; k < 3; k++) {
        for (int d = 0; d < 3; d++)
          mid[k][d] = t.node[k][d] + t.node[(k + 1) % 3][d];
        aspi_scale(1 / aspi_length(mid[k]), mid[k]);
      }
      ContactTriangle parts[4];
      for (int k = 0; k < 3; k++) {
        aspi_copy(t.node[k], parts[k].node[0]);
        aspi_copy(mid[k], parts[k].node[1]);
        aspi_copy(mid[(k + 2) % 3], parts[k].node[2]);
        aspi_copy(mid[k], parts[3].node[k]);
      }
      finer.insert(finer.end(), parts, parts + 4);
    }
    triangles.swap(finer);
  }
  for (ContactTriangle &t : triangles)
    for (int k = 0; k < 3; k++) { /* of equal nodes the same number */
      double *n = t.node[k];
      const double mixed = sin(1e4 * (n[0] + 1.7 * n[1] + 2.3 * n[2])) * 43758.5453;
      aspi_scale(least + (most - least) * (mixed - floor(mixed)), n);
    }
  return triangles;
}

/* True if a point is inside a star-shaped mesh around the origin: the triangle on its ray from the
 * origin lies farther out. */
bool inside(const std::vector<ContactTriangle> &triangles, const double x[3]) {
  for (const ContactTriangle &t : triangles) {
    double normal[3], edge[3], side[3];
    bool through = true;
    for (int k = 0; k < 3 && through; k++) {
      aspi_cross(t.node[k], t.node[(k + 1) % 3], side);
      const double third = aspi_dot(side, t.node[(k + 2) % 3]);
      through = aspi_dot(side, x) * (third < 0 ? -1 : 1) >= -1e-12;
    }
    if (!through)
      continue;
    aspi_subtract(t.node[1], t.node[0], normal);
    aspi_subtract(t.node[2], t.node[0], edge);
    aspi_cross(normal, edge, side);
    const double level = aspi_dot(side, t.node[0]);
    return aspi_dot(side, x) * (level < 0 ? -1 : 1) < fabs(level);
  }
  return aspi_length(x) < 1e-9;
}

Frame turned(double angle, double along) {
  Frame frame;
  frame.turn[0][0] = frame.turn[1][1] = cos(angle);
  frame.turn[1][0] = sin(angle);
  frame.turn[0][1] = -sin(angle);
  frame.shift[2] = along;
  return frame;
}

struct Room {
  const char *name;
  std::vector<std::unique_ptr<Shape>> shapes;
  std::vector<ContactTriangle> triangles; /* of a closed mesh */
  MeshShape *mesh;
  double turn, swing; /* of the mesh: angle in a step; amplitude along z */
  double half;        /* of the planes and of the cylinder */
};

bool run(Room &room, double diameters, double impacts) {
  const Alone engine;
  const bool tube = room.shapes.size() == 1;
  std::unique_ptr<Wall> wall = make_wall(engine, std::move(room.shapes),
                                         "rebound constant 1 1 deposit off", room.triangles.size());
  const int n = 400;
  const double dt = diameters * DIAMETER / SPEED;
  Grains grains(n, DIAMETER / 2, dt);
  std::vector<double> &x = grains.x, &v = grains.v;
  for (int i = 0; i < n; i++) {
    double *at = &v[3 * i];
    for (int d = 0; d < 3; d++) {
      x[3 * i + d] = uniform(-0.5, 0.5);
      at[d] = uniform(-1, 1);
    }
    aspi_scale(SPEED / aspi_length(at), at);
  }
  grains.begin({wall.get()});
  int lost = 0;
  double worst = 0;
  for (int step = 1; wall->books.counter(Books::N_IMPACTS) < impacts && step < 100000000; step++) {
    if (room.mesh && (room.turn > 0 || room.swing > 0)) {
      const double phase = 0.3 * step;
      Twist twist;
      twist.angular[2] = room.turn / dt;
      twist.linear[2] = room.swing * 0.3 / dt * cos(phase);
      room.mesh->motion().advance(turned(room.turn * step, room.swing * sin(phase)), twist, dt);
    }
    grains.fly(1);
    for (int i = 0; i < n; i++) {
      double body[3];
      aspi_copy(&x[3 * i], body);
      if (room.mesh) {
        room.mesh->motion().end().to_local(&x[3 * i], body);
        lost += step % 16 == 0 && !inside(room.triangles, body);
      } else if (room.half > 0)
        lost += !(aspi_dot(body, body) < 1e30) || std::max(hypot(body[0], body[1]), 0.0) > 1e30 ||
                (tube ? hypot(body[0], body[1]) > room.half : fabs(body[2]) > room.half);
      worst = std::max(worst, fabs(aspi_length(&v[3 * i]) / SPEED - 1));
    }
    /* Moving walls heat what they hold: keep the speeds, so that a step stays what it is. */
    for (int i = 0; i < n && (room.turn > 0 || room.swing > 0); i++)
      aspi_scale(SPEED / aspi_length(&v[3 * i]), &v[3 * i]);
  }
  const bool moves = room.turn > 0 || room.swing > 0;
  const bool good = lost == 0 && (moves || worst < 1e-9);
  printf("%-26s %5.1f diameters a step: %9.0f impacts, %.0f guarded, %d outside%s\n", room.name,
         diameters, wall->books.counter(Books::N_IMPACTS), wall->books.counter(Books::N_GUARDED),
         lost, good ? "" : "  FAILED");
  if (!moves && !(worst < 1e-9))
    printf("  a speed is off by %g\n", worst);
  fflush(stdout);
  return good;
}

Room mesh_room(const char *name, int levels, double least, double most, double turn, double swing) {
  Room room = {name, {}, ball(levels, least, most), new MeshShape, turn, swing, 0};
  set_triangles(*room.mesh, room.triangles);
  room.shapes.push_back(std::unique_ptr<Shape>(room.mesh));
  return room;
}

Room planes() {
  Room room = {"two planes", {}, {}, NULL, 0, 0, 10};
  const double still[3] = {0, 0, 0};
  for (int side = -1; side <= 1; side += 2)
    room.shapes.push_back(std::unique_ptr<Shape>(new PlaneShape(2, side * room.half, still)));
  return room;
}

Room tube() {
  Room room = {"cylinder", {}, {}, NULL, 0, 0, 10};
  const double center[3] = {0, 0, 0};
  room.shapes.push_back(std::unique_ptr<Shape>(new CylinderShape(2, center, room.half, 0, 0)));
  return room;
}

/* Elastic grains with weight between a rough floor and a rough lid. Of those with one energy, the
 * density at a height goes as the speed v there, and v_z^2 is v^2/3. Prints both means over those
 * of the closed form, with standard errors from eight parts of the time. */
bool weigh(double sigma, double steps) {
  const Alone engine;
  const int n = 400, parts = 8;
  const double half = 10, g = 0.4 * SPEED * SPEED / (4 * half), dt = 0.5 * DIAMETER / SPEED;
  Room room = planes();
  std::unique_ptr<Wall> wall = make_wall(engine, std::move(room.shapes),
                                         "surface sigma " + std::to_string(sigma) +
                                             " lambda_c 0.01 rebound constant 1 1 deposit off");
  Grains grains(n, DIAMETER / 2, dt);
  const double low = -half + DIAMETER / 2, high = -low;
  for (int i = 0; i < n; i++) {
    double *at = &grains.v[3 * i];
    for (int d = 0; d < 3; d++)
      at[d] = uniform(-1, 1);
    aspi_scale(SPEED / aspi_length(at), at);
    grains.x[3 * i + 2] = 0;
    grains.f[3 * i + 2] = -g;
  }
  grains.begin({wall.get()});
  double height[parts] = {0}, share[parts] = {0};
  const int each = static_cast<int>(steps) / parts;
  grains.fly(each);
  for (int p = 0; p < parts; p++)
    for (int step = 0; step < each; step++) {
      grains.fly(1);
      for (int i = 0; i < n; i++) {
        const double *v = &grains.v[3 * i];
        height[p] += grains.x[3 * i + 2] / n / each;
        share[p] += 3 * v[2] * v[2] / aspi_dot(v, v) / n / each;
      }
    }
  double whole = 0, mean = 0; /* by the closed form */
  for (int k = 0; k < 10000; k++) {
    const double z = low + (k + 0.5) * (high - low) / 10000, v = sqrt(SPEED * SPEED - 2 * g * z);
    whole += v;
    mean += v * z;
  }
  mean /= whole;
  const auto estimate = [&](const double *of, double &value, double &error) {
    double square = value = 0;
    for (int p = 0; p < parts; p++) {
      value += of[p] / parts;
      square += of[p] * of[p] / parts;
    }
    error = sqrt((square - value * value) / (parts - 1));
  };
  double z, z_error, s, s_error;
  estimate(height, z, z_error);
  estimate(share, s, s_error);
  const bool good = fabs(z - mean) < 4 * z_error + 0.02 && fabs(s - 1) < 4 * s_error + 0.01;
  printf("floor and lid, sigma %g: height %.4f +- %.4f (%.4f by closed form), 3 v_z^2/v^2 %.4f +- "
         "%.4f, %.0f impacts%s\n",
         sigma, z, z_error, mean, s, s_error, wall->books.counter(Books::N_IMPACTS),
         good ? "" : "  FAILED");
  fflush(stdout);
  return good;
}

} // namespace

int main(int argc, char **argv) {
  const double impacts = argc > 1 ? atof(argv[1]) : 20000;
  bool good = true;
  for (double diameters : {0.5, 3., 12., 50.}) {
    Room rooms[] = {planes(),
                    tube(),
                    mesh_room("octahedron", 0, 12, 12, 0, 0),
                    mesh_room("ball of 512 triangles", 3, 12, 12, 0, 0),
                    mesh_room("star of 512 triangles", 3, 6, 14, 0, 0),
                    mesh_room("star that turns", 3, 6, 14, 0.01 * diameters, 0),
                    mesh_room("star that swings", 3, 6, 14, 0, 0.02 * diameters)};
    for (Room &room : rooms)
      good = run(room, diameters, impacts) && good;
  }
  for (double sigma : {5., 10., 20.})
    good = weigh(sigma, impacts) && good;
  return good ? 0 : 1;
}
