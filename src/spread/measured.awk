# Turns measured.csv (tests/sweep/grid.c) into the rows of the table in auto.c.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { FS = "," }
/^#/ { next }
$1 == "model" {
  printf "enum { ANGLES = %d };\n\n", (NF - 4) / 2
  print "typedef struct row {"
  print "  const char *model;"
  print "  int multiple;"
  print "  double phi_r, kappa;"
  print "  /* D_KL of the rebound angle and its standard error, by impact angle */"
  print "  float kl[ANGLES][2];"
  print "} row;\n"
  print "static const row rows[] = {"
  next
}
{
  printf "    {\"%s\", %d, %s, %s, {", $1, $2 == "multiple", $3, $4
  for (i = 5; i < NF; i += 2)
    printf "%s{%sf, %sf}", (i > 5 ? ", " : ""), $i, $(i + 1)
  print "}},"
}
END { print "};" }
