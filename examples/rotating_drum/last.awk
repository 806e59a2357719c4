# From a dump: x and z / mm, and speed of each grain in the last frame.
# SPDX-License-Identifier: GPL-3.0-or-later
/^ITEM: TIMESTEP/ { n = 0 }
/^ITEM/ { atoms = /ITEM: ATOMS/; next }
atoms { line[n++] = 1e3 * $2 " " 1e3 * $4 " " sqrt($5 * $5 + $6 * $6 + $7 * $7) }
END { for (i = 0; i < n; i++) print line[i] }
