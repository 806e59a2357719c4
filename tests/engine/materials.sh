#!/usr/bin/env bash
# Materials and units. One case in units si, cgs, micro, and LAMMPS's nano has the same impacts; by the presets' names it
# has those of the same constants by `fix property/global`. Words go before the script's constants; a file of the user's own
# goes before the presets.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
run() { # LEDGER RANKS LINES KEYWORDS: in $units; LINES replace the constants of a type
  local at=(${units_of[$units]})
  { length=${at[0]} pa=${at[4]} jm2=${at[5]} flying $units.data | sed "${3:-}"
    echo "timestep $(mul 1e-8 ${at[3]})
fix wall all wall/rebound primitive type 2 zplane 0.0 surface rq $(mul 10e-6 ${at[0]}) lambda_c $(mul 90e-6 ${at[0]}) spread truncated ${4:-} ledger 400 file $1.csv
run 400"; } > $1.in
  engine $2 $1.in
}
says() { grep -aqF -- "$2" "$1.in.screen" || { cat "$1.in.screen"; die "$1: the log does not say '$2'"; }; }
same_rows() { [ "$(count_rows $1.csv)" -ge 400 ] || die "$1: too few impacts"; same <(rows $1.csv) <(rows $2.csv) "$1 and $2"; }
# The pair style's own constants: soft ones, of which the wall must take nothing but the friction.
soft() { # factor of pressures
  echo "s/hard_particles yes/hard_particles no/; s/\(youngsModulus peratomtype\).*/\1 $(mul 5e6 ${1:-1}) $(mul 5e6 ${1:-1})/; s/\(poissonsRatio peratomtype\).*/\1 0.3 0.3/; /yieldStress\|surfaceEnergy/d"
}
# constants YOUNG POISSON YIELD GAMMA MU: of both types, for sed; those that are not given stay.
constants() {
  local k=0 names=(youngsModulus poissonsRatio yieldStress surfaceEnergy coefficientFriction)
  for value; do
    [ -z "$value" ] || [ $k -lt 3 ] || value="2 $value $value $value $value"
    [ -z "$value" ] || echo "s/\(${names[k]} peratomtype[a-z]*\) .*/\1 $value/"
    k=$((k + 1))
  done
}
names='materials quartz hastelloy-x'

# Factors from SI: length, velocity, density, time, pressure, energy per area.
declare -A units_of=([si]='1 1 1 1 1 1' [cgs]='1e2 1e2 1e-3 1 10 1e3' [micro]='1e6 1 1e-3 1e6 1e-3 1e3' [nano]='1e9 1 1e-6 1e9 1e-6 1e3' [lj]='1 1 1 1 1 1')
for units in si cgs micro $([ $simulator = liggghts ] || echo nano); do
  at=(${units_of[$units]})
  grains 400 ${at[0]} ${at[1]} ${at[2]} > $units.data
  run $units.numbers 1
  run $units.names 2 "$(soft ${at[4]})" "$names"
  near $units.numbers.csv $units.names.csv "tag impact time x y z d_p v1 alpha1_deg delta_alpha_deg hits v2 alpha2_deg cor_n cor_t outcome" 1e-9
  awk -F, -v OFS=, -v OFMT=%.12g -v CONVFMT=%.12g -v l=${at[0]} -v v=${at[1]} -v t=${at[3]} '/^#/ || /^tag/ { print; next }
    { $3 /= t; for (i = 6; i <= 9; i++) $i /= l; $10 /= v; $15 /= v; print }' $units.numbers.csv > rescaled.csv
  near si.numbers.csv rescaled.csv "tag impact time d_p v1 alpha1_deg delta_alpha_deg hits v2 alpha2_deg cor_n cor_t outcome" 1e-6
  says $units.names "surface_energy $(mul 0.8 ${at[5]}), the default"
  grep -q '^# .* materials quartz hastelloy-x deposit freeze seed 1;' $units.names.csv || die "$units: the ledger does not name the materials"
  ! grep -aq 'WARNING.*density' $units.names.in.screen || die "$units: a warning of a density that is the material's"
done
units=si
same_rows si.numbers si.names
run frictionless 1 "$(soft); /coefficientFriction/d; s/tangential history//" "$names"
same_rows si.names frictionless
says frictionless 'friction 0.3, the default'
[ $simulator = lammps ] || says si.numbers "friction by the script's coefficientFriction"

# Constants of a pair come from the script, those of a type from the material.
run pair 1 "$(constants '' '' '' 0.4 0.5)"
run pair.names 1 "$(constants '5e6 5e6' '' '1e6 1e6' 0.4 0.5)" "$names"
same_rows pair pair.names
! cmp -s <(rows pair.csv) <(rows si.names.csv) || die "the constants of a pair are not taken"

# Words go before both, and the log says so.
run words 1 "$(soft)" "$names friction 0.5 surface_energy 0.4 yield_stress 150MPa"
run words.numbers 1 "$(constants '' '' '150e6 0' 0.4 0.5)"
same_rows words words.numbers
for word in 'friction 0.5' 'surface_energy 0.4' 'yield_stress 1.5e+08'; do says words "$word, by the description"; done

# A softer quartz of the user's own, and a name that no preset has. The density of the grains is another one.
printf '%s\n' name,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa quartz,50e9,0.2,2000,150e6 brass,100e9,0.35,8500, > brass.csv
run own 1 "$(soft)" 'materials quartz brass file brass.csv'
run own.numbers 1 "$(constants '50e9 100e9' '0.2 0.35' '150e6 0')"
same_rows own own.numbers
[ "$(grep -a 'WARNING.*density' own.in.screen | grep -cE "type 1.*32.5 %.*'quartz'.*2000")" = 1 ] || die "not one warning of another density"
! cmp -s <(rows own.csv) <(rows si.names.csv) || die "the file is not taken"

# Without materials nothing has a unit: lj is what si is.
if [ $simulator = lammps ]; then
  cp si.data lj.data
  for units in si lj; do run plain.$units 1 '/^fix m[0-9]/d; /^pair/d' 'rebound walton 0.9 0.3 0.1'; done
  same_rows plain.si plain.lj
fi
