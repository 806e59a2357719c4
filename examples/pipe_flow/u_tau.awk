# The friction velocity u_tau of a smooth pipe of radius R in which a gas of kinematic viscosity nu has the bulk speed Ub,
# by Reichardt's profile (the one of gas.pipe): the u_tau whose profile has that mean over the cross-section.
#   awk -f u_tau.awk -v R=0.075 -v nu=1.5e-5 -v Ub=27
# SPDX-License-Identifier: GPL-3.0-or-later
function speed(q, u_tau) { # of the gas at r/R = q
  yp = (1 - q) * R * u_tau / nu
  return u_tau * (2.5 * log((1 + 0.4 * yp) * 1.5 * (1 + q) / (1 + 2 * q * q)) + 7.8 * (1 - exp(-yp / 11) - yp / 11 * exp(-0.33 * yp)))
}
function bulk(u_tau,   i, q, sum) {
  for (i = 0; i < 2000; i++) { q = (i + 0.5) / 2000; sum += 2 * q * speed(q, u_tau) / 2000 }
  return sum
}
BEGIN {
  low = Ub / 100; high = Ub / 5
  for (i = 0; i < 50; i++) { u_tau = (low + high) / 2; if (bulk(u_tau) < Ub) low = u_tau; else high = u_tau }
  printf "%.6g\n", u_tau
}
