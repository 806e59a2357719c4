#!/usr/bin/python3
"""What the default leaves out, in numbers: skewed heights, and spin from the impact before. Needs NumPy.

ASPERITY_BIN=build/bin PYTHONPATH=src/python /usr/bin/python3 tests/sweep/left_out.py

Heights are c (exp(0.3116 z) - mean) of Gaussian z, whose skew is 1 on the average, with R_q 5 um and lambda_c 40 um (that of z
is chosen for that, by the autocorrelation of a log-normal process), and the same upside down; 2048 lambda_c of them.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import tempfile
import warnings

import numpy as np
import asperity

warnings.simplefilter("ignore")  # summits of these heights look like dust to the reader
DUST = "materials quartz hastelloy-x"
N = 40000


def mean(wall, degrees, of, **grains):
    v1 = asperity.velocities(100, np.full(N, np.radians(degrees)))
    hits = wall.impacts(v1, 20e-6, **grains)
    return np.nanmean(asperity.coefficients(v1, hits)[of]), hits


print("skew,cor_n at 2 degrees,over that of skew 0,at 10 degrees,over that of skew 0")
rng, step, slow = np.random.default_rng(3), 40 / 64, 0.3116
k = 2 * np.pi * np.fft.rfftfreq(1 << 17, step)
noise = np.fft.rfft(rng.standard_normal(1 << 17))
plain = None
for sign in (0, -1, 1):
    length = 40 if sign == 0 else 40 / np.sqrt(-np.log(np.log1p(np.expm1(slow ** 2) / np.e) / slow ** 2))
    z = np.fft.irfft(noise * np.exp(-(k * length) ** 2 / 8))
    z = (z - z.mean()) / z.std()
    z = z if sign == 0 else sign * np.exp(slow * z)
    z = 5 * (z - z.mean()) / z.std()
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
        np.savetxt(file, np.column_stack([np.arange(len(z)) * step, z]), "%.5f", ",", header="x_um,z_um", comments="")
        file.flush()
        wall = asperity.Wall(f"surface profile {file.name} {DUST}", (20e-6, 20e-6))
    found = np.array([mean(wall, degrees, "cor_n")[0] for degrees in (2, 10)])
    plain = found if plain is None else plain
    print(f"{(z ** 3).mean() / 125:.2f},{found[0]:.3f},{found[0] / plain[0]:.3f},{found[1]:.3f},{found[1] / plain[1]:.3f}")

print("angle,cor_t,with the spin of an impact before at the same angle")
wall = asperity.Wall(f"surface rq 5um lambda_c 40um rebound bons spin on {DUST}")
for degrees in (10, 20, 30, 45, 60, 75):
    _, before = mean(wall, degrees, "cor_t")
    print(f"{degrees},{mean(wall, degrees, 'cor_t', impact=2)[0]:.3f},"
          f"{mean(wall, degrees, 'cor_t', impact=2, omega=before['omega'])[0]:.3f}")
