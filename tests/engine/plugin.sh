#!/usr/bin/env bash
# The wall as a plugin of another LAMMPS gives the ledger of lammps-asperity, after `clear` too, and, where these are there,
# from Python and with the package KOKKOS on threads; in a LAMMPS of another version the plugin ends with a message. Skipped
# where there is no LAMMPS with the package PLUGIN. ASPERITY_LMP names its program, and PYTHONPATH has its Python module and,
# in the folder of that, its library. Usage: plugin.sh PLUGIN
# SPDX-License-Identifier: GPL-3.0-or-later
plugin=$1
source "$(dirname "$0")/engine.sh"
lmp=${ASPERITY_LMP:-$(command -v lmp || true)}
[ -n "$lmp" ] || { echo "no lmp in the path"; exit 77; }
"$lmp" -h 2> /dev/null < /dev/null > help.txt
grep -qw PLUGIN help.txt || { echo "$lmp has no package PLUGIN"; exit 77; }
use lammps
grains 300 > grains.data
plate 4 1 3.9e-3 > plate.stl
script() { # ledger
  head_of si | sed 's/boundary.*/boundary m m f/; s/atom_style.*/atom_style sphere/; s/communicate.*/comm_modify vel yes/; /hard_/d'
  echo "read_data grains.data
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all
fix wall all wall/rebound stl plate.stl type 2 materials quartz hastelloy-x surface rq 10e-6 lambda_c 90e-6 seed 4 ledger 60 file $1
fix move all nve/sphere
timestep 1e-8
run 300"
}
script here.csv > here.in
engine 1 here.in
# In LAMMPS of 2024 `clear` unloads plugins.
{ echo "plugin load $plugin"; script first.csv; echo "clear
plugin load $plugin"; script second.csv; } > there.in
if ! timeout 120 mpirun -np 2 "$lmp" -in there.in -log none > there.screen 2>&1; then
  if grep -q "^ERROR: wallreboundplugin.so: the version of LAMMPS is .*, but it was built for " there.screen; then
    echo "another version of LAMMPS, refused as it must be"; exit 77
  fi
  tail -n 5 there.screen; die "the plugin in $lmp"
fi
for ledger in first second; do same here.csv $ledger.csv "launcher and plugin"; done

# In Python, in one process.
if "$python" -c 'import lammps; lammps.lammps(cmdargs=["-screen", "none", "-log", "none"])' 2> /dev/null; then
  script python.csv > python.in
  "$python" - "$plugin" > python.screen << 'END' || { tail -n 5 python.screen; die "the plugin in Python"; }
import sys
from lammps import lammps
engine = lammps(cmdargs=["-log", "none"])
engine.command("plugin load " + sys.argv[1])
engine.file("python.in")
impacts = engine.extract_fix("wall", 0, 0)
engine.close()
rows = [line for line in open("python.csv") if line[0].isdigit()]
sys.exit(0 if impacts >= len(rows) > 0 else "%g impacts" % impacts)
END
  same here.csv python.csv "launcher and Python"
  echo "from Python, too"
fi

# With KOKKOS all styles that have one get the suffix kk, and particles are kept in its arrays.
grep -q '^KOKKOS package API' help.txt || exit 0
kokkos() { # RANKS SCRIPT
  OMP_PROC_BIND=false timeout 120 mpirun -np "$1" "$lmp" -k on t 2 -sf kk -pk kokkos newton off neigh half -in "$2" -log none > "$2.screen" 2>&1
}
for ranks in 1 2; do
  { echo "plugin load $plugin"; script kokkos.csv; } > kokkos.in
  kokkos $ranks kokkos.in || { tail -n 5 kokkos.in.screen; die "the plugin with KOKKOS"; }
  same here.csv kokkos.csv "launcher and KOKKOS on $ranks ranks"
done
refused() { # LINES in place of the wall's, then a part of the message
  { echo "plugin load $plugin"; script refused.csv | sed "s|^fix wall.*|$1|; s|^boundary.*|boundary p p f|"; } > refused.in
  ! kokkos 1 refused.in || die "'$1' was taken"
  grep -q "^ERROR.*$2" refused.in.screen || { tail -n 5 refused.in.screen; die "no '$2' on '$1'"; }
}
wall='fix wall all wall/rebound'
refused "region floor block/kk -4e-3 8e-3 -4e-3 8e-3 -2e-4 0 side out units box\\n$wall region floor rebound constant 1 1" "style 'block/kk'"
refused "fix box all deform 1 x scale 2 remap x\\n$wall zplane 0 rebound constant 1 1" "deform/kk"
echo "with KOKKOS, too"
