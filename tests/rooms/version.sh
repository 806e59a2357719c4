#!/usr/bin/env bash
# The version of the header is that of the newest part of the change log, and that by which pages say to cite it.
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
says CITATION.cff "$(sed -n 's/^version: //p' CITATION.cff)"
says README.md "$(sed -n 's/^ *version *= {\(.*\)},$/\1/p' README.md)"
exit $bad
