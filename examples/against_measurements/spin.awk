# Spin and rebound angle of the contact point after the impacts of a model (`asperity cor`, smooth wall, no spin before), beside
# the measured ones. A force at the contact point leaves the angular momentum about that point as it is, whatever the law, so
# CoR_T gives both: omega = 5/2 (1 - CoR_T) v_T1/r; the contact point leaves with v_T2 - r omega along the wall.
#   awk -F, -f spin.awk ../data/kharaz_spin.csv impacts.csv: kind,quantity,theta_deg,measured,model; spin as its size
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { RAD = atan2(0, -1) / 180 }
/^#/ || /^kind/ || /^dp_um/ { next }
FNR == NR { if ($3 != "cor_t") { n++; kind[n] = $1; theta[n] = $2; quantity[n] = $3; value[n] = $4 < 0 && $3 == "spin" ? -$4 : $4 } next }
{
  key = sprintf("%.2f", 90 - $3)
  if (key in spin) next
  along = $2 * cos($3 * RAD); off = $2 * sin($3 * RAD) * $8; r = $1 * 0.5e-6
  spin[key] = 2.5 * (1 - $9) * along / r
  angle[key] = atan2(along * $9 - r * spin[key], off) / RAD
}
END {
  for (i = 1; i <= n; i++) {
    key = sprintf("%.2f", theta[i])
    printf "%s,%s,%s,%s,%.4g\n", kind[i], quantity[i], theta[i], value[i], quantity[i] == "spin" ? spin[key] : angle[key]
  }
}
