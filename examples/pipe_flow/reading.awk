# The table of the runs beside what the published simulations miss the measurement by.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { FS = ","; printf "%-10s %16s %16s %16s %16s %12s\n", "rms off by", "U_p", "u'", "d", "impacts per bead", "mean height" }
$1 == "case" { next }
{ printf "%-10s  %6.4f +- %6.4f %6.4f +- %6.4f %6.4f +- %6.4f %12.1f 1/s %+8.2f R\n", $1, $2, $3, $4, $5, $6, $7, $8, $9 }
END { printf "%-10s %16s %16s %16s\n", "published", "0.038 to 0.075", "0.085 to 0.087", "0.043 to 0.071"
  print "mean height: of the second half of the means less that of the first; what is not zero still settles" }
