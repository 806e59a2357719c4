#!/usr/bin/env bash
# Large files cost as much as they are long, not as their length squared: a limit on memory and one on
# processor time that leave room for a slow machine.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"
limited() { (ulimit -v 2000000 -t 120; OMP_NUM_THREADS=1 "$asperity" "$@"); }

# compare: a hundred thousand impacts against a thousand rows of means, and as many points. The mean over 4 degrees
# of cor_n = (alpha1 + 1)/100 is that of its middle.
awk 'BEGIN { print "alpha1_deg,cor_n,cor_t"; for (i = 1; i <= 100000; i++) print (i * 7919 % 100000) * 9e-4 "," (i * 7919 % 100000) * 9e-6 + 0.01 ",0.5" }' > impacts
awk 'BEGIN { print "alpha1_deg,cor_n_mean,cor_n_sd"; for (i = 0; i < 1000; i++) print (i * 7919 % 1000) * 9e-2 ",0.3,0.1" }' > means
limited compare impacts means > out || die "compare with means"
grep -v '^#' out | awk -F, 'NR > 1 && $1 == "cor_n" && $3 > 0 && $4 < 90 { n++
  want = ($3 + 2 + 1) / 100
  d = $8 - want; if (d > 2e-5 || d < -2e-5) bad++
  d = $10 - 0.04 / sqrt(12); if (d > 1e-4 || d < -1e-4 || $7 < 4440 || $7 > 4446) bad++ }
  END { print n, bad + 0 }' > verdict
[ "$(cut -d' ' -f1 verdict)" -gt 900 ] && [ "$(cut -d' ' -f2 verdict)" = 0 ] || die "compare with means: $(cat verdict)"
limited compare impacts impacts --bin 0.1 --near 0.0001 > out || die "compare with points"
[ "$(awk -F, '$1 == "cor_n" && ($8 - $13) ^ 2 < 1e-10 && $10 == $15' out | wc -l)" = 900 ] || die "compare with points: $(head -n 5 out)"
# Its memory does not grow with the impacts, and ten times as many have the same means.
for k in 1 2 3 4 5 6 7 8 9 10; do tail -n +$((k > 1 ? 2 : 1)) impacts; done > ten
for data in means ""; do
  limited compare impacts $data | grep -v '^#' | awk -F, '{ print $1 "," $2 "," $8 }' | grep -v score > wanted
  (ulimit -v 100000; OMP_NUM_THREADS=1 "$asperity" compare ten $data > out) || die "compare: memory, with '$data'"
  grep -v '^#' out | awk -F, '{ print $1 "," $2 "," $8 }' | grep -v score | cmp - wanted || die "compare: ten times the impacts, with '$data'"
done

# cor: the memory of a summary does not grow with the impacts
(ulimit -v 600000; OMP_NUM_THREADS=1 "$asperity" cor surface sigma 5 --angles 30,60 --samples 2000000 --summary -o /dev/null) || die "cor --summary"

# materials and tables
awk 'BEGIN { print "name,youngs_modulus_pa,poissons_ratio,density_kg_m3"; for (i = 0; i < 1000000; i++) print "m" i ",7e10,0.2,2000" }' > materials
limited cor materials ard m999999 file materials --angles 45 --samples 2 > out || die "materials"
[ "$(wc -l < out)" = 4 ] || die "materials: $(cat out)"
echo m500000,7e10,0.2,2000 >> materials
limited cor materials ard m500000 file materials 2> err && die "a name that is there twice"
grep -q "'m500000' is there twice" err || die "a name that is there twice: $(cat err)"
awk 'BEGIN { print "alpha1_deg,v1_m_s,cor_n,cor_t"; for (i = 0; i < 1000; i++) for (k = 0; k < 200; k++) print 0.09 * i "," k ",0.5,0.5" }' > table
limited cor rebound table table --angles 45 > out || die "table"
exit 0
