#!/bin/sh
# Writes a page of the manual for the command and for each of its subcommands.
# Usage: man_pages.sh PROGRAM FOLDER
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
program=$1
folder=$2
mkdir -p "$folder"
for command in $("$program" --help=words); do
  case $command in
    help | --*) ;;
    *) "$program" "$command" --help=man > "$folder/asperity-$command.1" ;;
  esac
done
"$program" --help=man > "$folder/asperity.1"
