#!/usr/bin/env bash
# A large STL mesh takes memory once, however many ranks a node has, and once a rank where MPI shares none; the ledger
# is the same either way, and with text or binary files.
# SPDX-License-Identifier: GPL-3.0-or-later
unset MALLOC_PERTURB_ # it touches all memory that is asked for, and so what is counted here
source "$(dirname "$0")/engine.sh"
stl() { # CELLS FORM: a plate of 2 CELLS^2 triangles
  perl -e '($cells, $form) = @ARGV; $l = 4e-3 / $cells;
    sub at { my ($i, $j) = @_; ($i * $l - 2e-3, $j * $l - 2e-3, 1e-5 * sin($i * 0.1)) }
    print $form eq "text" ? "solid p\n" : "\0" x 80 . pack("V", 2 * $cells ** 2);
    for $i (0 .. $cells - 1) { for $j (0 .. $cells - 1) {
      for $t ([at($i, $j), at($i + 1, $j), at($i + 1, $j + 1)], [at($i, $j), at($i + 1, $j + 1), at($i, $j + 1)]) {
        @t = unpack("f<9", pack("f<9", @$t));
        if ($form eq "text") { printf "facet normal 0 0 1\nouter loop\n" . "vertex %.17g %.17g %.17g\n" x 3 . "endloop\nendfacet\n", @t }
        else { print pack("f<12v", 0, 0, 1, @t, 0) } } } }
    print "endsolid p\n" if $form eq "text"' "$@"
}
stl 200 binary > large.stl; stl 200 text > text.stl; stl 2 binary > small.stl
cat > memory.sh <<'END'
# In kB: of all ranks together, what is in memory now without files, whose share depends on other programs, and the most
# that each one had.
for job in $(pgrep -f -- "lammps-asperity -in $1"); do cat /proc/$job/smaps_rollup /proc/$job/status; done 2> /dev/null |
  awk '/^Pss_(Anon|Shmem):/ { now += $2 } /^VmHWM:/ { most += $2 } END { print now, most }' > memory
END
run() { # MESH RANKS: its ledger, and what memory it took
  { head_of si
    echo "region box block -0.002 0.002 -0.002 0.002 -0.001 0.001 units box
create_box 2 box
neighbor 2e-5 bin
create_atoms 1 single 1e-3 1e-3 4e-5 units box
create_atoms 1 single -1e-3 5e-4 4e-5 units box
set group all diameter 1e-5 density 2650
velocity all set 3 0 -40 units box"
    echo "fix wall all wall/rebound stl $1.stl type 2 materials quartz hastelloy-x surface rq 5e-6 lambda_c 40e-6 ledger 100 file $1.$2.csv
fix move all nve/sphere
timestep 1e-8
run 200
shell bash memory.sh $1.in"; } > "$1.in"
  engine "$2" "$1.in"
  read -r now most < memory
}
run small 4; base=$now
run large 4; shared=$((now - base))
run large 1; run text 4
[ "$(count_rows large.1.csv)" = 2 ] || die "not two impacts"
same large.1.csv large.4.csv "1 and 4 ranks"; same <(rows large.1.csv) <(rows text.4.csv) "binary and text"
grep -q "a copy" large.in.screen && die "the log tells of a copy on each rank"
mv large.4.csv shared.csv
OMPI_MCA_osc=^sm run large 4; copies=$((now - base))
same shared.csv large.4.csv "with and without shared memory"
grep -q "so each rank keeps a copy" large.in.screen || die "nothing tells of the copies"
# 80 000 triangles of 97 B are 7.6 MB.
echo "80 000 triangles on 4 ranks: $shared kB shared, $copies kB in copies"
[ $shared -lt 16000 ] && [ $copies -gt 28000 ] || die "shared $shared kB, copies $copies kB"
