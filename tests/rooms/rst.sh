#!/usr/bin/env bash
# The page of LAMMPS's fix as LAMMPS's manual wants it: only ASCII, American spelling, and Sphinx builds it without a
# warning. Skipped where there is no Sphinx (Debian: python3-sphinx).
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
home=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
page=$home/src/lammps/fix_wall_rebound.rst
die() { echo "FAILED: $*" >&2; exit 1; }
if LC_ALL=C grep -n '[^ -~]' "$page"; then die "the page has characters that are not ASCII"; fi
if grep -nwiE '(neighbou?r|colou?r|behaviou?r)s?|centre[ds]?|licence|meters?|[a-z]*(ours|ise|ised|ising|isation)' "$page" |
  grep -wiE 'neighbours?|colours?|behaviours?|centre[ds]?|licence|meters?|(real|normal|general|initial|organ)is(e|ed|ing|ation)'; then
  die "the page has British spelling"
fi
command -v sphinx-build > /dev/null || { echo "no sphinx-build"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$page" "$work"
# The other pages of the manual that it links to, empty; and LAMMPS's lexer is not here.
tr '\n' ' ' < "$page" | grep -oE ':doc:`[^<`]*<[a-zA-Z_]+>`' | sed -E 's/.*<(.*)>`/\1/' | sort -u | while read -r name; do
  printf '%s\n%s\n' "$name" "$(tr -c '\n' = <<< "$name")" > "$work/$name.rst"
done
{ printf 'Pages\n=====\n\n.. toctree::\n   :glob:\n\n   *\n'; } > "$work/index.rst"
cat > "$work/conf.py" << 'END'
from pygments.lexers.special import TextLexer
def setup(app):
    app.add_lexer("LAMMPS", TextLexer)
END
(cd "$work" && LC_ALL=C.UTF-8 sphinx-build -q -W --keep-going -n -b html . html) || die "Sphinx has warnings"
for section in Syntax Examples Description Restrictions "Related commands" Default; do
  grep -q "<h2>$section<" "$work/html/fix_wall_rebound.html" || die "there is no section '$section'"
done
