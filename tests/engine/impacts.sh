#!/usr/bin/env bash
# Walls of every spread model, of what instruments print, of measured profiles and maps, in both engines: their ledgers are
# the same, and each row is the impact that the core makes of its key, asked through Python.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
root=$(cd "$here/../.." && pwd)
"$bin/asperity" surface surface rq 8um lambda_c 25um seed 3 --points 20000 --save wall.csv -o /dev/null
"$bin/asperity" surface surface rq 8um lambda_c 25um seed 4 --points 9000 --save more.csv -o /dev/null
# A ground wall of 0.6 mm squared: grooves 30 um apart, 150 um long, at 30 degrees to the rows.
awk 'BEGIN { srand(3); n = 200; for (k = 0; k < 120; k++) { a[k] = sqrt(-2 * log(1 - rand())) * cos(6.2831853 * rand()) * 1.41421 / 30
      b[k] = sqrt(-2 * log(1 - rand())) * cos(6.2831853 * rand()) * 1.41421 / 150; c[k] = 6.2831853 * rand() }
    print "# Width: 600 um\n# Height: 600 um\n# Value units: um"
    for (j = 0; j < n; j++) for (i = 0; i < n; i++) { x = 3 * i; y = 3 * j; z = 0
      u = y * cos(0.5236) - x * sin(0.5236); v = x * cos(0.5236) + y * sin(0.5236)
      for (k = 0; k < 120; k++) z += cos(a[k] * u + b[k] * v + c[k])
      printf "%.7g%s", 0.387 * z, i < n - 1 ? " " : "\n" } }' > ground.txt
{ for model in $("$bin/asperity" help wall | sed -n '/^MODEL/,/^$/s/^  \([a-z]*\)$/\1/p'); do
    echo "surface rq 8um lambda_c 60um spread $model"
  done | sed '1~2s/$/ plane collisions single rebound walton 0.9 0.2 0.3/; 2~2s/$/ isotropic collisions multiple/'
  printf 'surface %s\n' smooth "ra 4um rdq 10deg" "sq 5um sal 50um" "rq 5um rsm 264um sampling 0.8mm" "rq 5um lambda_c 40um 80um lay 1 1 0" \
    "profile $work/wall.csv,$work/more.csv dp_bins 1" "map $work/ground.txt dp_bins 1 lay 1 -1 0"
} | awk '/rebound/ { print; next } { print $0, "materials quartz hastelloy-x seed 3" }' > walls
[ "$(wc -l < walls)" -ge 15 ] || die "walls: $(cat walls)"

# Grains of 20 um in all directions.
awk 'BEGIN { n = 200; pi = atan2(0, -1); srand(8); print "g\n\n" n " atoms\n2 atom types\n\n-0.003 0.006 xlo xhi\n-0.003 0.006 ylo yhi\n-0.0005 0.001 zlo zhi\n\nAtoms\n"
  for (i = 1; i <= n; i++) { a = (5 + 80 * rand()) * pi / 180; w = 2 * pi * rand(); x[i] = 100 * cos(a) * cos(w); y[i] = 100 * cos(a) * sin(w); z[i] = -100 * sin(a)
    printf "%d 1 2e-5 2650 %.12g %.12g %.12g\n", i, 1e-4 * (i % 20) - 1e-6 * x[i], 1e-4 * int(i / 20) - 1e-6 * y[i], 1e-5 - 1e-6 * z[i] }
  print "\nVelocities\n"; for (i = 1; i <= n; i++) printf "%d %.12g %.12g %.12g 0 0 0\n", i, x[i], y[i], z[i] }' > grains.data
number=0
while read -r wall; do
  number=$((number + 1))
  boundary='m m m' flying ../grains.data
  echo "timestep 2e-8
fix low all wall/rebound primitive type 2 zplane 0.0 $wall ledger 100 file $number.csv columns full
run 100
clear"
done < walls > impacts.in
for each in liggghts lammps; do
  mkdir $each
  (use $each; cd $each; cp ../impacts.in .; engine $([ $each = lammps ] && echo 2 || echo 1) impacts.in)
done
for ((k = 1; k <= number; k++)); do same liggghts/$k.csv lammps/$k.csv "$(sed -n ${k}p walls) in both engines"; done

cat > look.py << 'END'
import numpy as np
import asperity

for number, words in enumerate(open("walls").read().splitlines(), 1):
    wall = asperity.Wall(words, 2e-5, name="low")
    rows = asperity.read(f"lammps/{number}.csv")
    v1, normal = (np.stack([rows[name + x] for x in "xyz"], 1) for name in ("v1", "n"))
    assert len(rows) >= 200, words
    hits = wall.impacts(v1, rows["d_p"].astype(float), normal, tag=rows["tag"], impact=rows["impact"])
    cor = asperity.coefficients(v1, hits)
    for name, values in (("delta_alpha_deg", np.degrees(hits["delta_alpha"])), ("cor_n", cor["cor_n"]), ("hits", hits["hits"]),
                         ("cor_t", cor["cor_t"]), ("v2x", hits["v2"][:, 0]), ("v2z", hits["v2"][:, 2])):
        np.testing.assert_allclose(values, rows[name], 2e-5, 1e-5, err_msg=f"{words}: {name}")
END
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/src/python ASPERITY_LIBRARY=$(echo "$bin"/../lib*/libasperity.so.1) \
  "$python" look.py

# A map that has a lay is refused where nobody says which way it lies.
{ boundary='m m m' flying grains.data; echo "fix low all wall/rebound primitive type 2 zplane 0.0 surface map ground.txt dp_bins 1
run 1"; } > bad.in
refuses 2 bad.in "say which way it lies: 'lay X Y Z'"
