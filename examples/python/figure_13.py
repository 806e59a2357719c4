"""Figure 13 of Altmeppen et al. (2020) in Python: the scatter of the coefficients of restitution over
the impact angle. Each part between the lines %% is a cell, for editors that know them.

SPDX-License-Identifier: GPL-3.0-or-later
"""

# %% The wall and the particles. The spread is the paper's; without its words it is the default.
import matplotlib
import numpy as np

matplotlib.use("Agg")
import asperity
import matplotlib.pyplot as plt

WALL = "surface rq 4.8um lambda_c 120um materials ard hastelloy-x"
PAPER = "spread weibull plane collisions single"
SPEED = 100  # m/s

random = np.random.default_rng(1)
n = 20000
angles = random.uniform(0.5, 90, n)  # degrees
# Log-normal diameters of 1 to 100 um, with a median of 10 um.
d_p = 10e-6 * np.exp(np.log(100) / 5 * random.normal(size=3 * n))
d_p = d_p[(d_p > 1e-6) & (d_p < 100e-6)][:n]

# %% Impacts.
v1 = asperity.velocities(SPEED, np.radians(angles))
results = {}
for name, words in {"the paper": f"{WALL} {PAPER}", "default": WALL}.items():
    wall = asperity.Wall(words, d_p)
    hits = wall.impacts(v1, d_p)
    cor = asperity.coefficients(v1, hits)
    results[name] = cor, hits["outcome"] == 0

print(f"python: {wall.text}")
print(f"python: Phi_R {wall.surface()['phi_r']:.3g}, rms slope {wall.surface()['slope_rms']:.3g}; "
      f"a grain of 100 um meets {float(wall.slope(100e-6)):.3g}")
for name, (cor, rebounds) in results.items():
    steep, flat = rebounds & (angles > 80), rebounds & (angles < 10)
    print(f"python: {name}: {100 * np.mean(~rebounds):.0f} % stick; CoR_N > 1 in "
          f"{100 * np.mean(cor['cor_n'][flat] > 1):.0f} % of the rebounds below 10 deg, CoR_T < 0 in "
          f"{100 * np.mean(cor['cor_t'][steep] < 0):.0f} % above 80 deg")

# %% The picture: each impact, the median and the middle 68 % in intervals of 3 degrees (means do not
# settle where CoR_N or CoR_T divides by a speed near zero), and a smooth wall.
smooth = asperity.Wall("materials ard hastelloy-x")
line = np.linspace(1, 89, 89)
v_line = asperity.velocities(SPEED, np.radians(line))
hits = smooth.impacts(v_line, 10e-6)
smooth = asperity.coefficients(v_line, hits)

figure, axes = plt.subplots(2, 2, figsize=(10, 7), sharex=True, sharey="row", layout="constrained")
edges = np.arange(0, 91, 3)
middle = (edges[1:] + edges[:-1]) / 2
for column, (name, (cor, rebounds)) in enumerate(results.items()):
    for row, key in enumerate(("cor_n", "cor_t")):
        axis, y = axes[row, column], cor[key]
        cells = [y[rebounds & (angles >= a) & (angles < b)] for a, b in zip(edges, edges[1:])]
        low, median, high = np.transpose([np.percentile(cell, (16, 50, 84)) for cell in cells])
        axis.plot(angles[rebounds], y[rebounds], ".", ms=1.5, color="#c4d9e8", rasterized=True,
                  label="impacts")
        axis.fill_between(middle, low, high, color="#0072b2", alpha=0.35, lw=0, label="middle 68 %")
        axis.plot(middle, median, color="#0072b2", lw=2, label="median")
        axis.plot(line, np.where(hits["outcome"] == 0, smooth[key], np.nan), "--", color="#333333",
                  lw=2, label="smooth wall, 10 µm")
        axis.grid(color="#e0e0e0")
        axis.set_ylim((0, 3) if key == "cor_n" else (-1, 1.5))
    axes[0, column].set_title(f"{name} (Φ_R {wall.surface()['phi_r']:.2g})")
    axes[1, column].set_xlabel("impact angle α₁ (deg)")
axes[0, 0].set_ylabel("CoR_N")
axes[1, 0].set_ylabel("CoR_T")
axes[0, 1].legend(loc="upper right", markerscale=6)
figure.savefig("output/figure_13.png", dpi=100)
print("picture: output/figure_13.png")
