#!/usr/bin/env bash
# erosion: the law on a ledger's rows wears off what the impacts of `cor` do; sums of triangles, meshes and all of more
# rows than it holds at once, in a ledger's units; what is refused.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"

# Each law, at two sizes, against what `cor` has of the same impacts per mass of particles.
for law in "dnv k 3e-9" "oka 1.8GPa particles glass density 7800kg/m3" "finnie 1GPa density 7800kg/m3" "ecrc 120"; do
  for d in 10 40; do
    of=(surface sigma 5 erosion $law rebound walton 0.9 0.3 0 --dp ${d}um --angles 20,50 --samples 30)
    "$asperity" cor "${of[@]}" --summary -o summary
    "$asperity" cor "${of[@]}" --columns ledger -o ledger
    "$asperity" erosion ledger erosion $law --density 2500kg/m3 -o worn
    column eroded_mean summary | awk -v worn="$(column eroded_mass_kg worn | tail -n 1)" -v d=${d}e-6 '{ sum += 30 * $1 * 2500 * 3.14159265358979 / 6 * d ^ 3 }
      END { exit !(NR == 2 && sum > 0 && (worn / sum - 1) ^ 2 < 1e-10) }' || die "$law, $d um: $(cat summary worn)"
  done
done

# 30 000 rows of 10 000 triangles, in grams.
awk 'BEGIN { print "# asperity 1.0.0; fix wall wall/rebound; units cgs; surface smooth erosion dnv face mean seed 1\ntag,mesh,triangle,eroded_mass"
  for (i = 0; i < 30000; i++) print i "," 1 + i % 2 "," i % 10000 "," 1 + i % 10000 }' > many
"$asperity" erosion many -o sums
rows sums | awk -F, '$2 != "all" { n++; if ($1 != 1 + $2 % 2 || $3 != 3 || ($4 - 3e-3 * (1 + $2)) ^ 2 > 1e-16 || ($1 == last && $2 <= id)) exit 1; last = $1; id = $2 }
  END { exit n != 10000 }' || die "sums of triangles: $(head sums)"
[ "$(header sums)" = mesh,triangle,impacts,eroded_mass_kg ] || die "header: $(header sums)"
[ "$(grep all sums | paste -sd' ')" = "1,all,15000,75000 2,all,15000,75015 all,all,30000,150015" ] || die "sums: $(grep all sums)"
[ "$("$asperity" erosion - < many | grep all)" = "$(grep all sums)" ] || die "a ledger in a pipe"

# Densities that nobody states are those of the heading's materials; the output names the law, and no surface.
"$asperity" cor surface sigma 5 rebound bons materials quartz steel deposit off --dp 20um --angles 30 --samples 20 --columns ledger -o of_steel
"$asperity" erosion of_steel erosion oka 1.8GPa -o worn
"$asperity" erosion of_steel erosion oka 1.8GPa materials quartz steel | tail -n 1 | cmp - <(tail -n 1 worn) || die "the heading's materials: $(cat worn)"
grep -q '^# .*; erosion oka [^;]*$' worn && ! grep -q surface worn || die "heading of erosion: $(head -n 1 worn)"
sed '1s/ materials quartz steel//g' of_steel > of_what

# A column that compare does not read may hold anything.
sed 's/^tag,/mass,/; s/^[0-9]*,/light,/' ledger > light
"$asperity" compare light | rows /dev/stdin | cmp - <("$asperity" compare ledger | rows /dev/stdin) || die "compare reads the mass"

# What a ledger, or the description, lacks.
awk '!n++ { print "# asperity 1.0.0; fix wall wall/rebound; units lj; surface smooth" } { print }' ledger > lj
cut -d, -f2- many > no_mesh; sed -i 's/^mesh/of/' no_mesh
sed '1s/ erosion dnv face mean//' many > unworn
refuses 2 "oka is '1.8', i.e. 1.8 Pa; did you mean 1.8GPa?" -- erosion ledger erosion oka 1.8
refuses_rows erosion
