#!/usr/bin/env bash
# map: sums on each face against those of the ledger's rows, by number and by place; the forms of maps; what hides what in
# the picture, from the table that gnuplot gets; what is refused.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"

# Two plates of 20 mm x 10 mm, of two triangles each, at z = 0 and 5 mm, in mm: triangles 0, 1 and 2, 3.
plate() { # Z
  printf 'facet normal 0 0 1\n outer loop\n  vertex 0 0 %s\n  vertex 20 0 %s\n  vertex 20 10 %s\n end loop\nend facet\n' $1 $1 $1
  printf 'facet normal 0 0 1\nouter loop\nvertex 0 0 %s\nvertex 20 10 %s\nvertex 0 10 %s\nendloop\ncolor 1 0 0\nendfacet\n' $1 $1 $1
}
{ echo solid two; plate 0; plate 5; echo endsolid two; } > two.stl

# A ledger in cm, g, s: three impacts on 0 and four on 3, of which one and two stick; grains of 100 um and 200 um. Of those
# that stick, the one on 0 is 4.9 mm below the upper plate.
{ echo "# asperity 1.0.0; fix w wall/rebound; units cgs; surface smooth rebound bons materials quartz steel deposit freeze erosion oka 15000000000 face mean seed 1; angles in degrees"
  echo tag,impact,time,mesh,triangle,x,y,z,d_p,v1,alpha1_deg,cor_n,cor_t,outcome,mass,eroded_mass
  for row in "1 0 1.5 0.2 0.005 0.01 1000 0" "2 0 1.4 0.2 0.005 0.01 3000 1" "3 0 1.5 0.3 0.005 0.01 2000 0" \
    "4 3 0.2 0.6 0.505 0.01 500 1" "5 3 0.2 0.7 0.51 0.02 500 1" "6 3 0.3 0.6 0.505 0.01 100 0" "7 3 0.2 0.6 0.505 0.01 100 0"; do
    set -- $row; echo "$1,1,0,1,$2,$3,$4,$5,$6,$7,45,0.5,0.5,$8,$6e-4,$1e-9"
  done; } > ledger
"$asperity" map ledger two.stl --scale 1e-3 -o sums
[ "$(column impacts sums | paste -sd' ')" = "3 0 0 4" ] || die "impacts: $(cat sums)"
[ "$(column area_m2 sums | sort -u)" = 0.0001 ] || die "areas: $(cat sums)"
[ "$(column x_m sums | paste -sd' ') $(column z_m sums | tail -n 1)" = "0.0133333 0.00666667 0.0133333 0.00666667 0.005" ] || die "places: $(cat sums)"
[ "$(column deposited_mass_kg sums | paste -sd' ')" = "1e-09 0 0 3e-09" ] || die "deposits: $(cat sums)"
[ "$(column eroded_mass_kg sums | paste -sd' ')" = "6e-12 0 0 2.2e-11" ] || die "wear: $(cat sums)"
[ "$(column impact_speed_m_s sums | paste -sd' ')" = "20   3" ] || die "speed: $(cat sums)"
awk -v d="$(column erosion_depth_m sums | head -n 1)" 'BEGIN { r = 6e-12 / 1e-4 / d; exit !(r > 7700 && r < 8000) }' || die "depth: $(cat sums)"

# A ledger without numbers of triangles, and one without masses, of spheres of quartz.
awk -F, -v OFS=, '/^[0-9]/ { $5 = 0 } { print }' ledger > foam
"$asperity" map foam two.stl --scale 1e-3 | cmp - <(sed 's/ledger two/foam two/; s/ -o sums//' sums) || die "by place"
cut -d, -f1-14 ledger > few
"$asperity" map few two.stl --scale 1e-3 --density 2000kg/m3 | column deposited_mass_kg /dev/stdin |
  awk 'NR == 1 { exit !(($1 / (2000 * 3.14159265 / 6 * 1e-12) - 1) ^ 2 < 1e-10) }' || die "mass by density"
"$asperity" map few two.stl --scale 1e-3 | column deposited_mass_kg /dev/stdin |
  awk 'NR == 1 { exit !($1 > 2600 * 0.5236e-12 && $1 < 2700 * 0.5236e-12) }' || die "mass by the heading's materials"

# The file for ParaView is a map, too; so are those of LAMMPS (.vtp) and OpenFOAM (quadrilaterals, names of its cloud), and
# VTK's form since version 5, as LIGGGHTS has it.
"$asperity" map ledger two.stl --scale 1e-3 -o two.vtk
"$asperity" map two.vtk | rows /dev/stdin | cmp - <(rows sums) || die "own map: $("$asperity" map two.vtk)"
points="0 0 0 20 0 0 20 10 0 0 10 0 0 0 5 20 0 5 20 10 5 0 10 5"
printf '# vtk DataFile Version 2.0\nsampleSurface\nASCII\nDATASET POLYDATA\nPOINTS 8 float\n%s\nPOLYGONS 2 10\n4 0 1 2 3\n4 4 5 6 7\nCELL_DATA 2\nFIELD attributes 2\ncloud:impacts 1 2 float\n3 4\ncloud:depositedMass 1 2 float\n1e-9 3e-9\n' \
  "$points" > foam.vtk
