#!/usr/bin/env bash
# Every command in the Examples of the fix's page runs as it stands there, and so does the whole script of README.md, or of
# the page; and the
# page, or that of both engines, has every keyword in a table.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
page=$here/../../src/liggghts/fix_wall_rebound.md
[ $simulator = liggghts ] || page=$here/../../src/lammps/fix_wall_rebound.rst
if [ $simulator = liggghts ]; then
  awk '/^## Examples/ { on = 1; next } /^## / { on = 0 } on && /^```/ { code = !code; next } on && code' "$page"
else
  awk '/^Examples/ { on = 1; next } /^Description/ { on = 0 } on && /^   / { sub(/^   /, ""); print }' "$page"
fi | awk '{ sub(/^ +/, " "); if (sub(/&$/, "")) { line = line $0; next } print line $0; line = "" }' > examples
[ "$(wc -l < examples)" -ge 4 ] || die "the page has $(wc -l < examples) examples"
plate 3 1 1.9e-3 > blade.stl
sed 's/vertex \(.*\) 0$/vertex \1 5e-4/' blade.stl > hub.stl
number=0
while read -r line; do
  number=$((number + 1))
  { head_of si
    echo "region box block -0.002 0.002 -0.002 0.002 -0.001 0.002 units box
create_box 2 box
neighbor 1e-4 bin
create_atoms 1 single 0 0 2e-4 units box
set group all diameter 1e-5 density 2650
velocity all set 10 0 -50 units box
group dust type 1
fix blade all mesh/surface file blade.stl type 2
fix hub all mesh/surface file hub.stl type 2
region hopper block -0.002 0.002 -0.002 0.002 0 0.002 units box
region drum cylinder x 0 1e-3 1e-3 INF INF units box
fix move all nve/sphere
timestep 5e-8"
    materials
    echo "$line
thermo_style custom step f_wall
run 200"; } > example.in
  engine 2 example.in
  law=$(grep -oE ' rebound [a-z_]+' <<< "$line" || echo " rebound bons")
  grep -q "fix wall wall/rebound: surface .*$law" example.in.screen || die "the log does not name '${law# }': $line"
  if ! grep -q xcylinder <<< "$line"; then
    grep -E '^ +200 ' example.in.screen | awk '{ exit !($2 >= 1) }' || die "no impact: $line"
  fi
done < examples

# The whole script runs as it stands there, without a warning: that of LAMMPS in README.md, that of LIGGGHTS on the page.
kind=sphere; [ $simulator != liggghts ] || kind=granular
awk -v kind=$kind '/^```/ { if (text ~ "atom_style +" kind) printf "%s", text; text = ""; next } { text = text $0 "\n" }' \
  "$here/../../README.md" "$here/../../src/liggghts/fix_wall_rebound.md" > readme.in
"$bin/$simulator-asperity" -in readme.in -log none > readme.screen 2>&1 || die "the script of README.md: $(tail -n 3 readme.screen)"
if grep WARNING readme.screen; then die "the script of README.md warns"; fi
grep -qE '^ +600 +2795 +2800 +60 *$' readme.screen || die "the script of README.md has other impacts"

# The lines of air on the page of pipe_flow bring grains of 10 and 20 um to the speeds of closed forms, to the error of the
# step (the first block has the drag of 10 um for both): U (1 - exp(-t/tau)) with U 20 m/s, and in the second block 20 and 15 m/s.
for block in viscous variable; do
  awk -v block=$block '/^```/ { if (text ~ "fix gas" && (text ~ "fix drag") == (block == "viscous")) printf "%s", text; text = ""; next } { text = text $0 "\n" }' \
    "$here/../../examples/pipe_flow/README.md" > air
  [ "$(wc -l < air)" -ge 2 ] || die "no lines of air: $block"
  { head_of si
    echo "atom_modify sort 0 0
region box block -0.05 0.05 -0.012 0.012 -0.012 0.012 units box
create_box 1 box
neighbor 4e-4 bin
create_atoms 1 single 0 0 0 units box
create_atoms 1 single 0 0.005 0 units box
set group all diameter 10e-6
set atom 2 diameter 20e-6
set group all density 2650
fix move all nve/sphere"
    cat air
    echo "timestep 4e-6
dump now all custom 250 now.txt id vx
run 250"; } > air.in
  engine 1 air.in
  awk -v block=$block 'NF == 2 && $1 ~ /^[12]$/ { v[$1] = $2 } END { for (i = 1; i <= 2; i++) { tau = 2650 * (i * 10e-6) ^ 2 / (18 * 1.8e-5)
    if (block == "viscous") tau = 8.179e-4 * i ^ 3
    want = (i == 2 && block != "viscous" ? 15 : 20) * (1 - exp(-1e-3 / tau)); if ((v[i] / want - 1) ^ 2 > 4e-5) { print i, v[i], want; bad = 1 } } exit bad }' now.txt || die "the air of the page: $block"
done

# So does the script of the page of clumps: its text block with "atom_style KIND", beside the molecule's file.
page_of_clumps=$here/../../src/wall/bodies.md
awk '/^```/ { if (text ~ "Diameters") printf "%s", text; text = ""; next } { text = text $0 "\n" }' "$page_of_clumps" > dumbbell.mol
awk -v kind=$kind '/^```/ { if (text ~ "atom_style +" kind) printf "%s", text; text = ""; next } { text = text $0 "\n" }' \
  "$page_of_clumps" | sed 's/^run .*/run 4000/' > clumps.in
"$bin/$simulator-asperity" -in clumps.in -log none > clumps.screen 2>&1 || die "the script of clumps: $(tail -n 3 clumps.screen)"
grep -E '^ +4000 +400 ' clumps.screen | awk '{ exit !($3 >= 100) }' || die "the script of clumps has other impacts"

# The words that the fix knows are those of the tables.
wall='mesh n_meshes 1 meshes blade'
[ $simulator = liggghts ] || wall='stl blade.stl'
sed "s,^fix wall .*,fix wall all wall/rebound $wall nonsense," example.in > words.in
if "$program" -in words.in -log none > words.screen 2>&1; then die "nonsense is a keyword"; fi
words=$(sed -n "s/.*'nonsense' is unknown; there are: \([a-z_ ]*\).*/\1/p" words.screen)
[ "$(wc -w <<< "$words")" -ge 10 ] || die "the fix names $words"
[ $simulator = liggghts ] || words+=' shear type scale move'
for word in $words; do
  grep -qF -e "   * - \`\`$word\`\`" -e "| \`$word\` |" "$page" "$here/../../src/dem/fix.md" || die "the page has no table with '$word'"
done
