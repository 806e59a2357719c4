#!/usr/bin/env bash
# LAMMPS's own examples with their granular walls exchanged for this one, a line each: they run and lose no particle, or
# the error names what the line must not have. Skipped where they are not installed (Debian: lammps-examples).
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
examples=${ASPERITY_LAMMPS_EXAMPLES:-/usr/share/lammps/examples}
[ -f "$examples/granregion/in.granregion.box" ] || { echo "no LAMMPS examples in $examples"; exit 77; }
words='rebound constant 0.5 0.8 deposit off'
exchange() { # FILE STEPS: the script with its walls exchanged and its runs cut to STEPS steps
  sed -e ':a' -e '/&[ \t]*$/N; s/&[ \t]*\n/ /; ta' "$examples/$1" |
    sed -E "s#wall/gran(/region)? .*region ([a-z_]+) *\$#wall/rebound region \2 $words#
      s#wall/gran .*zplane (0\.?[0-9]*) .*#wall/rebound zplane \1 $words#
      s#^run[ \t]+[0-9]{4,}#run $2#" > "${1##*/}"
  cp "$examples/${1%/*}"/molecule* . 2> /dev/null || true
  grep -q wall/rebound "${1##*/}" || die "$1 has no wall to exchange"
}
run() { timeout 200 "$bin/lammps-asperity" -in "$1" -log none < /dev/null > "$1.screen" 2>&1; }
for script in granregion/in.granregion.funnel granregion/in.granregion.mixer granular/in.pour.flatwall pour/in.pour rigid/in.rigid.gravity; do
  exchange $script 1000
  name=${script##*/}
  run "$name" || { tail -n 3 "$name.screen"; die "$name"; }
  [ "$(grep -ac 'Loop time' "$name.screen")" -ge 1 ] || die "$name: no run"
  ! grep -aq 'Lost atoms' "$name.screen" || die "$name: $(grep -a 'Lost atoms' "$name.screen")"
done
