#!/usr/bin/env bash
# Each form of what instruments print is the wall `rq R lambda_c L` of its formula, to the digits of the formula: in the
# command, in both engines (their ledgers), and in Python, which reads the ledgers of both kinds and repeats the
# engines' impacts.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
root=$(cd "$here/../.." && pwd)
pair='materials quartz hastelloy-x seed 3'

# R_q 5 um and lambda_c 40 um, by each form; R_Sm by the table's rows on both sides of 20 lambda_c.
forms() {
  awk -F'[{},]' '/rsm_table\[/ { for (i = 2; i < NF; i++) table[i - 2] = $i }
    END { pi = atan2(0, -1); rq = 5; l = 40
      at = 2 * log(20 / 4) / log(2); row = int(at); rsm = l * (table[row] + (at - row) * (table[row + 1] - table[row]))
      ra = rq * sqrt(2 / pi); rdq = sqrt(2) * rq / l
      n = split(sprintf("rq %.17gum/ra %.17gum", rq, ra), heights, "/")
      m = split(sprintf("lambda_c %.17gum/rdq %.17g/rdq %.17gdeg/rsm %.17gum sampling 0.8mm", l, rdq, atan2(rdq, 1) * 180 / pi, rsm), lengths, "/")
      for (i = 1; i <= n; i++) for (k = 1; k <= m; k++) print heights[i], lengths[k]
      m = split(sprintf("lambda_c %.17gum/sdq %.17g/sdq %.17grad/sal %.17gum", l, 2 * rq / l, atan2(2 * rq, l), l * sqrt(log(5))), lengths, "/")
      for (k = 1; k <= m; k++) printf "sq %.17gum %s\n", rq, lengths[k] }' "$root/src/surface/rsm_table.inc"
}
forms > forms
[ "$(wc -l < forms)" = 12 ] || die "forms: $(cat forms)"

grains 200 > grains.data
deck() { # DESCRIPTION FILE
  head_of si
  echo "read_data grains.data
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"
  materials
  echo "fix move all nve/sphere
timestep 1e-8
fix low all wall/rebound primitive type 2 zplane 0.0 $1 ledger 400 file $2 columns full
run 400"
}
number=0
while read -r form; do
  number=$((number + 1))
  "$bin/asperity" cor surface $form $pair --dp 10um --angles 5,40,80 --samples 50 --columns ledger -o command.$number.csv 2> err || die "cor surface $form: $(cat err)"
  deck "surface $form $pair" liggghts.$number.csv > run.in
  engine 1 run.in
  deck "surface $form $pair" lammps.$number.csv > run.in
  (use lammps; engine 1 run.in)
done < forms

cat > look.py << 'END'
import numpy as np
import asperity

def same(a, b, what, tolerance=3e-7):
    for name in a.dtype.names:
        if a[name].dtype.kind == "f":
            np.testing.assert_allclose(a[name], b[name], tolerance, 1e-7, err_msg=f"{what}: {name}")
        else:
            np.testing.assert_array_equal(a[name], b[name], f"{what}: {name}")

def words(table):
    found = asperity.heading(table).split("surface rq ")[-1].split()
    return float(found[0].rstrip("um")), float(found[2].rstrip("um"))

forms, pair = open("forms").read().splitlines(), "materials quartz hastelloy-x seed 3"
first = None
for number, form in enumerate(forms, 1):
    wall = asperity.Wall(f"surface {form} {pair}", 1e-5, name="low")
    np.testing.assert_allclose([wall.get("rq"), wall.get("lambda_c")], [5e-6, 40e-6], 1e-12, err_msg=form)
    command = asperity.read(f"command.{number}.csv")
    liggghts, lammps = asperity.read(f"liggghts.{number}.csv"), asperity.read(f"lammps.{number}.csv")
    assert len(command) == 150 and len(liggghts) == 200, form
    for table in command, liggghts, lammps:
        np.testing.assert_allclose(words(table), (5e-6, 40e-6), 1e-5, err_msg=asperity.heading(table))
    same(lammps, liggghts, form)
    v1 = np.stack([lammps["v1" + x] for x in "xyz"], 1)
    hits = wall.impacts(v1, lammps["d_p"].astype(float), tag=lammps["tag"], impact=lammps["impact"])
    cor = asperity.coefficients(v1, hits)
    for name, values in (("delta_alpha_deg", np.degrees(hits["delta_alpha"])), ("cor_n", cor["cor_n"]),
                         ("cor_t", cor["cor_t"]), ("hits", hits["hits"]), ("v2x", hits["v2"][:, 0])):
        np.testing.assert_allclose(values, lammps[name], 2e-5, 1e-5, err_msg=f"{form}: {name} in Python")
    first = first or (command, liggghts, lammps, hits)
    for a, b in zip((command, liggghts, lammps, hits), first):
        same(a, b, form)
END
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/src/python ASPERITY_LIBRARY=$(echo "$bin"/../lib*/libasperity.so.1) \
  "${ASPERITY_PYTHON:-/usr/bin/python3}" look.py
