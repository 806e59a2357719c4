#!/usr/bin/env bash
# A restart in the middle changes nothing, on another number of ranks too: impacts, their numbers and draws, stuck particles,
# counters, on meshes that move. `dump local` prints each impact once, as the file has it. A script or meshes that differ are
# told, and what is stuck stays with its mesh. The ledger's file is cut to what the restart file counts, or refused; a disk
# that is full costs whole rows. (See unit/test_record.cpp and unit/test_ledger_file.cpp.)
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains 400 > grains.data
plate 6 1 3.9e-3 > plate.stl
script() { # DATA MOTION LINES
  boundary='m m f' flying $1
  echo "fix plate all mesh/surface file plate.stl type 2
fix push all move/mesh mesh plate $2
fix low all wall/rebound mesh n_meshes 1 meshes plate surface rq 10e-6 lambda_c 90e-6 rebound bons yield_stress 2e8 scatter 0.3 deposit freeze seed 4 ledger 60 file \${out}
fix high all wall/rebound primitive type 2 zplane 3.8e-4 surface rq 10e-6 lambda_c 90e-6 rebound constant 0.9 0.9 seed 4
thermo_style custom step f_low[1] f_low[2] f_low[3] f_low[4] f_high[1]
thermo 1000
thermo_modify format float %.15g
timestep 2e-8
$(pictures 1000 end.txt)
$3"
}
local_rows='dump rows all local 60 rows.*.txt f_low[1] f_low[2] f_low[3] f_low[11] f_low[17] f_low[19]
dump_modify rows format "%.0f %.0f %.10g %.10g %.10g %.0f"
dump other all local 120 other.*.txt f_low[1]'
turn="rotate origin 1e-3 1e-3 0. axis 0. 1. 0. period 1e-3"
for motion in "$turn" "wiggle amplitude 0. 0. 1e-5 period 1e-6"; do
  [ $simulator = lammps ] || [ "$motion" = "$turn" ] || continue
  script grains.data "$motion" "$local_rows
run \${first}
write_restart half.restart
run \${second}" > whole.in
  script half.restart "$motion" 'run 900' > rest.in
  rm -f rows.*
  engine 2 whole.in -var out whole.csv -var first 100 -var second 900
  mv end.txt whole.end; cp whole.in.screen whole.screen
  table a=whole.csv log=whole.screen 'assert log[-1][5] > 20 and sum(row.time > 200e-8 for row in a) > 50' || die "too few impacts for this test"
  cat rows.*.txt | awk 'NF == 6 && !/ITEM/ { sub("nan", "", $5); print $1 "," $2 "," $3 "," $4 "," $5 "," $6 }' | sort > dumped
  rows whole.csv | awk -F, -v OFS=, '$3 <= 1920e-8 { print $1, $2, $3, $11, $17, $19 }' | sort > written
  same dumped written "dump local and file"
  engine 2 whole.in -var out part.csv -var first 100 -var second 0
  cp part.csv half.csv
  for ranks in 1 2; do
    cp half.csv part.csv
    engine $ranks rest.in -var out part.csv
    same whole.csv part.csv "one run and a restart on $ranks ranks, $motion"
    same <(tail -n 400 whole.end) <(tail -n 400 end.txt) "final positions"
    same <(grep -E '^ +1000 ' whole.screen | tail -n 1) <(grep -E '^ +1000 ' rest.in.screen | tail -n 1) "counters"
  done
done
! grep -aE 'WARNING.*script differs' rest.in.screen || die "a warning about a script that is the same"

# says SCRIPT WARNING WORD...: one warning has them all.
says() {
  local word script=$1; grep -a "$2" "$1.screen" > warning || { grep -a WARNING "$1.screen"; die "no '$2'"; }; shift 2
  for word; do grep -qF -- "$word" warning || { cat warning; die "'$word' is not in the warning of $script"; }; done
}
sed 's/yield_stress 2e8 scatter 0.3 deposit freeze seed 4/yield_rate 3e6 deposit delete seed 5/; s/^fix high all/fix new all/; s/f_high/f_new/; s/^run 900/thermo_modify lost ignore\nrun 1/' rest.in > other.in
engine 2 other.in -var out other.csv
says other.in 'WARNING.*id low' "the script is taken" "seed 5, was 4" "deposit delete, was freeze" "rebound bons yield_rate 3000000, was bons"
says other.in 'WARNING.*id new' 'no data of this wall'

# The ledger's file: rows too many and a part of one, and rows that are missing; other rows.
for kind in more less other; do
  case $kind in
    more) { cat whole.csv; head -c 100 whole.csv; } > part.csv ;;
    less) head -c $(($(stat -c %s half.csv) - 200)) whole.csv > part.csv ;;
    other) sed '$s/1/2/g' half.csv > part.csv ;;
  esac
  cp part.csv before
  case $kind in
    more) engine 2 rest.in -var out part.csv
      same part.csv whole.csv "after too many rows"
      says rest.in 'cut off' "ledger file 'part.csv' continues after the $(count_rows half.csv) " "$(($(count_rows whole.csv) - $(count_rows half.csv))) rows and a part of a row after them cut off" ;;
    less) OPTIONS="-var out part.csv" refuses 2 rest.in "'part.csv' has $(($(count_rows part.csv) - 1)) rows" "the restart file counts $(count_rows half.csv): 2 are missing" ;;
    other) OPTIONS="-var out part.csv" refuses 1 rest.in "'part.csv' is not that of the restart file" ;;
  esac
  [ $kind = more ] || same part.csv before "a file that was refused"
