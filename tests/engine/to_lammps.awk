# The script of an engine test in the language of LAMMPS: what the tests use of LIGGGHTS's language, and nothing else.
# Meshes become `stl` of their wall, with the motion that `fix move/mesh` gives them; the constants of `fix
# property/global` become a file of materials, `constants`, in SI units, and numbers of the wall and of the pair style.
# Usage: awk -v into=constants -f to_lammps.awk SCRIPT
# SPDX-License-Identifier: GPL-3.0-or-later
function value(name) { return (name in global) ? global[name] : "" }

# The words after the first n, with blanks between.
function behind(n,   i, text) { for (i = n + 1; i <= NF; i++) text = text (i > n + 1 ? " " : "") $i; return text }

# Of a contact between soft grains, or of one with a wall: LAMMPS's words for LIGGGHTS's constants.
function contact(line) {
  elastic = value("coefficientRestitution") == 1 # where Tsuji's formula loses a little
  return "hertz/material " value("youngsModulus") " " (elastic ? 0 : value("coefficientRestitution")) " " value("poissonsRatio") \
    (line ~ /tangential history/ ? " tangential mindlin NULL 1.0 " value("coefficientFriction") : " tangential linear_nohistory 0 0") \
    (elastic ? " damping velocity" : " damping tsuji")
}

# The materials of all types, and what belongs to pairs of them, where the law takes them and they are not the defaults.
function physics(line,   words, t, pair) {
  words = ""
  pair = line !~ / rebound / || line ~ / rebound (bons|thornton_ning) /
  if (pair && line !~ / materials / && n_types > 0) {
    words = " materials"
    for (t = 1; t <= n_types; t++) words = words " own" t
    words = words " file constants"
  }
  if (pair && line !~ / (surface_energy|deposit off) / && value("surfaceEnergy") != "" && value("surfaceEnergy") != 0.8) words = words " surface_energy " value("surfaceEnergy")
  if (line !~ / (friction|rebound walton) / && value("coefficientFriction") != "" && value("coefficientFriction") != 0.3) words = words " friction " value("coefficientFriction")
  return words
}

function read(line,   name, kind) {
  $0 = line
  if ($1 == "include") { name = $2; while ((getline line < name) > 0) read(line); close(name); return }
  if ($1 == "units") pascal = $2 == "cgs" ? 10 : $2 == "micro" ? 1e-3 : $2 == "nano" ? 1e-6 : 1
  if ($1 == "fix" && $4 == "property/global") {
    from = $6 == "peratomtypepair" ? 8 : 7
    global[$5] = $from
    if ($6 == "peratomtype") { n_types = NF - 6; for (i = 7; i <= NF; i++) each[$5, i - 6] = $i }
    dropped[$2] = 1
    return
  }
  if ($1 == "fix" && $4 ~ /^mesh\/surface/) {
    mesh[$2] = "stl " $6 " type " $8
    if ($0 ~ / scale /) { match($0, / scale [^ ]+/); mesh[$2] = mesh[$2] substr($0, RSTART, RLENGTH) }
    dropped[$2] = 1
    return
  }
  if ($1 == "fix" && $4 == "move/mesh") {
    kind = $7
    text = behind(7)
    gsub(/(origin|axis|period|amplitude) /, "", text)
    motion[$6] = " move " kind " " text
    dropped[$2] = 1
    return
  }
  lines[++n] = $0
  if ($1 == "clear") write()
}
{ read($0) }
END {
  write()
  print "name,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa" > into
  for (t = 1; t <= n_types; t++)
    printf "own%d,%.17g,%s,2650,%s\n", t, each["youngsModulus", t] / pascal, each["poissonsRatio", t],
      (("yieldStress", t) in each) ? sprintf("%.17g", each["yieldStress", t] / pascal) : "" > into
}

# The lines up to a `clear`, behind which the IDs of meshes mean others.
function write(   k, words, from, rest, line, pair, hard) {
  for (k = 1; k <= n; k++) hard = hard || lines[k] ~ /^hard_particles/
  for (k = 1; k <= n; k++) {
    $0 = line = lines[k]
    if ($0 == "atom_style granular") line = "atom_style sphere"
    else if ($1 == "communicate") line = "comm_modify vel yes"
    else if ($1 == "hard_particles" || $1 == "unfix" && $2 in dropped || $1 == "dump" && $4 == "mesh/vtk") continue
    else if ($1 == "pair_style") { if (hard) continue; pair = contact($0); line = "pair_style granular" }
    else if ($1 == "pair_coeff") { if (hard) continue; line = "pair_coeff * * " pair }
    else if ($1 == "dump_modify") sub(/ format "/, " format line \"", line)
    else if ($1 == "fix" && $4 == "wall/gran") {
      match($0, /primitive type [0-9]+ /)
      line = "fix " $2 " " $3 " wall/gran granular " contact($0) " " substr($0, RSTART + RLENGTH) " NULL"
    } else if ($1 == "fix" && $4 == "wall/rebound") {
      if ($5 == "primitive") {
        words = $8 " " $9; from = 9
        if ($8 ~ /cylinder/) { words = words " " $10 " " $11; from = 11 }
        if ($(from + 1) == "shear") { words = words " shear " $(from + 2) " " $(from + 3); from += 3 }
        words = words " type " $7
      } else if ($5 == "mesh" && $7 == 1) { words = mesh[$9] motion[$9]; from = 9 }
      else { print; continue } # LAMMPS's own already
      rest = behind(from)
      line = "fix " $2 " " $3 " wall/rebound " words physics(" " rest " ") (rest == "" ? "" : " " rest)
    }
    print line
  }
  n = 0
  split("", mesh); split("", motion); split("", dropped)
}
