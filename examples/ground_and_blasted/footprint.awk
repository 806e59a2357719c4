# Where each grain passes a screen 10 mm over its plate, from where it hit (mm along the jet and across it), and its
# rebound and lateral angles: from the dump of the last step.   awk -v plate=1 -f footprint.awk end.dump   (2: blasted)
# Grains that come off flatter than 3 degrees pass it beyond 190 mm and are left out.
# SPDX-License-Identifier: GPL-3.0-or-later
function degrees(x) { return x * 180 / atan2(0, -1) }
/^ITEM: TIMESTEP/ { getline step; next }
/^ITEM: ATOMS/ { atoms = 1; next }
/^ITEM/ { atoms = 0; next }
!atoms || step < 2000 || $1 % 2 != plate % 2 || $7 <= 0 { next }
{
  speed = sqrt($5 * $5 + $6 * $6 + $7 * $7); s = $6 / speed
  a2 = degrees(atan2($7, $5)); side = degrees(atan2(s, sqrt(1 - s * s)))
  if (a2 > 3 && a2 < 177) printf "%.4f %.4f %.4f %.4f\n", 10 * $5 / $7, 10 * $6 / $7, a2, side
}
