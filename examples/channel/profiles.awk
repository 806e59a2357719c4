# From a dump to what depends on height, over the second half of the run (t > 0.5 s): for each of 20 layers its
# height / channel height, concentration / mean concentration, root mean square of v_z, mean v_x, number.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { HEIGHT = 30e-3; LAYERS = 20; STEP = 8e-6 }
/^ITEM: TIMESTEP/ { getline; late = $1 * STEP > 0.5; frames += late; next }
/^ITEM/ { atoms = /ITEM: ATOMS/; next }
atoms && late {
  k = int($4 / HEIGHT * LAYERS); n[k]++; w[k] += $7 * $7; u[k] += $5; all++
}
END { for (k = 0; k < LAYERS; k++) if (n[k] > 20) print (k + 0.5) / LAYERS, n[k] * LAYERS / all, sqrt(w[k] / n[k]), u[k] / n[k], n[k] }
