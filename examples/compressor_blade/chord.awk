# From a ledger: impacts of each grain's first contact and later ones on the pressure side over the chord, in
# bins of a twentieth. Columns: position along the chord, first impacts, later impacts, deposits.
#   awk -f blade.awk -f chord.awk smooth.csv > smooth.chord
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { FS = ","; set_up() }
/^#/ || $1 == "tag" { next }
{
  i = int($5 / 2) % LOOP
  if (i < NC) next
  section($7 / SPAN * NS)
  ex = PX[i + 1] - PX[i]; ez = PZ[i + 1] - PZ[i]
  f = (($6 - PX[i]) * ex + ($8 - PZ[i]) * ez) / (ex * ex + ez * ez)
  b = int(20 * (position(i) + f * (position(i + 1) - position(i))))
  if (b > 19) b = 19
  if ($2 == 1) first[b]++; else later[b]++
  stuck[b] += $19 == 1
}
END { for (b = 0; b < 20; b++) print (b + 0.5) / 20, first[b] + 0, later[b] + 0, stuck[b] + 0 }
