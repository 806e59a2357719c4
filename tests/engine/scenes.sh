# Soft grains and meshes for granular scenes, for the engine tests and the benchmarks.
# SPDX-License-Identifier: GPL-3.0-or-later

# soft BOX [FRICTION RESTITUTION]: the beginning of a script with soft grains of 8 mm, of one type, as a granular
# scene has them; their Rayleigh time is 4.9e-4 s.
rayleigh=4.896e-4
soft() {
  cat << END
units si
atom_style granular
atom_modify map array
boundary ${boundary:-f f f}
newton off
communicate single vel yes
region box block $1 units box
create_box 1 box
neighbor 0.002 bin
neigh_modify delay 0
END
  springs "${2:-}" "${3:-}"
}

# springs [FRICTION RESTITUTION]: what holds soft grains of one type apart.
springs() {
  cat << END
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 ${2:-0.9}
fix m4 all property/global coefficientFriction peratomtypepair 1 ${1:-0.3}
pair_style gran model hertz tangential history
pair_coeff * *
END
}

# put ID X Y Z VX VY VZ, a line each: single grains, for a script.
put() {
  awk -v d="${1:-0.008}" '
    { print "create_atoms 1 single", $2, $3, $4, "units box"; speeds = speeds sprintf("set atom %d vx %s vy %s vz %s\n", $1, $5, $6, $7) }
    END { printf "set group all diameter %s density 2500\n%s", d, speeds }'
}

# stack NX NY NZ PITCH SPEED: grains on a lattice about the z axis, above z = 0, with speeds below SPEED, for put.
stack() {
  awk -v nx="$1" -v ny="$2" -v nz="$3" -v pitch="$4" -v speed="$5" -v state="$((4710 + ${6:-1}))" '
    function speeds() { state = (16807 * state) % 2147483647; return (2 * state / 2147483647 - 1) * speed }
    BEGIN { for (k = 0; k < nz; k++) for (j = 0; j < ny; j++) for (i = 0; i < nx; i++)
      printf "%d %.9g %.9g %.9g %.9g %.9g %.9g\n", ++id, (i - (nx - 1) / 2) * pitch, (j - (ny - 1) / 2) * pitch, (k + 0.55) * pitch, speeds(), speeds(), speeds() }'
}

# stl: a mesh of triangles and quadrangles, a line each with the coordinates of its corners.
stl() {
  awk 'function vertex(k) { print "vertex", $(3 * k + 1), $(3 * k + 2), $(3 * k + 3) }
    function facet(a, b, c) { print "facet normal 0 0 0\nouter loop"; vertex(a); vertex(b); vertex(c); print "endloop\nendfacet" }
    BEGIN { print "solid s" } { facet(0, 1, 2); if (NF > 9) facet(0, 2, 3) } END { print "endsolid s" }'
}

# cube HALF: a closed box about the origin, for stl.
cube() {
  sed "s/-/-$1/g; s/+/$1/g" << END
- - -  + - -  + + -  - + -
- - +  + - +  + + +  - + +
- - -  - + -  - + +  - - +
+ - -  + + -  + + +  + - +
- - -  + - -  + - +  - - +
- + -  + + -  + + +  - + +
END
}

# meshes: hopper.stl, drum.stl with four lifters, and box.stl, which is open above.
meshes() {
  local closed='function wall(R, r, h, z, n,   k, a, b) { for (k = 0; k < n; k++) { a = 8 * atan2(1, 1) * k / n; b = 8 * atan2(1, 1) * (k + 1) / n
      print r * cos(a), r * sin(a), h, r * cos(b), r * sin(b), h, R * cos(b), R * sin(b), z, R * cos(a), R * sin(a), z } }'
  awk "$closed"'BEGIN { wall(0.04, 0.015, 0, 0.0091, 24); wall(0.04, 0.04, 0.0091, 0.15, 24) }' | stl > hopper.stl
  awk 'BEGIN { n = 32; R = 0.04; h = 0.015; for (k = 0; k < n; k++) { a = 8 * atan2(1, 1) * k / n; b = 8 * atan2(1, 1) * (k + 1) / n
      x = R * cos(a); z = R * sin(a); u = R * cos(b); w = R * sin(b)
      print x, -h, z, u, -h, w, u, h, w, x, h, z; print 0, -h, 0, x, -h, z, u, -h, w; print 0, h, 0, x, h, z, u, h, w
      if (k % 8 == 0) print x, -h, z, 0.8 * x, -h, 0.8 * z, 0.8 * x, h, 0.8 * z, x, h, z } }' | stl > drum.stl
  stl > box.stl << END
-0.025 -0.025 0  0.025 -0.025 0  0.025 0.025 0  -0.025 0.025 0
-0.025 -0.025 0  -0.025 0.025 0  -0.025 0.025 0.2  -0.025 -0.025 0.2
0.025 -0.025 0  0.025 0.025 0  0.025 0.025 0.2  0.025 -0.025 0.2
-0.025 -0.025 0  0.025 -0.025 0  0.025 -0.025 0.2  -0.025 -0.025 0.2
-0.025 0.025 0  0.025 0.025 0  0.025 0.025 0.2  -0.025 0.025 0.2
END
}
