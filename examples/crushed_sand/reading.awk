# The table of the page, from output/*.mean: means with standard errors, and standard deviations (their standard error is
# about sd/sqrt(2n)).
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { split("10 30 60 90", shown, " ") }
FNR == 1 { name[++files] = FILENAME; sub(/.*\//, "", name[files]); sub(/\.mean/, "", name[files]) }
{ for (k = 2; k <= NF; k++) of[files, $1, k] = $k }
function row(what, at, sdat,   a, f, i) {
  for (i = 1; i <= (at == 5 ? 3 : 4); i++) {
    a = shown[i]
    printf "%-6s %2d deg", what, a
    for (f = 1; f <= files; f++)
      printf "   %6.3f +- %.3f  sd %.3f", of[f, a, at], of[f, a, sdat] / sqrt(of[f, a, 2]), of[f, a, sdat]
    print ""
  }
}
END {
  printf "%-13s", ""
  for (f = 1; f <= files; f++) printf "   %-25s", name[f]
  print ""
  row("CoR_N", 3, 4); row("CoR_T", 5, 6)
  for (f = 1; f <= files; f++) {
    h = e = m = 0; split("", d)
    for (a = 10; a <= 90; a += 10) { h += of[f, a, 7] / 9; e += of[f, a, 8] / 9; for (k = 3; k <= 6; k++) d[k] += (of[f, a, k] - of[1, a, k]) ^ 2 / 9 }
    printf "%s: %.2f impacts per grain, %.3f of the energy of flight left; rms difference from %s: CoR_N %.3f, its sd %.3f\n", name[f], h, e, name[1], sqrt(d[3]), sqrt(d[4])
  }
}
