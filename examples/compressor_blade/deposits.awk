# Where the grains of a ledger stuck on the pressure side, for blade.gp: x y z / mm as the picture has them, diameter / um.
#   awk -f blade.awk -f deposits.awk smooth.csv > smooth.stuck
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { FS = ","; set_up() }
$19 == 1 && int($5 / 2) % LOOP >= NC { print $6 * 1e3, -$7 * 1e3, -$8 * 1e3 + 0.05, $9 * 1e6 }
