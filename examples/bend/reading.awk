# One wall's results, in numbers: from the log, the maps' means over the width, the ledger, and the grains that leave
# (columns: time, rank, diameter, velocity). The speed of the grains over their diameter goes to the file SPEEDS.
#   awk -v name=NAME -v speeds=FILE -f reading.awk LOG PROFILE LEDGER OUTLET
# SPDX-License-Identifier: GPL-3.0-or-later
FNR == 1 { file++ }
file == 1 && /parcels added/ { grains = $NF }
file == 1 && /mass introduced/ { dust = $NF }
file == 1 && /Current number of parcels/ { left = $NF }
file == 2 { if ($2 > most) { most = $2; at = $1 } }
file == 3 && /^[0-9]/ { split($0, row, ","); hits++; flat += row[11] < 5; if (row[19] == 2) { deposits++; mass += 3.14159265 / 6 * 2650 * row[9] ^ 3 } }
file == 4 && /^[0-9]/ {
  gsub(/[()]/, "")
  b = int(log($3 / 1e-6) / log(2)); n[b]++; u[b] += $5; uu[b] += $5 * $5; d[b] += $3
}
END {
  if (left) { print "bend: " left " grains are still in the duct" > "/dev/stderr"; exit 1 }
  printf "%-9s %8.2f %13.1f %% %10.1f %% %10.1f %% %10.2f at %2.0f degrees", name, hits / grains, 100 * flat / hits,
    100 * deposits / grains, 100 * mass / dust, most, at < 0 ? 0 : at / 196.35 * 90
  for (b = 0; b < 7; b++) if (n[b] > 100) {
    mean = u[b] / n[b]; se = sqrt((uu[b] / n[b] - mean * mean) / n[b])
    print d[b] / n[b] * 1e6, mean, se, n[b] > speeds
    if (b >= 3 && b < 6) printf " %6.2f +- %.2f", mean, se
  }
  print ""
}
