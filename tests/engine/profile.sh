#!/usr/bin/env bash
# A measured profile as the wall: the log states it and sigma per diameter, as `asperity surface` has them;
# the impacts are the same on 1 and 2 ranks, in all units, and after a restart; bad files are refused.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
"$bin/asperity" surface surface rq 8um lambda_c 25um seed 3 --points 20000 --save wall.csv > made.csv
deck() { # units, length, time, pressure, energy per area, surface, runs
  head_of "$1"
  echo "read_data $1.data
neighbor $(mul 3e-5 "$2") bin
neigh_modify delay 0 exclude group all all"
  materials "$4" "$5"
  tail_of "$2" "$3" "$6" "$7"
}
tail_of() { # length, time, surface, runs
  echo "fix move all nve/sphere
timestep $(mul 1e-8 "$2")
fix wall all wall/rebound primitive type 2 zplane 0.0 surface $3 spread truncated ledger 400 file \${out}"
  printf '%b\n' "$4"
}
grains 300 > si.data
grains 300 1e6 1 1e-3 > micro.data
profile='profile wall.csv dp_bins 7'
deck si 1 1 1 1 "$profile" 'run 400' > si.in
deck micro 1e6 1e6 1e-3 1e3 "$profile" 'run 400' > micro.in
engine 1 si.in -var out si.csv
engine 2 si.in -var out two.csv
same si.csv two.csv "1 and 2 ranks"
[ "$(count_rows si.csv)" -ge 300 ] || die "too few impacts"

# The log: file, numbers, and sigma of each bin as the command has it.
grep -q 'profile wall.csv (20000 points read' si.in.screen || die "the log does not state the profile"
grep -q 'uncertain by about' si.in.screen || die "the log does not say how uncertain one profile is"
grep -E '^  bin [0-9]+: d_p' si.in.screen | tr -d , | awk '{ print $4, $6 }' > bins
[ "$(wc -l < bins)" = 7 ] || die "not 7 bins in the log"
! grep WARNING si.in.screen | grep -qE 'dust|covers|clipped|correlation lengths' || die "a warning of a good profile: $(grep WARNING si.in.screen)"

# A doubtful profile, and a doubtful map: one warning each, once for all runs.
awk 'NR == 3000 { sub(/,.*/, ",90") } 1' wall.csv > dusty.csv
awk -F, '/^#/ || /^x/ { print; next } n++ % 8 == 0 && n < 1200' wall.csv > coarse.csv
awk 'BEGIN { printf "# Width: 200 um\n# Height: 200 um\n# Value units: um\n"; srand(5); for (k = 0; k < 30; k++) { a[k] = 6.28 * rand(); b[k] = (0.1 + 0.01 * k) * cos(2.4 * k); c[k] = (0.1 + 0.01 * k) * sin(2.4 * k) }
  for (j = 0; j < 100; j++) for (i = 0; i < 100; i++) { z = j == 40 && i == 70 ? 8 : 0; for (k = 0; k < 30; k++) z += 0.1 * sin(b[k] * i + c[k] * j + a[k]); printf "%.5f%s", z, i < 99 ? "\t" : "\n" } }' > map.txt
warns() { # SURFACE WORDS
  deck si 1 1 1 1 "$1" 'run 1\nrun 1' > doubt.in
  engine 2 doubt.in -var out doubt.csv
  [ "$(grep -c "WARNING: .*$2" doubt.in.screen)" = 1 ] || die "surface $1: $(grep WARNING doubt.in.screen)"
}
warns 'profile dusty.csv dp_bins 2' 'profile dusty.csv: .* of 20000 points .* as dust does'
warns 'profile coarse.csv dp_bins 2' 'profile coarse.csv: a particle of d_p .* covers .* points .* only .* correlation lengths long'
warns 'map map.txt' 'map map.txt: .* of 10000 points .* as dust does'
warns 'map map.txt' 'map map.txt: a particle of d_p .* covers .* points'
while read -r d_p sigma; do
  "$bin/asperity" surface surface profile wall.csv --dp "$d_p" | tail -n 1 |
    awk -F, -v sigma="$sigma" '{ d = $12 / sigma - 1; exit !(d < 2e-3 && d > -2e-3) }' ||
    die "sigma of d_p $d_p is $sigma in the log"
done < <(awk 'NR % 3 == 1' bins)
awk 'NR > 1 && $2 > before { bad = 1 } { before = $2 } END { exit bad }' bins || die "sigma grows with the size"

# The same in micrometres: the profile's unit is its own.
engine 1 micro.in -var out micro.csv
awk -F, -v OFS=, -v OFMT=%.12g -v CONVFMT=%.12g '/^#/ || /^tag/ { print; next } { $3 /= 1e6; for (i = 6; i <= 9; i++) $i /= 1e6; print }' micro.csv > micro.si.csv
near si.csv micro.si.csv "1 2 3 9 10 11 12 14 15 16 17 18 19" 1e-6

