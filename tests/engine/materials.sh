#!/usr/bin/env bash
# `materials`: the presets by name, in every system of units, are the same constants that `fix property/global`
# gives; beside a soft pair style, from a file of the user's own, and with the defaults of the command.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
deck() { # units, length, time, lines with the constants, keywords of the fix
  head_of "$1"
  echo "read_data $1.data
neighbor $(mul 3e-5 "$2") bin
neigh_modify delay 0 exclude group all all
$4
fix move all nve/sphere
timestep $(mul 1e-8 "$3")
fix wall all wall/rebound primitive type 2 zplane 0.0 surface rq $(mul 10e-6 "$2") lambda_c $(mul 90e-6 "$2") spread truncated $5 ledger 400 file out.csv
run 400"
}
run() { # name of the ledger, ranks, the deck
  local name=$1 ranks=$2; shift 2
  deck "$@" > run.in
  engine "$ranks" run.in
  mv out.csv "$name.csv"
  cp run.in.screen "$name.screen"
}
says() { grep -aqF -- "$2" "$1.screen" || { cat "$1.screen"; die "$1: the log does not say '$2'"; }; }
same_rows() { rows "$1.csv" > a; rows "$2.csv" > b; [ -s a ] || die "$1: no rows"; same a b "$1 and $2"; }

# The pair style's own constants: soft ones, of which the wall must take nothing but the friction.
soft() { # pressure
  materials "$1" 1 | grep -v -e '^fix m3' -e '^fix m4' | sed "s/^fix m1.*/fix m1 all property\/global youngsModulus peratomtype $(mul 5e6 "$1") $(mul 5e6 "$1")/; s/^\(fix m2.*peratomtype\).*/\1 0.3 0.3/"
}
# factors from SI: length, time, pressure, energy per area
grains 400 > si.data
grains 400 1e2 1e2 1e-3 > cgs.data
grains 400 1e6 1 1e-3 > micro.data
for units in "si 1 1 1 1" "cgs 1e2 1 10 1e3" "micro 1e6 1e6 1e-3 1e3"; do
  set -- $units
  run "$1.numbers" 1 "$1" "$2" "$3" "$(materials "$4" "$5")" ''
  run "$1.names" 2 "$1" "$2" "$3" "$(soft "$4" | sed '1i hard_particles no')" 'materials quartz hastelloy-x'
  [ "$(count_rows "$1.names.csv")" -ge 400 ] || die "$1: too few impacts"
  near "$1.numbers.csv" "$1.names.csv" "1 2 3 6 7 8 9 10 11 12 14 15 16 17 18 19" 1e-9
  says "$1.names" "surface_energy $(mul 0.8 "$5"), the default"
  grep -q '^# .* materials quartz hastelloy-x deposit freeze seed 1;' "$1.names.csv" || die "$1: the ledger does not name the materials"
  grep -aq 'WARNING.*density' "$1.names.screen" && die "$1: a warning of a density that is the material's"
done
same_rows si.numbers si.names
run frictionless 1 si 1 1 "$(soft 1 | grep -v '^fix m5' | sed 's/tangential history//')" 'materials quartz hastelloy-x'
same_rows si.names frictionless
says frictionless 'friction 0.3, the default'
[ $simulator = lammps ] || says si.numbers "friction by the script's coefficientFriction"

# Constants of a pair come from the script, those of a type from the material.
run pair 1 si 1 1 "$(materials | sed 's/ 0\.8 0\.8 0\.8 0\.8/ 0.4 0.4 0.4 0.4/; s/ 0\.3 0\.3 0\.3 0\.3/ 0.5 0.5 0.5 0.5/')" ''
run pair.names 1 si 1 1 "$(materials | sed 's/ 0\.8 0\.8 0\.8 0\.8/ 0.4 0.4 0.4 0.4/; s/ 0\.3 0\.3 0\.3 0\.3/ 0.5 0.5 0.5 0.5/; s/200e6/1e6/g; s/2000*\b/1000000/g')" 'materials quartz hastelloy-x'
same_rows pair pair.names
cmp -s <(rows pair.csv) <(rows si.names.csv) && die "the constants of a pair are not taken"

# Words go before both, and the log says so.
run words 1 si 1 1 "$(soft 1)" 'materials quartz hastelloy-x friction 0.5 surface_energy 0.4 yield_stress 150MPa'
run words.numbers 1 si 1 1 "$(materials | sed 's/ 0\.8 0\.8 0\.8 0\.8/ 0.4 0.4 0.4 0.4/; s/ 0\.3 0\.3 0\.3 0\.3/ 0.5 0.5 0.5 0.5/; s/ 200000000 200000000/ 150e6 0/')" ''
same_rows words words.numbers
for word in 'friction 0.5' 'surface_energy 0.4' 'yield_stress 1.5e+08'; do says words "$word, by the description"; done

# A file of the user's own, before the presets: a softer quartz, and a name that no preset has.
cat > own.csv << 'END'
name,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa
quartz,50e9,0.2,2000,150e6
brass,100e9,0.35,8500,
END
run own 1 si 1 1 "$(soft 1)" 'materials quartz brass file own.csv'
run own.numbers 1 si 1 1 "$(materials | sed 's/ 70000000000 205000000000/ 50e9 100e9/; s/0\.17 0\.32/0.2 0.35/; s/ 200000000 200000000/ 150e6 0/')" ''
same_rows own own.numbers
grep -a 'WARNING.*density' own.screen > warning || die "no warning of another density"
for word in "type 1" "32.5 %" "'quartz'" "2000"; do grep -qF -- "$word" warning || { cat warning; die "'$word' is not in the warning"; }; done
[ "$(wc -l < warning)" = 1 ] || die "the density is warned of more than once"
cmp -s <(rows own.csv) <(rows si.names.csv) && die "the file is not taken"

# A wall's material has no yield stress: particles of it need one, or a rate.
run rate 1 si 1 1 "$(soft 1)" 'materials hastelloy-x hastelloy-x rebound bons yield_rate 3e6'
