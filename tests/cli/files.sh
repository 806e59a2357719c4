#!/usr/bin/env bash
# Every kind of input file may be a pipe. A folder, or a file that does not exist, ends the command with status 2.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"

{ echo x_um,z_um; awk 'BEGIN { srand(1); for (i = 0; i < 400; i++) { z = 0.9 * z + rand() - 0.5; print i "," z } }'; } > profile
awk 'NR == 1 { print; next } { split($0, f, ","); print f[1] + 0.3 * sin(f[1]) "," f[2] }' profile > uneven
"$asperity" materials > materials
printf 'alpha1_deg,cor_n,cor_t\n10,0.9,0.8\n80,0.3,0.7\n' > table
"$asperity" cor rebound grant_tabakoff scatter 1 --dp 100um --angles 10:80:10 --samples 40 -o impacts

# use FILE PIPE: what a command makes of each kind of file.
use() {
  case $1 in
    profile | uneven) "$asperity" surface surface profile "$2" --dp 10um ;;
    materials) "$asperity" cor materials ard hastelloy-x file "$2" --angles 45 ;;
    table) "$asperity" cor rebound table "$2" --angles 45 ;;
    impacts) "$asperity" compare "$2" impacts ;;
    data) "$asperity" compare impacts "$2" ;;
  esac
}
cp impacts data
for file in profile uneven materials table impacts data; do
  use $file $file 2> err | grep -v '^#' > wanted
  use $file <(cat $file) 2> err | grep -v '^#' > got || die "$file from a pipe: $(cat err)"
  cmp wanted got || die "$file from a pipe is another one than from a file"
  use $file <({ head -n 1 $file; sleep 0.2; tail -n +2 $file; }) 2> err | grep -v '^#' > got || die "$file, slowly: $(cat err)"
  cmp wanted got || die "$file from a slow pipe is another one than from a file"
  for other in . nowhere; do
    status=0
    export asperity; export -f use
    timeout 20 bash -c "use $file $other" > out 2> err || status=$?
    [ $status = 2 ] && [ "$(wc -l < err)" = 1 ] || die "$file that is '$other': exit $status: $(cat err)"
    case $other in .) word='directory' ;; *) word='No such file' ;; esac
    grep -q "'$other'.*$word" err || die "$file that is '$other': $(cat err)"
  done
done

# A heading may be longer than any line of a table: this command's own is read by the others.
angles=$(seq -s , 1.001 0.05 89)
"$asperity" cor surface sigma 5 rebound walton 0.9 0.3 0 --angles "$angles" --samples 1 --columns ledger -o long
[ "$(head -n 1 long | wc -c)" -gt 8192 ] || die "the heading is not long"
{ cat long; head -n 1 long; } > twice # and a comment below the rows
"$asperity" compare long twice > out 2> err || die "compare: $(cat err)"
"$asperity" erosion long erosion dnv density 7800 --density 2650 > out 2> err || die "erosion: $(cat err)"
refuses 2 "its first line has no 'fix ID wall/rebound'" -- sensitivity long surface sigma 5 rebound walton 0.9 0.3 0

# A line of units has as many fields as the names above it: below a title `m,s` are names.
printf 'Run 7\nm,s\n1,2\n' > odd
refuses 2 "there are: m s" -- compare odd
exit 0
