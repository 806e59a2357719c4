#!/usr/bin/env bash
# Walls over an area: trade --three-d.
set -euo pipefail
asperity=${ASPERITY_BIN:-$(dirname "$0")/../../build/bin}/asperity
asperity=$(cd "$(dirname "$asperity")" && pwd)/asperity
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT; cd "$work"
die() { echo "FAILED: $*" >&2; exit 1; }

# trade --three-d: a row per model; `visible` is close in both angles, a cut normal law is not.
"$asperity" trade --three-d --rq 5um --lambda-c 40um --dp 10um --angles 10 --rays 20000 --surfaces 3 --points 512 > rows
[ "$(sed -n 2p rows)" = model,alpha1_deg,ns_per_impact,kl_first_hit,kl_rebound,kl_rebound_se,mean_rebound_deg,mean_rebound_reference_deg,mean_rebound_reference_se_deg,kl_lateral,kl_lateral_se,mean_lateral_deg,mean_lateral_reference_deg,sd_lateral_deg,sd_lateral_reference_deg,later_share,later_share_reference ] ||
  die "trade --three-d: columns"
[ "$(grep -vc '^#' rows)" = $(($("$asperity" spread --list | grep -vc -e '^#' -e '^name' -e '^model') + 1)) ] || die "trade --three-d: rows"
awk -F, '$1 == "visible" && $5 < 0.01 && $6 > 0 && $6 < 0.005 && $10 < 0.005 && $15 > 5.7 && $15 < 6.5 && $17 > 0.05 && $17 < 0.1 { good++ }
  $1 == "truncated" && $5 > 0.03 { good++ } END { exit good != 2 }' rows || die "trade --three-d: $(cat rows)"
got=0; "$asperity" trade --three-d --rq 5um --lambda-c 40um --dp 10um --points 500 > out 2> err || got=$?
[ $got = 2 ] && grep -q 'a power of two' err || die "trade --three-d --points 500: $(cat err)"
