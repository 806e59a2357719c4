#!/usr/bin/env bash
# A ledger's file after faults: rows that are too many, torn, missing, or another file's; two walls with one file;
# a disk that is full, and a folder that is gone.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains 400 > grains.data
head_() { # beginning
  head_of si; echo "$1
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"; materials; echo 'fix move all nve/sphere
timestep 1e-8'; }
wall='fix w all wall/rebound primitive type 2 zplane 0.0 surface rq 10e-6 lambda_c 90e-6 seed 4'
{ head_ 'read_data grains.data'; echo "$wall ledger 70 file \${out}
run 150
write_restart half.\${kind}
run 100"; } > whole.in
{ head_ 'read_restart half.${kind}'; echo "$wall ledger 70 file \${out}
run 100"; } > rest.in

# refuses SCRIPT WORD... [-- options]: ends with an error that has the words; on two ranks where `ranks` says so.
refuses() {
  local script=$1 words=(); shift
  while [ $# -gt 0 ] && [ "$1" != -- ]; do words+=("$1"); shift; done; shift || true
  local command=("$program"); [ -z "${ranks:-}" ] || command=(mpirun -np "$ranks" "${command[@]}")
  if timeout 60 "${command[@]}" -in "$script" -log none "$@" > screen 2>&1; then die "$script $* ran; wanted: ${words[*]}"; fi
  says screen ERROR "${words[@]}"
}
says() { # FILE KIND WORD...
  local file=$1 line; shift
  line=$(grep -a "$1" "$file") || { cat "$file"; die "no $1"; }; shift
  for word in "$@"; do grep -qF -- "$word" <<< "$line" || die "'$word' is not in: $line"; done
}

set_() { local options=(-var kind csv -var out rows.csv); "$@" "${options[@]}"; }
set_ engine 2 whole.in
cp rows.csv whole.csv

# Rows too many, and a part of one.
{ cat whole.csv; head -c 100 whole.csv; } > rows.csv
set_ engine 2 rest.in
same rows.csv whole.csv "after too many rows"
says rest.in.screen 'cut off' "ledger file 'rows.csv' continues after the " " rows and a part of a row after them cut off"
kept=$(grep -oE 'after the [0-9]+' rest.in.screen | grep -oE '[0-9]+'); cut=$(grep -oE '[0-9]+ rows and a part' rest.in.screen | grep -oE '^[0-9]+')
all=$(count_rows whole.csv)
[ $((kept + cut)) = "$all" ] && [ "$cut" -gt 20 ] || die "$kept rows kept and $cut cut off of $all"

# Rows that are missing, other rows, no file; what is there stays. A file of another name begins anew.
head -c $((kept / 2 * 150)) whole.csv > rows.csv; cp rows.csv before
ranks=2 set_ refuses rest.in "'rows.csv' has " "rows, and the restart file counts $kept: " "are missing" --
same rows.csv before "a file that was refused"
found=$(grep -oE "has [0-9]+ rows" screen | grep -oE '[0-9]+'); missing=$(grep -oE "[0-9]+ are missing" screen | grep -oE '^[0-9]+')
[ $((found + missing)) = "$kept" ] && [ "$found" -gt 20 ] || die "$found found, $missing missing, $kept wanted"
[ "$found" = "$(count_rows rows.csv | awk '{ print $1 - 1 }')" ] || [ "$found" = "$(count_rows rows.csv)" ] || die "$found rows are said to be there"
at=$(stat -c %s whole.csv); at=$((at * kept / all - 300))
{ head -c $at whole.csv; printf '9'; tail -c +$((at + 2)) whole.csv; } > rows.csv; cp rows.csv before
set_ refuses rest.in "'rows.csv' is not that of the restart file" --
same rows.csv before "a file that was refused"
rm rows.csv
set_ refuses rest.in "'rows.csv' is gone, and the restart file counts $kept rows" --
[ ! -e rows.csv ] || die "rows.csv was made by a run that was refused"
rm -f new.csv
engine 1 rest.in -var kind csv -var out new.csv
says rest.in.screen 'begins here' "'new.csv' begins here" "$kept rows of 'rows.csv'"
[ "$(count_rows new.csv)" = "$cut" ] || die "a new ledger has other rows"

# A new run writes over an old file.
{ echo old; cat whole.csv; } > rows.csv
set_ engine 1 whole.in
same rows.csv whole.csv "a new run"
# A file whose columns are others.
sed 's/,cor_n,/,cor_m,/' whole.csv > rows.csv
refuses rest.in "not one to append to" -- -var kind csv -var out rows.csv

# Two walls, and two runs, with one file.
{ head_ 'read_data grains.data'; echo "$wall ledger 70 file rows.csv
fix v all wall/rebound primitive type 2 zplane 1e-3 ledger 70 file ./rows.csv
run 10"; } > two.in
ranks=2 refuses two.in "'./rows.csv' is being written by another wall or run" "a file of its own"
cp whole.csv rows.csv
exec 8<> rows.csv; flock 8
refuses whole.in "'rows.csv' is being written by another wall or run" -- -var kind csv -var out rows.csv
exec 8>&-
same rows.csv whole.csv "a file that another run has"

# Write errors. limited RANKS KILOBYTES SCRIPT: no file may become larger.
printf '#!/usr/bin/env bash\ntrap "" XFSZ; ulimit -f "$1"; shift; exec "$@"\n' > limit; chmod +x limit
limited() { timeout 60 mpirun --mca btl self,tcp -np "$1" ./limit "$2" "$program" -in "$3" -log none "${@:4}" > screen 2>&1; }
{ head_ 'read_data grains.data'; echo "$wall ledger 20 file \${out} \${words}
run 250"; } > full.in
for n in 1 2; do
  engine 1 full.in -var out all.csv -var words "on_error stop"
  all=$(count_rows all.csv)
  if limited $n 20 full.in -var out rows.csv -var words "on_error stop"; then die "a full disk did not stop the run"; fi
  says screen ERROR "rows.csv" "File too large" "rows of the steps" "are lost"
  head -c "$(stat -c %s rows.csv)" all.csv > part
  same part rows.csv "what a full disk has left"
  first=$(stat -c %s rows.csv); [ "$first" -gt 5000 ] || die "only $first bytes before the error"
  limited $n 20 full.in -var out rows.csv -var words "on_error go_on" || die "on_error go_on: $(cat screen)"
  says screen WARNING "rows.csv" "File too large"
  [ "$(grep -c 'WARNING.*File too large' screen)" -ge 3 ] || die "windows without a warning"
  lost=$(grep -oE '[0-9]+ rows of the steps' screen | awk '{ sum += $1 } END { print sum }')
  written=$(count_rows rows.csv)
  [ $((written + lost)) = "$all" ] || die "$written rows written, $lost told as lost, $all in all"
  grep -q " $lost in all" screen || die "the last warning does not have $lost in all"
  [ "$(tail -c 1 rows.csv | od -An -tx1 | tr -d ' ')" = 0a ] || die "the file has a part of a row"
done
ranks=2 refuses full.in "/dev/full" "it is not a regular file" -- -var out /dev/full -var words "on_error go_on"
{ head_ 'read_data grains.data'; echo "$wall ledger 20 file folder/rows.csv
run 100
shell rm folder/rows.csv
shell rmdir folder
run 150"; } > gone.in
mkdir folder
ranks=2 refuses gone.in "'folder/rows.csv' failed: it has been deleted" "rows of the steps 10"
refuses full.in "'rows.npy'; ledgers are CSV, such as rows.csv" -- -var out rows.npy -var words "on_error stop"
refuses full.in "/nowhere/rows.csv" "No such file" -- -var out /nowhere/rows.csv -var words "on_error go_on"
refuses full.in "on_error is 'maybe'; it must be stop or go_on" -- -var out rows.csv -var words "on_error maybe"
{ head_ 'read_data grains.data'; echo "$wall ledger 20 on_error stop
run 1"; } > no_file.in
refuses no_file.in "on_error" "file FILE"
