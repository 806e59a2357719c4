# Turns first_hits.csv (the target first_hits) into the table in ensemble.c: the slopes of a row,
# behind phi_r, kappa, a, and the mean with its error, for which a reader looks into the CSV.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { FS = ","; print "static const float slope[] = {" }
/^#/ || $1 == "phi_r" { next }
{
  printf "    "
  for (i = 6; i <= NF; i++)
    printf "%sf,%s", $i ~ /\./ ? $i : $i ".0", i < NF ? " " : "\n"
}
END { print "};" }
