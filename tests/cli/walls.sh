#!/usr/bin/env bash
# A wall is described in the same words to every command: sigma, rq with lambda_c and lay, profile, map with lay.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"

# A profile with flat peaks and deep valleys, 1000 lambda_c long; a map made of waves.
"$asperity" surface surface rq 5um lambda_c 40um --dp 10um --points 131072 --save fine > /dev/null
awk -F, 'NR < 3 || NR % 4 == 0' fine > gauss
awk -F, 'NR < 3 { print; next } { printf "%.9g,%.7g\n", $1, -6.5 * log(1 + exp(0.6 - 1.4 * $2 / 5)) }' gauss > plateau
waves() { # POINTS along each side, STRETCH along y
  awk -v n="$1" -v stretch="$2" 'BEGIN { srand(5); pi = 3.14159265358979
    for (k = 0; k < 300; k++) { r = sqrt(-2 * log(1 - rand())) * sqrt(2) / 12; w = 2 * pi * rand()
      a[k] = r * cos(w); b[k] = r * sin(w) / stretch; c[k] = 2 * pi * rand() }
    print "# Width: " 2 * n " um\n# Height: " 2 * n " um\n# Value units: um"
    for (j = 0; j < n; j++) for (i = 0; i < n; i++) { z = 0; for (k = 0; k < 300; k++) z += 0.1225 * cos(2 * a[k] * i + 2 * b[k] * j + c[k])
      printf "%.7g%s", z, i < n - 1 ? " " : "\n" } }'
}
waves 112 1 > map
waves 96 3 > laid

# The mean tilt of the first hits by every way to give the wall: slope sqrt(2) rq / lambda_c, small particles.
mean() { "$asperity" spread "$@" --angles 20 --summary --samples 20000 | awk -F, 'END { print $3 }'; }
near() { awk -v a="$2" -v b="$3" -v d="$4" 'BEGIN { exit !(a - b < d && b - a < d) }' || die "$1: $2, not $3"; }
sigma=$(awk 'BEGIN { print atan2(sqrt(2) * 5 / 40, 1) * 57.29577951 }')
near "--rq" "$(mean surface rq 5um lambda_c 40um --dp 10nm)" "$(mean surface sigma "$sigma")" 0.01
near "--sigma of a model that looks at a profile" "$(mean surface sigma "$sigma" spread traced)" "$(mean surface sigma "$sigma")" 0.3
near "--profile" "$(mean surface profile gauss --dp 20um)" "$(mean surface rq 5um lambda_c 40um --dp 20um)" 0.4
# 8 R_q over 1000 lambda_c of 40 um with R_q 5 um: 0.0573 degrees.
steepened() { "$asperity" "$1" surface profile gauss spread "$2" --dp 20um --angles "$3" --samples 9 2>&1 > /dev/null | grep 'warning: --angles'; }
steepened cor traced 0.05 | grep -q '^asperity: warning: --angles: 0.05 degrees .* below 0.05[67]' || die "cor: no warning of a low angle: $(steepened cor traced 0.05)"
steepened spread traced 0.05 > /dev/null || die "spread: no warning of a low angle"
! steepened cor traced 0.06 || die "cor: a warning of an angle that is not steepened"
! steepened cor visible 0.05 || die "cor: a warning of a model that steepens no angle"
near "--lay" "$(mean surface rq 5um lambda_c 40um 120um lay 0 --dp 10nm)" "$(mean surface rq 5um lambda_c 120um --dp 10nm)" 0.01
numbers=$("$asperity" surface surface map map --dp 5um | awk -F, 'END { print $2 "um lambda_c " $3 "um" }')
near "--map" "$(mean surface map map --dp 5um)" "$(mean surface rq $numbers --dp 5um)" 0.8

# Over a map as short as this, flights one way and back differ by the height from edge to edge.
both() { echo "$1 $2" | awk '{ print ($1 + $2) / 2 }'; }
tilt() { mean surface map laid lay "$1" --dp 5um; }
across=$(both "$(tilt 90)" "$(tilt -90)") along=$(both "$(tilt 0)" "$(tilt 180)")
steeper() { awk -v a="$2" -v b="$3" 'BEGIN { exit !(a > 2 * b && b > 0.2) }' || die "$1: across the lay $2, along it $3"; }
steeper "--map --lay" "$across" "$along"
impacts() { "$asperity" cor surface map laid lay "$1" --dp 5um --angles 20 --samples 4000 | column delta_alpha_deg /dev/stdin | awk '{ sum += $1 } END { print sum / NR }'; }
steeper "cor --map --lay" "$(both "$(impacts 90)" "$(impacts -90)")" "$(both "$(impacts 0)" "$(impacts 180)")"

# The other commands take a wall that `surface` has repaired.
"$asperity" surface surface map map --dp 5um --form 2 --save mended > /dev/null
"$asperity" surface surface map mended --dp 5um --form none > again
[ "$(tail -n 1 again)" = "$("$asperity" surface surface map map --dp 5um --form 2 | tail -n 1)" ] || die "surface --map --save: $(cat again)"

# trade by a profile: the flight over the plateau is the reference, a Gaussian wall with its numbers is far from it.
"$asperity" trade surface profile plateau --dp 5um --angles 10 --rays 30000 > long 2> err || die "trade --profile: $(cat err)"
awk -F, '$1 == "traced" && $5 < 0.002 && $6 > 0 { good++ } $1 == "visible" && $5 > 0.03 { good++ } END { exit good != 2 }' long || die "trade --profile: $(cat long)"
"$asperity" trade surface sigma 10 --angles 20 --rays 8000 --ensemble 4 --plot trade.svg > rows 2> err || die "trade --sigma: $(cat err)"
awk -F, '$1 == "visible" && $5 < 0.01 { good++ } END { exit !good }' rows && grep -q 'Pareto front' trade.svg || die "trade --sigma: $(cat rows)"

# calibrate finds the friction that cor had, on the same wall.
for wall in "sigma 8" "rq 5um lambda_c 40um 90um lay 20" "profile plateau" "map map"; do
  "$asperity" cor surface $wall friction 0.17 deposit off --dp 5um --angles 30,60 --samples 300 -o data || die "cor surface $wall"
  "$asperity" calibrate data surface $wall materials ard hastelloy-x friction fit deposit off --dp 5um --samples 1000 > fit || die "calibrate surface $wall"
  awk -F, -v wall="$wall" '$1 == "friction" { exit !(($2 - 0.17) ^ 2 < (4 * $3) ^ 2 && $3 < 0.02) }' fit || die "calibrate surface $wall: $(cat fit)"
done
grep -q '# description, .* surface map map spread traced ' fit || die "calibrate surface map: the description: $(cat fit)"

refuses_rows walls
exit 0
