# From a table of a gas to the line of gas.pipe: straight between the rows, constant outside of them. The table has the place
# (r/R, rising) and the value, in columns `x` and `y` of a CSV with # comments; values are multiplied by `scale`.
#   awk -F, -f table.awk -v name=U -v of='f_at[1]' -v x=1 -v y=2 cfd.csv        variable U atom "..."
#   with -v slope=1 -v length_=0.075: the derivative instead, over `length_` (d s_n/dr of S from the table of s_n)
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { if (!x) x = 1; if (!y) y = 2; if (!scale) scale = 1; if (!length_) length_ = 1 }
/^#/ || $x !~ /^[-+.0-9]/ { next }
{ n++; at[n] = $x; value[n] = $y * scale }
END {
  text = slope ? "0*" of : sprintf("%.6g", value[1])
  for (i = 1; i <= n; i++) { # at each row the slope changes
    after = i < n ? (value[i + 1] - value[i]) / (at[i + 1] - at[i]) : 0
    change = after - before; before = after
    text = text sprintf(slope ? "%+.6g*(%s>%.6g)" : "%+.6g*(%s>%.6g)*(%s-%.6g)", slope ? change / length_ : change, of, at[i], of, at[i])
  }
  printf "variable %s atom \"%s\"\n", name, text
}
