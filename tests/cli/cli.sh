# Shared by the tests of the command: each sources it. They run the built command, $asperity, in a folder of their
# own and look at what it writes. ASPERITY_BIN is the folder of the binaries (build/bin where it is not set).
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
asperity=$(cd "${ASPERITY_BIN:-$root/build/bin}" && pwd)/asperity
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
cd "$work"

die() { echo "FAILED: $*" >&2; exit 1; }

# Stands before the first picture of a test, whose rest is skipped where there is no gnuplot.
draws() { command -v gnuplot > /dev/null || { echo "no gnuplot: the pictures, and what follows them, are not tested"; exit 77; }; }

# The options that the help of a command lists.
options_of() { "$asperity" "$1" --help 2> /dev/null | grep -o '^  --[a-z_-]*' | tr -d ' '; }

# For a table with a header below its comments: its rows, the header, and a column by its name.
rows() { grep -v '^#' "$1" | tail -n +2; }
header() { grep -v '^#' "$1" | head -n 1; }
column() { # NAME FILE
  awk -F, -v name="$1" '/^#/ { next } !k { for (i = 1; i <= NF; i++) if ($i == name) k = i; next } { print $k }' "$2"
}

# refuses STATUS WORD... -- ARGUMENTS: exits with the status, says one line with the words, besides warnings, writes
# nothing.
refuses() {
  local status=$1 words=() got=0; shift
  while [ "$1" != -- ]; do words+=("$1"); shift; done; shift
  "$asperity" "$@" > out 2> err || got=$?
  [ $got = "$status" ] || die "exit $got, not $status: asperity $*: $(cat err)"
  [ ! -s out ] || die "wrote something: asperity $*"
  [ "$(grep -vc "^asperity: warning: " err)" = 1 ] || die "not one line of message: asperity $*: $(cat err)"
  for word in "${words[@]}"; do grep -qF -- "$word" err || die "'$word' is not in: $(cat err)"; done
}

# refuses_rows SECTION: each row of it in refused.txt: arguments of the command, and words of what it says, parted by @.
refuses_rows() {
  local row words arguments
  while read -r row; do
    readarray -t words < <(sed 's/ *@ */\n/g' <<< "$row")
    read -ra arguments <<< "${words[0]}"
    refuses 2 "${words[@]:1}" -- "${arguments[@]}"
  done < <(sed -n "/^\[$1\]$/,/^$/p" "$root/tests/cli/refused.txt" | sed '/^\[/d; /^$/d')
}
