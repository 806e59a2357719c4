# Turns measured.csv (asperity trade --grid) into the rows of the table in auto.c.
BEGIN { FS = "," }
/^#/ { next }
$1 == "model" {
  for (i = 6; i <= NF; i++) {
    sub(/^kl_/, "", $i)
    angles = angles (i > 6 ? ", " : "") $i
  }
  printf "static const double angle[] = {%s};\n\nstatic const row rows[] = {\n", angles
  next
}
{
  printf "    {\"%s\", %d, %s, %s, %s, {", $1, $2 == "multiple", $3, $4, $5
  for (i = 6; i <= NF; i++)
    printf "%s%sf", (i > 6 ? ", " : ""), $i
  print "}},"
}
END { print "};" }