printf '# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nPOINTS 8 float\n%s\nPOLYGONS 3 8\nOFFSETS vtktypeint64\n0 4 8\nCONNECTIVITY vtktypeint64\n0 1 2 3\n4 5 6 7\nCELL_DATA 2\nSCALARS impacts double 1\nLOOKUP_TABLE default\n3 4\nFIELD f 1\ndeposited_mass 1 2 double\n1e-9 3e-9\n' \
  "$points" > liggghts.vtk
printf '<?xml version="1.0"?>\n<VTKFile type="PolyData">\n<PolyData>\n<Piece>\n<Points>\n<DataArray type="Float64" NumberOfComponents="3" format="ascii">\n%s\n</DataArray>\n</Points>\n<Polys>\n<DataArray type="Int32" Name="connectivity" format="ascii">\n0 1 2 3 4 5 6 7\n</DataArray>\n<DataArray type="Int32" Name="offsets" format="ascii">\n4\n8\n</DataArray>\n</Polys>\n<CellData>\n<DataArray type="Float64" Name="impacts" format="ascii">\n3 4\n</DataArray>\n<DataArray type="Float64" Name="deposited_mass" format="ascii">\n1e-9 3e-9\n</DataArray>\n</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n' \
  "$points" > lammps.vtp
for map in foam.vtk liggghts.vtk lammps.vtp; do
  "$asperity" map $map --scale 1e-3 > of_map
  [ "$(rows of_map | cut -d, -f4-7 | paste -sd' ')" = "0,0.0002,3,1e-09 0.005,0.0002,4,3e-09" ] || die "$map: $(cat of_map)"
done
"$asperity" map foam foam.vtk --scale 1e-3 | column impact_speed_m_s /dev/stdin | paste -sd' ' | grep -q '^20 3$' || die "a ledger on a map"

# What gnuplot gets. From above the upper plate hides the lower one and its deposit; from below, or cut open, it does not.
mkdir bin; printf '#!/bin/sh\n[ "$1" = --version ] || cat /dev/stdin > table\n' > bin/gnuplot; chmod +x bin/gnuplot
picture() { # DEPOSITS LEAST MOST OPTION...: so many are in sight, and the largest value in the middle, per cm^2, is from LEAST to MOST
  local seen=$1 least=$2 most=$3; shift 3
  PATH=$PWD/bin:$PATH "$asperity" map ledger two.stl --scale 1e-3 "$@" --plot map.png 2> err || die "map $*: $(cat err)"
  awk -F, -v seen=$seen -v least=$least -v most=$most 'NF == 4 && $3 ~ /cm/ { w = $1; h = $2 } NF == 3 && $3 == "deposits" { s = $1; all = $2 }
    NF == 5 && $1 > 0.1 * w && $1 < 0.9 * w && $2 > 0.1 * h && $2 < 0.9 * h && $3 > v { v = $3 }
    END { exit !(s == seen && all == 3 && v >= least && v <= most) }' table || die "picture: $*: $(grep -a "mm\|deposits" table)"
}
picture 2 3.99 4.01 --view 0,90
picture 1 2.99 3.01 --view 0,-90
picture 1 2.99 3.01 --view 0,90 --clip z::1mm
picture 0 3.99 4.01 --view 0,90 --clip y:8mm:
picture 2 3.99 4.01 --view 30,80 --most 7
grep -q "^[0-9]*,[0-9]*,impacts / cm^2,7$" table || die "label: $(head -n 1 table)"
PATH=$PWD/bin:$PATH "$asperity" map ledger two.stl --scale 1e-3 --of wear --plot map.png 2> err
grep -q 'depth of wear in pm' table || die "label of wear: $(head -n 1 table)"

# What is refused, or doubted.
refuses 2 "impacts on mesh 1 and mesh 2" "--mesh" -- map <(sed 's/^7,1,0,1/7,1,0,2/' ledger) two.stl
refuses 2 "--mesh is 5" "no impact" -- map ledger two.stl --mesh 5
refuses 2 "triangle 7" "0 to 3" -- map <(sed 's/^7,1,0,1,3/7,1,0,1,7/' ledger) two.stl --scale 1e-3
refuses 2 "no map of impacts" -- map two.stl
refuses 2 "LEDGER and MESH" -- map
refuses 2 "'x' is missing" -- map <(cut -d, -f1-5,9-14 ledger) two.stl
draws
refuses 2 "1 numbers of 'impacts' for 2 faces" -- map <(sed 's/^3 4/3 text/' foam.vtk)
refuses 2 "it is binary" -- map <(sed 's/^ASCII/BINARY/' foam.vtk)
refuses 2 "a face has the point 9 of 8" -- map <(sed 's/^4 4 5 6 7/4 4 5 6 9/' foam.vtk)
refuses_rows 'map, with pictures'
"$asperity" map ledger two.stl --scale 1e-6 2> err > out; grep -q "7 of 7 impacts are outside of two.stl.*--scale" err || die "no doubt about the scale"