# A restart, after the small grains have been taken out: the bins are those of the whole run.
deck si 1 1 1 1 "$profile" 'run 200\nwrite_restart half.restart\nrun 200' > whole.in
{ head_of si; echo 'read_restart half.restart
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all'; materials; tail_of 1 1 "$profile" 'run 200'; } > rest.in
sed -i 's/deposit freeze//; s/spread truncated/spread truncated deposit delete/; s/^run 200$/thermo_modify lost ignore\nrun 200/' whole.in rest.in
engine 1 whole.in -var out whole.csv
cp whole.csv all.csv
sed -i '$d' whole.in; rm whole.csv; engine 1 whole.in -var out whole.csv; engine 2 rest.in -var out whole.csv
same all.csv whole.csv "one run and a restart"

# Bad files.
refused() { # surface, words
  local surface=$1; shift
  deck si 1 1 1 1 "$surface" 'run 1' > bad.in
  ! mpirun -np 2 "$program" -in bad.in -log none -var out bad.csv > bad.screen 2>&1 || die "accepted: $surface"
  [ "$(grep -ac '^ERROR' bad.screen)" = 1 ] || { tail bad.screen; die "not one message: $surface"; }
  for word in "$@"; do grep -a '^ERROR' bad.screen | grep -qF -- "$word" || { grep -a ERROR bad.screen; die "'$word' is not in the message: $surface"; }; done
}
refused 'profile nowhere.csv' nowhere.csv "No such file"
mkdir elsewhere # where the second rank finds no file
deck si 1 1 1 1 "$profile" 'run 1' > bad.in
one=("$program" -in bad.in -log none -var out bad.csv)
! timeout 60 mpirun -np 1 "${one[@]}" : -np 1 -wdir elsewhere "${one[@]}" > bad.screen 2>&1 || die "accepted: a file for one rank"
grep -q "^ERROR.*the file 'wall.csv' cannot be read by all ranks" bad.screen || { tail bad.screen; die "a file for one rank"; }
printf '0 0\n1 1\n2 0\n3 1\n' > nounit.txt
refused 'profile nounit.txt' nounit.txt unit
awk 'BEGIN { print "x_um,z_um"; for (i = 0; i < 2000; i++) print 10 * i "," sin(i / 7) + sin(i / 3.1) }' > coarse.csv
refused "profile coarse.csv" coarse.csv "spacing 1e-05"
refused 'profile wall.csv dp_bins 0' "dp_bins is 0" "1 to 256"
refused 'rq 1e-4 lambda_c 4e-5' "phi_r"

# The heights of each size are its own: sd of the tilts of small and of large grains, and their mean, as the command has
# them for that size alone. One bin for both is wrong by far.
classes() { # surface
  awk 'BEGIN { n = 1500; print "grains\n\n" 2 * n " atoms\n2 atom types\n\n-1e-3 1.51e-1 xlo xhi\n-1e-3 1e-3 ylo yhi\n-5e-4 1e-3 zlo zhi\n\nAtoms\n"
    for (i = 1; i <= 2 * n; i++) { d = i > n ? 60e-6 : 5e-6; print i, 1, d, 2650, 1e-4 * (i % n), (i > n ? 5e-4 : -5e-4), d / 2 + 5e-6 }
    print "\nVelocities\n"; for (i = 1; i <= 2 * n; i++) print i, 86.60254, 0, -50, 0, 0, 0 }' > si.data
  deck si 1 1 1 1 "$1 spread traced rebound constant 1 1 deposit off" 'run 100' | sed 's/ spread truncated//' > classes.in
  rm -f classes.csv
  engine 1 classes.in -var out classes.csv
  for d_p in 5um 60um; do
    "$bin/asperity" cor surface $1 spread traced rebound constant 1 1 --dp $d_p --angles 30 --samples 1500 > command.csv
    { awk -F, 'NR == 1 || /^#/ { next } /delta_alpha/ { for (k = 1; k <= NF; k++) if ($k == "delta_alpha_deg") at = k; next } { print "command", $at }' command.csv
      rows classes.csv | awk -F, -v d="${d_p%um}e-6" '$2 == 1 && $9 > 0.9 * d && $9 < 1.1 * d { print "fix", $12 }'; } |
      awk -v of="$1, $d_p" '{ n[$1]++; s[$1] += $2; q[$1] += $2 * $2 } END { for (k in n) { m[k] = s[k] / n[k]; sd[k] = sqrt(q[k] / n[k] - m[k] ^ 2) }
        print of ": " n["fix"], "grains, mean and sd", m["fix"], sd["fix"] ", the command has", n["command"], m["command"], sd["command"]
        r = sd["fix"] / sd["command"]; d = (m["fix"] - m["command"]) / sd["command"]
        exit !(n["fix"] == 1500 && n["command"] == 1500 && r > 0.9 && r < 1.1 && d > -0.13 && d < 0.13) }' >> classes.log ||
      { tail -n 1 classes.log; die "tilts of $d_p on a $1"; }
  done
}
classes 'profile wall.csv dp_bins 4'
