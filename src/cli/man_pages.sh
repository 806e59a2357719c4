#!/bin/sh
# Writes a page of the manual for the command and for each of its subcommands, by help2man.
# Usage: man_pages.sh FOLDER PROGRAM..., where the program may be an emulator with the program behind it.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
folder=$1
shift
mkdir -p "$folder"
version=$("$@" --version | sed 's/.* //')
# page NAME SUMMARY COMMAND: the include file on standard input
page() {
  { printf '[name]\n%s \\- %s\n' "$1" "$2"; cat; } > "$folder/include"
  help2man -N --version-string "asperity $version" -i "$folder/include" -o "$folder/$1.1" "$3"
}
"$@" --help | sed -n '/^Commands:$/,/^$/s/^  //p' | while read -r command summary; do
  printf '[see also]\n.BR asperity (1)\n' | page "asperity-$command" "$summary" "$* $command"
done
{ printf '[description of a wall]\n.nf\n'; "$@" help wall | sed 's/\\/\\e/g; s/-/\\-/g; s/^\([.'"'"']\)/\\\&\1/'; printf '.fi\n'; } |
  page asperity "rough walls for particle simulation" "$*"
rm "$folder/include"
