/* Tolerances of contacts: one name for each meaning. Lengths are in radii of the sphere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#ifdef __cplusplus
namespace asperity {
#endif

/* Relative rounding of a sum of products of places: a triangle flatter than this is a line, a body
 * rounder than this is a ball. */
static const double SUM_ROUNDING = 1e-12;

/* Relative rounding of velocities, times, distances and forces, which are differences of such sums;
 * directions are one where 1 less the cosine between them is smaller. */
static const double ROUNDING = 1e-9;

/* A sphere approaches a wall if its normal speed is a larger share of its speed. */
static const double APPROACH = 1e-13;

/* The search puts a sphere at a wall to within this length. */
static const double TOUCHING = 1e-10;

/* Triangles are in one plane, and contacts at one place, where they differ by less: files of
 * triangles have six to seven digits. */
static const double ONE_PLACE = 1e-7;

/* Sine of the angle below which a motion, or a direction, is along a wall: what the normals of
 * those triangles have. At that angle a contact is known to ONE_PLACE / GRAZING of a radius. */
static const double GRAZING = 1e-6;

/* GRAZING for resting movers. With an overlap of TOUCHING a sphere touches edges of coplanar faces
 * ahead; their normals tilt by sqrt(2 TOUCHING). */
static const double ON_EDGES = 1.5e-5;

/* Spheres of a body meet walls at one instant, and particles keep their distance to belts, to
 * within this length. */
static const double AT_ONCE = 1e-6;

/* A larger overlap is none of a settled bed, where it reaches 1e-6. */
static const double OVERLAP = 1e-5;

/* A sphere that is off its place by more was put there by a command. */
static const double DISPLACED = 1e-3;

/* A sphere is at a wall, or at its last contact, within this length; one that is off the center of
 * mass by less is at it, since engines find that by random points. */
static const double NEAR = 0.01;

#ifdef __cplusplus
}
#endif
