#!/usr/bin/env bash
# Runs test_locale in a locale with a decimal comma, which is made here. Usage: locale.sh PROGRAM
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
printf 'LC_NUMERIC\ndecimal_point ","\nthousands_sep "."\ngrouping 3;3\nEND LC_NUMERIC\n' > "$work/source"
printf '<code_set_name> ASCII\nCHARMAP\n<U0001>..<U007F> /x01\nEND CHARMAP\n' > "$work/charmap" # the package locales has more
localedef -c -f "$work/charmap" -i "$work/source" "$work/xx_COMMA" > "$work/log" 2>&1 || true
[ -e "$work/xx_COMMA/LC_NUMERIC" ] || { cat "$work/log"; echo "localedef makes no locale"; exit 1; }
LOCPATH=$work LC_ALL='' LC_NUMERIC=xx_COMMA "$1"
