#!/usr/bin/env bash
# Numbers on the pages that stand beside a command of a second or less: the command, run as it is written there, gives
# them.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"

# The page has the command, and the words that the awk program makes of its table. EDIT is a sed program: what the page
# changes in the command for this number.
gives() { # PAGE COMMAND AWK [EDIT]
  local text words command
  text=$(tr -s '\n ' '  ' < "$root/$1")
  grep -qF -- "asperity $2" <<< "$text" || die "$1 has no asperity $2"
  command=$(sed "s/ --plot [^ ]*//; ${4:-}" <<< "$2")
  words=$(cd "$root" && eval "'$asperity' $command" 2> /dev/null | awk -F, "$3")
  [ -n "$words" ] && grep -qF -- "$words" <<< "$text" || die "$1 has no '$words', which is what asperity $command gives"
}

page=examples/paper_figures/README.md
gives $page "surface surface rq 5um lambda_c 40um --dp 55um --plot f.png" \
  '/^[0-9]/ { printf "rms slope %.3f, σ %.1f°", $6, $7 }'
cor="spread weibull plane collisions single materials ard hastelloy-x --dp lognormal:1um:100um:10um --speed 100 --samples 200 --plot f.png"
gives $page "cor surface rq 4.8um lambda_c 120um $cor" '
  $10 == "rebound" { if ($3 < 10) { n++; over += $8 > 1 } if ($3 > 80 && $9 != "") { m++; below += $9 < 0 } }
  END { printf "CoR_N > 1 in %.0f %% of the rebounds below 10°, CoR_T < 0 in %.0f %% above 80°", 100 * over / n, 100 * below / m }'
gives $page "cor surface rq 4.8um lambda_c 120um $cor" '
  $10 == "rebound" { if ($3 < 10) { n++; over += $8 > 1 } if ($3 > 80 && $9 != "") { m++; below += $9 < 0 } }
  END { printf "%.0f %% and %.0f %%", 100 * over / n, 100 * below / m }' 's/4.8um/15.6um/'
gives $page "cor surface rq 15.6um lambda_c 120um spread weibull plane collisions single --dp 10um --angles 5,85 --samples 1000" '
  $10 == "rebound" && $3 == 5 && $8 > n { n = $8; dn = $4 } $10 == "rebound" && $3 == 85 && $9 < t { t = $9; dt = $4 }
  END { printf "at 5° a face of %+.0f° gives CoR_N %.1f; at 85° one of %+.0f° gives CoR_T −%.1f", dn, n, dt, -t }'

page=src/spread/from_fluent.md
cor="cor surface sigma 2.57 rebound walton 0.9 0.3 0 --dp 10um --speed 100 --angles 10 --samples 400000 --summary"
mean='/^[0-9]/ { printf " | %.3f | %.3f |", $7, $9 }'
gives $page "$cor" "$mean" 's/sigma 2.57/smooth/; s/400000/1/'
gives $page "$cor" "$mean"
gives $page "$cor" "$mean" 's/2.57/10.02/'
gives $page "surface surface rq 5um rsm 226.8um sampling 0.25mm --dp 10um" '/^[0-9]/ { printf "λ_c %.1f µm", $3 }'
gives $page "surface surface rq 5um lambda_c 40um --dp 10um" '/^[0-9]/ { printf "counts %.3f", $6 }'

page=src/wall/models.md
cor="cor materials quartz hastelloy-x rebound bons yield_rate 3e6 --angles 90 --samples 1"
gives $page "$cor" '/^[0-9]/ { printf "CoR_N(90°) %.2f", $8 }'
gives $page "$cor" '/^[0-9]/ { printf "to %.2f for 10 µm quartz", $8 }' 's/3e6/3.6e6/'
hot="cor materials quartz hastelloy-x rebound bons temperature 1300 --angles 90 --samples 1"
gives $page "$hot" '/^[0-9]/ { printf "CoR_N %.3f for 10 µm at 100 m/s", $8 }'
gives $page "$hot" '/^[0-9]/ { printf "%.3f without `temperature 1300`", $8 }' 's/ temperature 1300//'
wear="cor surface sigma 5 erosion dnv face tilted rebound walton 0.9 0.3 0 --angles 2,5,10,20,30,45,60,90 --samples 20000 --summary"
edit="s/sigma 5/sigma 10/; s/dnv/oka 1.8GPa density 7800kg\/m3/"
(cd "$root" && eval "'$asperity' $(sed "$edit; s/tilted/mean/" <<< "$wear")") 2> /dev/null > mean.csv
gives $page "$wear" 'BEGIN { while ((getline < "'"$work"'/mean.csv") > 0) if (/^[0-9]/) mean[$3] = $11 }
  /^[0-9]/ { printf "%s%.2f", $3 == 2 ? "`oka` 10° | " : " | ", $11 / mean[$3] }' "$edit"

page=src/wall/from_a_drawing.md
cor="cor surface ra 4um rdq 3deg materials quartz hastelloy-x --dp 20um --angles 10,45 --samples 20000 --summary"
four='/^[0-9]/ { printf " | %.3f | %.3f", $7, $9 }'
gives $page "$cor" "$four"
gives $page "$cor" "$four" 's/3deg/15deg/'
