#!/bin/sh
# Writes a page of the manual for the command and for each of its subcommands.
# Usage: man_pages.sh FOLDER PROGRAM..., where the program may be an emulator with the program behind it.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
folder=$1
shift
mkdir -p "$folder"
for command in $("$@" --help=words); do
  case $command in
    help | --*) ;;
    *) "$@" "$command" --help=man > "$folder/asperity-$command.1" ;;
  esac
done
"$@" --help=man > "$folder/asperity.1"
