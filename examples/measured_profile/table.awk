# The slopes with spikes and form taken out beside those with them left in.
# SPDX-License-Identifier: GPL-3.0-or-later
/^#/ || /^dp_um/ { next }
FNR == NR { slope[$1] = $6; sd[$1] = $9; order[++n] = $1; next }
{ careless[$1] = $6 }
END {
  printf "%8s %10s %14s %26s\n", "dp / um", "rms slope", "angle sd / deg", "rms slope, spikes left in"
  for (i = 1; i <= n; i++) printf "%8g %10.4f %14.2f %26.4f\n", order[i], slope[order[i]], sd[order[i]], careless[order[i]]
}
