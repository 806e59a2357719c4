# Turns measured.csv (asperity trade --grid) into the rows of the table in auto.c.
BEGIN { FS = "," }
/^#/ { next }
$1 == "model" {
  for (i = 5; i <= NF; i++) {
    sub(/^kl_/, "", $i)
    angles = angles (i > 5 ? ", " : "") $i
  }
  printf "static const double angle[] = {%s};\n\nstatic const row rows[] = {\n", angles
  next
}
{
  printf "    {\"%s\", %d, %s, %s, {", $1, $2 == "multiple", $3, $4
  for (i = 5; i <= NF; i++)
    printf "%s%sf", (i > 5 ? ", " : ""), $i
  print "}},"
}
END { print "};" }
