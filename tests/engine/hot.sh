#!/usr/bin/env bash
# Grains that each have a temperature, by a property of the engine: those that stick at a wall without adhesion are a share
# of min(1, mu_c/mu(T)), within the error of counting; the ledger has the temperature. The same bytes on 1, 2 and 4 ranks
# and after a restart. What is not known, or out of range, is an error that names it.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains 4000 > grains.data
if [ $simulator = lammps ]; then
  name=d_kelvin property='fix own all property/atom d_kelvin'
else
  name=kelvin property='fix kelvin all property/atom kelvin scalar yes yes no 0.'
fi
set_to() { [ $simulator = lammps ] && echo "set group $1 d_kelvin $2" || echo "set group $1 property/atom kelvin $2"; }
# mu = 10^(-4.5 + 9000/(T - 500)): P is 0.018, 0.10, 0.41 and 1.
heats='1380. 1450. 1520. 1600.'
script() { # DATA VALUES WORDS LINES
  boundary='m m f' flying "$1"
  echo "$property"
  [ -z "$2" ] || [ $simulator = lammps ] || echo 'run 0' # before the first `set` of a property
  local group=0 value
  for value in $2; do
    echo "group g$group id <> $((1000 * group + 1)) $((1000 * group + 1000))"
    set_to g$group "$value"; group=$((group + 1))
  done
  echo "timestep 1e-8
fix low all wall/rebound primitive type 2 zplane 0.0 surface rq 10e-6 lambda_c 90e-6 rebound constant 0.9 0.8 $3 seed 5 ledger 50 file \${out} columns full
thermo 1000
$4"
}
sticky="deposit freeze viscosity critical 1e4 vft -4.5 9000 500"
script grains.data "$heats" "$sticky temperature_of $name" 'run ${first}
write_restart half.restart
run ${second}' > whole.in
script half.restart '' "$sticky temperature_of $name" 'run 250' > rest.in
engine 1 whole.in -var out one.csv -var first 150 -var second 250
table a=one.csv "
from math import sqrt
assert len(a) >= 3950
first = [r for r in a if r.impact == 1]
for k, t in enumerate([1380, 1450, 1520, 1600]):
    hit = [r for r in first if 1000 * k < r.tag <= 1000 * k + 1000]
    assert len(hit) > 950 and all(r.temperature == t for r in hit)
    p, stuck = min(1, 10 ** (8.5 - 9000 / (t - 500))), sum(r.outcome == 1 for r in hit)
    print(t, 'K:', stuck, 'of', len(hit), 'stick;', round(p * len(hit), 1))
    assert abs(stuck - p * len(hit)) <= 4 * sqrt(len(hit) * p * (1 - p)) + 0.01, (t, stuck, len(hit), p)" ||
  die "the share that sticks"
for ranks in 2 4; do
  engine $ranks whole.in -var out part.csv -var first 150 -var second 250
  same one.csv part.csv "1 and $ranks ranks"
done
engine 2 whole.in -var out part.csv -var first 150 -var second 0
engine 2 rest.in -var out part.csv
same one.csv part.csv "one run and a restart"

# One temperature for all, and grains at 400 K, at which the form has no viscosity.
script grains.data "$heats" "temperature 1450 $sticky" 'run 400' > all.in
engine 1 all.in -var out all.csv
check_rows all.csv 'r.temperature == 1450' "the temperature of all"
script grains.data '' "temperature 1450 $sticky temperature_of $name" 'run 1' > twice.in
OPTIONS="-var out x.csv" refuses 1 twice.in "'temperature' has no effect: the particles have one of their own"
script grains.data '' "$sticky" 'run 1' > cold.in
OPTIONS="-var out x.csv" refuses 1 cold.in "'viscosity' has no effect without 'temperature T'"
script grains.data '' "deposit off temperature_of $name" 'run 1' > idle.in
OPTIONS="-var out x.csv" refuses 1 idle.in "'temperature_of' has no effect with rebound constant"
script grains.data '' "$sticky temperature_of ${name}s" 'run 1' > other.in
OPTIONS="-var out x.csv" refuses 1 other.in "the numbers '${name}s' do not exist"
script grains.data '1380. 1450. 400. 1600.' "$sticky temperature_of $name" 'run 400' > range.in
OPTIONS='-var out x.csv' refuses 1 range.in "the temperature of particle " ", by '$name', is 400 K: the viscosity is asked for at 400 K" "more than 500 K"
script grains.data '1380. 1450.' "$sticky temperature_of $name" 'run 400' > none.in
OPTIONS='-var out x.csv' refuses 1 none.in ", by '$name', is 0 K: it must be more than 0"
