# From a dump: time / s, mean height / mm, root mean square of v_z, mean of v_x.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { STEP = 8e-6 }
function show() { if (n) print time, 1e3 * z / n, sqrt(w / n), u / n }
/^ITEM: TIMESTEP/ { show(); getline; time = $1 * STEP; n = z = w = u = 0; atoms = 0; next }
/^ITEM/ { atoms = /ITEM: ATOMS/; next }
atoms { n++; z += $4; w += $7 * $7; u += $5 }
END { show() }
