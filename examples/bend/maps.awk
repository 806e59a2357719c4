# From the table of `asperity map` for the outer wall: means over its width: way along the wall / mm (in the bend from 0 to
# 196 mm), wear / um and deposits / kg per m^2, both per kg of dust.
#   awk -F, -v dust=MASS -f maps.awk TABLE > PROFILE
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { BEND = 125 * atan2(0, -1) / 2 }
/^#/ { next }
!n { for (k = 1; k <= NF; k++) column[$k] = k; n = 1; next }
{
  i = int((n++ - 1) / 20) # 20 faces across
  wear[i] += $column["erosion_depth_m"] / 20 * 1e6 / dust
  mass[i] += $column["deposited_mass_kg"] / dust
}
function start(i) { return i < 40 ? 6.25 * i - 250 : i < 90 ? BEND / 50 * (i - 40) : BEND + 5 * (i - 90) }
END {
  for (i = 0; i < (n - 1) / 20; i += 2)
    print (start(i) + start(i + 2)) / 2, (wear[i] + wear[i + 1]) / 2, (mass[i] + mass[i + 1]) / ((start(i + 2) - start(i)) * 0.05e-3)
}
