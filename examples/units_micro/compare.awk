# Two ledgers of the same impacts, row by row, micro's brought to SI: the largest relative difference of each column.
#   awk -f compare.awk si.csv micro.csv
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN {
  FS = ","
  factor[3] = 1e-6                                             # us to s
  factor[6] = factor[7] = factor[8] = factor[9] = 1e-6         # um to m
}
/^#/ { next }
$1 == "tag" { for (i = 1; i <= NF; i++) name[i] = $i; columns = NF; next }
NR == FNR { for (i = 1; i <= NF; i++) si[$1, $2, i] = $i; outcome[$1, $2] = $19; first++; next }
{
  second++
  if (!(($1, $2) in outcome)) { missing++; next }
  for (i = 1; i <= NF; i++) {
    a = si[$1, $2, i]; b = $i * (i in factor ? factor[i] : 1)
    d = a - b; if (d < 0) d = -d
    size = a < 0 ? -a : a; if (size < 1e-9) size = 1e-9
    if (d / size > most[i]) most[i] = d / size
  }
  different += $19 != outcome[$1, $2]
}
END {
  printf "%d impacts in si, %d in micro, %d without a match, %d with another outcome\n", first, second, missing, different
  printf "largest relative difference:"
  for (i = 9; i <= columns; i++) if (i != 14 && i != 19) printf " %s %.0e", name[i], most[i]
  print ""
  exit missing + different + (first != second) + (most[17] > 1e-6) + (most[18] > 1e-6) > 0
}
