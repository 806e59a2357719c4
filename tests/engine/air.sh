#!/usr/bin/env bash
# The air of examples/pipe_flow: its own checks of drag, mean profile and random walk against closed forms pass, and find a
# drag and a drift that are off; a gas from a table gives what its closed form gives, and its slopes keep tracers mixed.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
cp "$here"/../../examples/pipe_flow/* . 2> /dev/null || true # not the folder output
./check "$bin" > passed || { cat passed; die "the checks of the air"; }

# off FILE FROM TO MESSAGE: with one number changed the checks fail, and say where.
off() {
  cp "$1" kept; sed "s/$2/$3/" kept > "$1"
  ! cmp -s kept "$1" || die "nothing to change in $1"
  ! ./check "$bin" > found || die "the checks do not see $2 as $3"
  grep -q "$4" found || { cat found; die "another complaint"; }
  mv kept "$1"
}
off air.in '0.15\*' '0.16*' 'drag is off'
off gas.pipe '7\.8\*' '7.7*' 'the mean profile is off'

# A table of the closed form of U, in 41 rows that lie closer near the wall: beads come to the same speeds.
u_tau=$(awk -f u_tau.awk -v R=0.075 -v nu=1.5e-5 -v Ub=27)
awk -v u_tau="$u_tau" 'BEGIN { print "# r/R,U"
  for (i = 0; i <= 40; i++) { q = 1 - (1 - i / 40) ^ 2 * 0.99 - 0.01 * (1 - i / 40); yp = (1 - q) * 0.075 * u_tau / 1.5e-5
    print q "," u_tau * (2.5 * log((1 + 0.4 * yp) * 1.5 * (1 + q) / (1 + 2 * q * q)) + 7.8 * (1 - exp(-yp / 11) - yp / 11 * exp(-0.33 * yp))) } }' > table.csv
{ grep -v '^variable U ' gas.pipe; awk -F, -f table.awk -v name=U -v of='f_at[1]' table.csv; } > gas.table
"$bin/lammps-asperity" -in in.pipe_flow -var name table -var u_tau "$u_tau" -var surface smooth -var beads output/carried.data \
  -var turbulence 0 -var g 0 -var slice 1 -var settle 0 -var steps 320 -var every 320 -var gas gas.table -log none > screen ||
  die "a gas from a table"
last() { awk '/ITEM: TIMESTEP/ { getline; step = $1 } NF == 7 && step == 320 { print $3, $4 }' "$1"; }
paste <(last output/carried.at.txt) <(last output/table.at.txt) | awk '{ n++; if ($4 > 1.005 * $2 || $4 < 0.995 * $2) { print; bad = 1 } } END { exit bad || n != 5 }' ||
  die "a gas from a table: other speeds than by its closed form"

# A table of s_n and its slope in place of the closed forms in the box: tracers stay mixed. Without the factor it is not so.
awk 'BEGIN { for (i = 0; i <= 16; i++) { q = i / 16 * 8 * atan2(1, 1); print q "," 1 + 0.5 * cos(q) } }' > table.csv
{ grep -v -e '^variable S ' -e '^variable s_n ' gas.box
  awk -F, -f table.awk -v name=s_n -v of=f_q table.csv
  awk -F, -f table.awk -v name=S -v of=f_q -v slope=1 -v length_=0.0047746483 table.csv; } > gas.table
"$bin/lammps-asperity" -in in.box -var name table -var drift 1 -var N 2000 -var gas gas.table -log none > screen || die "a box from a table"
awk '/^ITEM/ { atoms = /ITEM: ATOMS/; next } atoms { n[int($2 / 0.03 * 10 + 10) % 10]++; all++ }
  END { for (k = 0; k < 10; k++) if (n[k] * 10 / all > 1.1 || n[k] * 10 / all < 0.9) { print k, n[k] * 10 / all; bad = 1 } exit bad }' output/table.at.txt ||
  die "a gas from a table: tracers do not stay mixed"
