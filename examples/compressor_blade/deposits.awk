# Where the grains of a ledger stuck: position along the chord (negative: suction side), span / mm, diameter
# / um, number of the impact, x y z / mm.
#   awk -f blade.awk -f deposits.awk smooth.csv > smooth.deposits
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { FS = ","; set_up() }
$19 == 1 {
  i = int($5 / 2) % LOOP
  section($7 / SPAN * NS)
  ex = PX[i + 1] - PX[i]; ez = PZ[i + 1] - PZ[i]
  f = (($6 - PX[i]) * ex + ($8 - PZ[i]) * ez) / (ex * ex + ez * ez)
  print position(i) + f * (position(i + 1) - position(i)), $7 * 1e3, $9 * 1e6, $2, $6 * 1e3, $7 * 1e3, $8 * 1e3
}