done
rm part.csv
OPTIONS="-var out part.csv" refuses 1 rest.in "'part.csv' is gone, and the restart file counts $(count_rows half.csv) rows"
[ ! -e part.csv ] || die "part.csv was made by a run that was refused"
engine 1 rest.in -var out new.csv
says rest.in 'begins here' "'new.csv' begins here" "$(count_rows half.csv) rows of 'part.csv'"

# No file may become larger: the run stops with the rows of whole windows, or goes on and counts those that are lost.
printf '#!/usr/bin/env bash\ntrap "" XFSZ; ulimit -f 20; exec "$@"\n' > limit; chmod +x limit
limited() { timeout 60 mpirun --mca btl self,tcp --mca btl_tcp_if_include lo -np 2 ./limit "$program" -in full.in -log none > full.in.screen 2>&1; }
sed 's/${out}/rows.csv on_error stop/; s/ledger 60/ledger 20/; s/${first}/250/; /^write_restart/,$d; /^dump/d' whole.in > full.in
! limited || die "a full disk did not stop the run"
says full.in ERROR "rows.csv" "File too large" "rows of the steps" "are lost"
same rows.csv <(head -c "$(stat -c %s rows.csv)" whole.csv) "what a full disk has left"
[ "$(stat -c %s rows.csv)" -gt 5000 ] || die "too few bytes before the error"
sed -i 's/on_error stop/on_error go_on/' full.in
limited || die "on_error go_on: $(tail full.in.screen)"
says full.in 'WARNING.*File too large' "rows.csv"
lost=$(grep -oE '[0-9]+ rows of the steps' full.in.screen | awk '{ sum += $1 } END { print sum }')
all=$(rows whole.csv | awk -F, '$3 < 250.5 * 2e-8' | wc -l)
[ $(($(count_rows rows.csv) + lost)) = "$all" ] && grep -q " $lost in all" full.in.screen || die "$(count_rows rows.csv) rows written, $lost told as lost of $all"
[ "$(tail -c 1 rows.csv | od -An -tx1 | tr -d ' ')" = 0a ] || die "the file has a part of a row"

[ $simulator = liggghts ] || exit 0 # LAMMPS's walls have one mesh

# Each mesh keeps what it took itself, and what is stuck to it, where their order is another one; nothing of another one.
bouncing 200 > grains.data
plate 4 1 3.9e-3 > plate.stl
plate 2 1 3.9e-3 > coarse.stl
meshes() { # DATA MESHES RUNS [FILE]
  flying $1 | sed 's/ 0.8 0.8 0.8 0.8/ 5000 5000 5000 5000/'
  echo "fix lo all mesh/surface$([ "${4:-}" ] && echo /stress) file ${4:-plate.stl} type 2
fix hi all mesh/surface file plate.stl type 2 move 0 0 3.8e-4
fix drive all move/mesh mesh hi linear 10. 0. 0.
fix w all wall/rebound mesh n_meshes 2 meshes $2 rebound bons deposit freeze
timestep 2e-8
thermo_style custom step f_w f_w[1][1] f_w[2][1]
thermo 10000
dump low all mesh/vtk 1000 low.vtk output face lo id impacts
dump end all custom 1000 end.txt id x z f_w[2]
dump_modify end sort id format \"%d %.10g %.10g %.0f\"
run 0
$3"
}
meshes grains.data 'lo hi' 'run 1000
write_restart both.restart' > both.in
meshes both.restart 'hi lo' 'run 0
write_restart again.restart
run 1000' > swapped.in
meshes both.restart 'lo hi' '' coarse.stl > coarse.in
meshes again.restart 'hi lo' '' > again.in
engine 2 both.in
read -r _ all lo hi < <(grep -E '^ +1000 ' both.in.screen | tail -n 1)
[ "$lo" -gt 50 ] && [ "$hi" -gt 50 ] && [ "$lo" != "$hi" ] && [ "$all" = $((lo + hi)) ] || die "impacts: $all, $lo and $hi"
for name in swapped coarse again; do
  engine 2 $name.in
  case $name in swapped | again) want="$all $hi $lo" ;; coarse) want="$all 0 $hi" ;; esac
  [ "$(grep -E '^ +1000 ' $name.in.screen | sed -n 1p | xargs)" = "1000 $want" ] || die "$name: $(grep -E '^ +1000 ' $name.in.screen), wanted $want"
  [ $name != swapped ] || cp end.txt after.txt
done
[ "$(awk '/^impacts 1/ { on = 1; next } /[a-z]/ { on = 0 } on { for (i = 1; i <= NF; i++) sum += $i } END { print sum + 0 }' low.vtk)" = "$lo" ] || die "the map of a file that is written at once"
says swapped.in 'WARNING.*the script differs' 'geometry mesh hi lo, was mesh lo hi'
says coarse.in 'WARNING.*not continued' "the $lo impacts of mesh 'lo', which had 32 triangles and has 8"
! grep -aE "WARNING.*id w\): (not continued|the script differs)" again.in.screen || die "a warning of what did not change"
table a=after.txt 'moved = {1: [], 2: []}
for row, now in zip(at(a, 1000), at(a, 2000)):
    if row[3] == 1:
        moved[1 if row.z < 1.9e-4 else 2].append(now.x - row.x)
assert len(moved[1]) > 20 and len(moved[2]) > 20
assert not any(moved[1]) and all(1.9e-4 < x < 2.1e-4 for x in moved[2])' || die "what is stuck is on another mesh"

# A damaged record is refused (each byte: unit/test_record.cpp).
byte=$(grep -abo asp-wall both.restart | cut -d: -f1)
perl -0777 -pe "substr(\$_, $((byte + 200)), 1) ^= 'A'" both.restart > bad.restart
sed 's/both.restart/bad.restart/' swapped.in > bad.in
refuses 1 bad.in "id w" "the restart file's record of this wall" "damaged"
