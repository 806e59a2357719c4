# Makes blade.csv, a profile that looks measured and is not: out of a generated one (x_um,z_um, see run)
# valleys made flatter and peaks sharper than Gaussian, the curve and tilt of a blade, noise of 0.01 um, two
# spikes of dust, a gap of 25 points that the instrument lost, bad points, and positions rounded to 0.1 um
# in a file with an instrument's header.
# SPDX-License-Identifier: GPL-3.0-or-later
function noise(  i, sum) { sum = 0; for (i = 0; i < 12; i++) sum += rand(); return 0.01 * (sum - 6) }
BEGIN {
  FS = ","; srand(7)
  printf "Scan Parameters\r\nSample,SYNTHETIC: made by make_blade.awk and not measured\r\n"
  printf "Stylus,Radius: 2.0 \265m\r\nLength,2000.0 um\r\nResolution,0.391 um/sample\r\n\r\n"
  printf "Scan Data\r\nLateral um,Raw Micrometer,\r\n"
}
/^#/ || /^x/ { next }
{
  x = $1; z = $2; n++
  z += 0.02 * (z * z - 64)
  z += 12 + 0.008 * x - 30 * ((x - 1000) / 1000) ^ 2 + noise()
  if (n == 1300 || n == 1301) z += 35
  if (n == 3620) z += 22
  height = sprintf("%.5f", z)
  if (n >= 2400 && n < 2425) next
  if (n == 700 || n == 4100) height = "nan"
  printf "%.1f,%s,,\r\n", x, height
}
