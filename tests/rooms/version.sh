#!/usr/bin/env bash
# The version of src/asperity.h is that of the change log and of the citations. The date of a release is in none of them
# before there is one, and in all of them in the commit that its tag names. A release changes these two, and this test
# names what else is left.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
version=$(sed -n 's/^#define ASP_VERSION_[A-Z]* //p' src/asperity.h | paste -sd.)
[[ $version =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] || { echo "FAILED: the version in src/asperity.h is '$version'"; exit 1; }
bad=0
says() { # FILE VERSION
  [ "$2" = "$version" ] || { echo "FAILED: $1 says version '$2'; in src/asperity.h it is '$version'"; bad=1; }
}
says .github/CHANGELOG.md "$(sed -n 's/^## //p' .github/CHANGELOG.md | head -n 1)"
says codemeta.json "$(sed -n 's/^ *"version": "\(.*\)",$/\1/p' codemeta.json)"
says CITATION.cff "$(sed -n 's/^version: //p' CITATION.cff)"
says src/python "$(sed -n 's/^__version__ = "\(.*\)"$/\1/p' src/python/asperity/__init__.py)"
released=$(sed -n 's/^date-released: //p' CITATION.cff)
if [ -n "$(git tag --list "v$version" --points-at HEAD 2> /dev/null)" ] && [ -z "$released" ]; then
  echo "FAILED: CITATION.cff has no date-released, and this commit is v$version"; bad=1
fi
dated() { # FILE DATE FORMAT
  local wanted=; [ -z "$released" ] || wanted=$(LC_ALL=C date -d "$released" "+$3")
  [ "$2" = "$wanted" ] || { echo "FAILED: $1 is dated '$2'; by CITATION.cff it is '$wanted'"; bad=1; }
}
dated codemeta.json "$(sed -n 's/^ *"datePublished": "\(.*\)",$/\1/p' codemeta.json)" %F
[ -z "$released" ] || dated .github/paper.md "$(sed -n 's/^date: //p' .github/paper.md)" '%-d %B %Y'
exit $bad
