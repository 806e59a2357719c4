#!/usr/bin/env python3
"""The lever S whose mean of q = m r_t.I^-1 r_t is that of a clump: lever.py grain.txt

A clump in a random position touches a level wall with its lowest sphere. Of eccentric spheres the mean of q is 20 S^2.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import numpy as np

rng = np.random.default_rng(1)
x, d = np.split(np.loadtxt(sys.argv[1], skiprows=2), [3], axis=1)

# Center of mass and inertia per mass of what the spheres cover, by points.
points = rng.uniform((x - d / 2).min(0), (x + d / 2).max(0), (2_000_000, 3))
points = points[(np.linalg.norm(points[:, None] - x, axis=2) < d[:, 0] / 2).any(1)]
center = points.mean(0)
second = np.cov(points.T)
inverse_inertia = np.linalg.inv(np.trace(second) * np.eye(3) - second)

down = rng.normal(size=(200_000, 3))
down /= np.linalg.norm(down, axis=1, keepdims=True)
lowest = np.argmax(down @ (x - center).T + d[:, 0] / 2, axis=1)
arm = np.cross(x[lowest] - center, down)
q = np.einsum("ni,ij,nj->n", arm, inverse_inertia, arm)
print(f"{np.sqrt(q.mean() / 20):.3f} {np.mean((1 - q) / (1 + q)):.3f}")
