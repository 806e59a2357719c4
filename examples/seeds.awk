# Means and standard errors over runs of one case with several seeds, for the programs reading.awk of the examples.
# add() takes one value of one run; show() formats the mean: "m" of a single run, "m +- se" of several.
# SPDX-License-Identifier: GPL-3.0-or-later
function add(name, what, value) {
  if (!(name in has_case)) { has_case[name] = 1; names[++cases] = name }
  runs[name, what]++; sum[name, what] += value; squares[name, what] += value ^ 2
}
function show(name, what, form,   n, mean, variance) {
  n = runs[name, what]; mean = sum[name, what] / n; variance = squares[name, what] / n - mean ^ 2
  return n < 2 ? sprintf(form, mean) : sprintf(form " +- " form, mean, sqrt((variance > 0 ? variance : 0) / (n - 1)))
}
# The case of a file: output/rough-2.csv is the run of case "rough" with seed 2, output/rough.csv that with seed 1.
function case_of(file) { sub(/.*\//, "", file); sub(/(-[0-9]+)?\.[a-z]+$/, "", file); return file }
