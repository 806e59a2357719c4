# From a dump: time / s, mean kinetic energy per mass / (m/s)^2, mean height over the drum's lowest point / mm.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { STEP = 1.5e-5; RADIUS = 50e-3 }
function show() { if (n) print time, e / n, 1e3 * (z / n + RADIUS) }
/^ITEM: TIMESTEP/ { show(); getline; time = $1 * STEP; n = z = e = 0; atoms = 0; next }
/^ITEM/ { atoms = /ITEM: ATOMS/; next }
atoms { n++; z += $4; e += ($5 * $5 + $6 * $6 + $7 * $7) / 2 }
END { show() }
