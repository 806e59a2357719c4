# The results in words: the table of models, the fits, the spins, and the distance of two distributions.
# SPDX-License-Identifier: GPL-3.0-or-later
FNR == 1 { file++; next }
file == 1 { rms[$1 "," $2] = $3 }
file == 2 { value[$1 "," $2] = $3; error[$1 "," $2] = $4; high[$1 "," $2] = $6 }
file == 3 { off[$1 "," $2 "," $3] = $5 }
file == 4 { distance[$1] = $2 }
BEGIN { FS = "," }
END {
  print "Reading:"
  printf "  scatter: means and sd of CoR_N of Grant & Tabakoff allow sigma up to %.1f degrees at 95 %%, those of both coefficients up to %.2f\n",
    high["normal,sigma"], high["both,sigma"]
  printf "  friction: from the sliding angles of Kharaz et al. alone mu is %.4f ± %.4f (measured apart: 0.092); bons needs %.2f ± %.2f over all of them\n",
    value["kharaz_sliding,mu"], error["kharaz_sliding,mu"], value["kharaz_bons,friction"], error["kharaz_bons,friction"]
  printf "  rms difference of CoR_T from Kharaz et al.: walton %s, with compliance 0.7 %s, bons %s, bons fitted %s\n",
    rms["kharaz_2001,walton"], rms["kharaz_2001,walton_compliance"], rms["kharaz_2001,bons"], rms["kharaz_2001,bons_fitted"]
  printf "  rms difference from the experiment of Kharaz et al.: spin %.0f rad/s, contact angle %.1f degrees by walton; %.0f rad/s, %.1f degrees with compliance 0.7\n",
    off["experiment,spin,walton"], off["experiment,contact_angle_deg,walton"], off["experiment,spin,walton_compliance"], off["experiment,contact_angle_deg,walton_compliance"]
  printf "  LaMarche et al.: Kolmogorov-Smirnov distance of a smooth wall %s, of a rough one with sigma %.1f degrees %s, of eccentric beads %s, of yield stresses that scatter by %.3f %s\n",
    distance["smooth"], value["lamarche,sigma"], distance["rough"], distance["lever"], value["lamarche_scatter,scatter"], distance["scatter"]
  printf "  grains on a bed: rms difference of walton 0.7 %s, with sigma %.0f degrees and e %.2f fitted %s, of grant_tabakoff %s\n",
    rms["grain_bed,walton"], value["bed,sigma"], value["bed,e"], rms["grain_bed,walton_rough"], rms["grain_bed,grant_tabakoff"]
}
