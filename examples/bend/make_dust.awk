# Places of the grains, for manualInjection: N of them at the inlet, none closer to a wall than 1 % of the width. Its own
# random numbers (Park & Miller's minimal standard generator), for those of awk differ from one awk to the next.
# SPDX-License-Identifier: GPL-3.0-or-later
function place() { state = (16807 * state) % 2147483647; return (state / 2147483647 - 0.5) * 0.049 }
BEGIN {
  state = 20200709
  print "FoamFile { version 2.0; format ascii; class vectorField; object positions; }\n("
  for (i = 1; i <= N; i++) printf "(-0.2499 %.9g %.9g)\n", place(), place()
  print ")"
}
