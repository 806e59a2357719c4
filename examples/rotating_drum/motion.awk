# From a dump of the frame's check: per grain, change of its kinetic energy over the run, and drum's angular speed
# times the change of its angular momentum about the drum's axis, both per mass, in (m/s)^2. At each impact the wall's
# force does the work force . v_wall, which is omega times its torque; so the two are equal.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { OMEGA = 2 * atan2(0, -1) / 0.3 }
/^ITEM/ { atoms = /ITEM: ATOMS/; next }
atoms {
  e = ($5 * $5 + $6 * $6 + $7 * $7) / 2; l = $4 * $5 - $2 * $7
  if (!($1 in e0)) { e0[$1] = e; l0[$1] = l }
  e1[$1] = e; l1[$1] = l
}
END { for (i in e0) print e1[i] - e0[i], OMEGA * (l1[i] - l0[i]), e0[i] }
