# The part of bad_input.sh that is of LIGGGHTS only: meshes, constants, templates. Sourced by it.
# SPDX-License-Identifier: GPL-3.0-or-later
refuses "all wall/rebound" "" "mesh n_meshes N" "primitive type T"
refuses "all wall/rebound box" "" "'box'" "'mesh' or 'primitive'"
refuses "all wall/rebound primitive type 2" "" "type T style args"
refuses "all wall/rebound primitive type 2 wplane 0.0" "" "'wplane'" "zplane"
refuses "all wall/rebound mesh n_meshes 2 meshes plate" "" "n_meshes is '2'"
refuses "all wall/rebound mesh n_meshes 1 meshes moon" "" "'moon' does not exist" "mesh/surface"
refuses "all wall/rebound primitive type 2 zplane 0.0 surface smooth map 10 map.vtk" "" "'map'" "dump mesh/vtk"
refuses "all wall/rebound model hertz primitive type 2 zplane 0.0" "" "takes no model" "wall/gran"
refuses "all wall/rebound primitive type 2 zplane 0.0 model hertz tangential history" "" "takes no model"
for name in youngsModulus:m1 poissonsRatio:m2 yieldStress:m3 surfaceEnergy:m4; do
  # the pair style has its own word on the two that it needs too
  refuses "$plane" "unfix ${name#*:}" "${name%:*}"
done
refuses "$plane" "unfix m3" "yieldStress" "materials quartz hastelloy-x" "fix yieldStress all property/global yieldStress peratomtype 2e8 2e8"
refuses "$plane" "unfix m4" "surfaceEnergy" "property/global surfaceEnergy peratomtypepair 2 0.8 0.8 0.8 0.8"
refuses "$plane" "unfix m3
fix m3 all property/global yieldStress peratomtype -5 2e8" "yield_stress of 'type 1' is -5" ">= 0"
refuses "$plane" "unfix m1
fix m1 all property/global youngsModulus peratomtype -7e10 2e11" "youngsModulus"
refuses "$plane" "unfix m2
fix m2 all property/global poissonsRatio peratomtype 0.17 0.7" "poissonsRatio"
refuses "all wall/rebound mesh n_meshes 2 meshes plate plate" "" "'plate' is named twice"
refuses "$mesh" "fix other all wall/rebound mesh n_meshes 1 meshes plate" "'plate' is already used by fix 'other'" "one wall for each mesh"
refuses "$mesh" "fix other all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate" "'plate' is already used by fix 'other'"
refuses "all wall/rebound mesh n_meshes 1 meshes worn" "fix worn all mesh/surface/stress file plate.stl type 2 wear finnie" "mesh 'worn' has 'wear finnie'" "erosion finnie FLOW_STRESS"
refuses "$plane" "fix wall $plane" "a wall with this ID exists" "'unfix'"
# orders that come after the wall: behind a line break, where the deck goes on
refuses "$mesh
unfix plate" "" "plate" "unfix"
refuses "$plane
unfix rebound_wall" "" "rebound_wall" "property/atom"
refuses "$plane materials quartz hastelloy-x" "fix grain all particletemplate/sphere 10007 atom_type 2 volume_limit 1e-20 density constant 2650 radius constant 5e-6" "'hastelloy-x'" "type 2" "no yield stress"
units=real refuses "$plane materials quartz hastelloy-x" "" "'units real'" "si, cgs or micro"
units=real refuses "$plane rebound table nowhere.csv" "" "'units real'" "si, cgs or micro"
