# Shared by the tests of OpenFOAM's wall: each sources it. A case is a cube of 1 m with the walls floor, roof and sides, in
# which a cloud of parcels of 10 um flies without a gas that acts on it.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "${BASH_SOURCE[0]}")/../engine/engine.sh"
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}

object() { printf 'FoamFile { version 2.0; format ascii; class %s; object %s; }\n' "$1" "$2"; cat; }

# box DIR COEFFS [NAME=VALUE]...: the entries of asperityWallCoeffs, and what differs from these:
box() {
  local dir=$1 coeffs=$2 model=asperityWall parcels=50 speed='1 0.3 -0.7' number=1 end=1 dt=0.05 write=10 cells='4 4 4' \
    sides='{ type wall; faces ((0 4 7 3) (2 6 5 1) (1 5 4 0) (3 7 6 2)); }'
  shift 2
  [ $# = 0 ] || local "$@"
  mkdir -p "$dir"/{0,constant,system}
  object dictionary blockMeshDict << END > "$dir/system/blockMeshDict"
vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));
blocks (hex (0 1 2 3 4 5 6 7) ($cells) simpleGrading (1 1 1));
boundary (floor { type wall; faces ((0 3 2 1)); } roof { type wall; faces ((4 5 6 7)); } sides $sides);
END
  object dictionary controlDict << END > "$dir/system/controlDict"
libs ("$bin/libasperityWall.so");
startFrom latestTime; startTime 0; stopAt endTime; endTime $end; deltaT $dt;
writeControl timeStep; writeInterval $write; writePrecision 17; timePrecision 8;
END
  object dictionary fvSchemes << 'END' > "$dir/system/fvSchemes"
ddtSchemes { default Euler; } gradSchemes { default Gauss linear; } divSchemes { default none; }
laplacianSchemes { default none; } interpolationSchemes { default linear; } snGradSchemes { default corrected; }
END
  object dictionary fvSolution < /dev/null > "$dir/system/fvSolution"
  object dictionary transportProperties <<< 'transportModel Newtonian; nu 1e-5; rhoInf 1;' > "$dir/constant/transportProperties"
  object dictionary turbulenceProperties <<< 'simulationType laminar;' > "$dir/constant/turbulenceProperties"
  object uniformDimensionedVectorField g <<< 'dimensions [0 1 -2 0 0 0 0]; value (0 0 0);' > "$dir/constant/g"
  object volVectorField U <<< 'dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
boundaryField { ".*" { type noSlip; } }' > "$dir/0/U"
  object vectorField parcels < <(awk -v n="$parcels" 'BEGIN { srand(1); print "("
    while (n-- > 0) printf "(%.6f %.6f %.6f)\n", rand(), rand(), rand(); print ")" }') > "$dir/constant/parcels"
  object dictionary kinematicCloudProperties << END > "$dir/constant/kinematicCloudProperties"
solution { active true; coupled false; transient yes; cellValueSourceCorrection off; maxCo 0.3; sourceTerms { schemes {} }
  interpolationSchemes { rho cell; U cellPoint; mu cell; } integrationSchemes { U Euler; } }
constantProperties { rho0 2650; youngsModulus 1e9; poissonsRatio 0.3; }
subModels { particleForces {} dispersionModel none; surfaceFilmModel none; stochasticCollisionModel none; collisionModel none;
  injectionModels { model1 { type manualInjection; massTotal 0; parcelBasisType fixed; nParticle $number; SOI 0;
    positionsFile "parcels"; U0 ($speed);
    sizeDistribution { type fixedValue; fixedValueDistribution { value 1e-5; } } } }
  patchInteractionModel $model; ${model}Coeffs { $coeffs } }
cloudFunctions {}
END
}

# foam DIR PROGRAM [RANKS]: runs it there; the screen goes to DIR/log.PROGRAM.
foam() {
  local launch=() parallel=()
  [ "${3:-1}" = 1 ] || { launch=(mpirun -np "$3") parallel=(-parallel); }
  (cd "$1" && timeout 300 "${launch[@]}" "$2" "${parallel[@]}" > "log.$2" 2>&1) || { tail -n 25 "$1/log.$2" >&2; die "$2 in $1"; }
}
run() { foam "$1" icoUncoupledKinematicParcelFoam "${2:-1}"; }
mesh() { foam "$1" blockMesh; }

# ledger DIR ENTRY: the name of a ledger. numbers DIR WORD PATCH: number and mass, the last ones of the log.
ledger() { echo "$1/postProcessing/lagrangian/kinematicCloud/asperityWall/$2.csv"; }
numbers() {
  awk -v word="$2" -v patch="$3" '/Parcel fate/ { here = $4 == patch } here && $2 == word { sub(/.*= /, ""); sub(",", ""); last = $0 }
    END { print last }' "$1/log.icoUncoupledKinematicParcelFoam"
}
# sum_of FIELD: the sum over all faces of a field of numbers.
sum_of() {
  awk '/boundaryField/ { on = 1 } /^\)$/ { list = 0 } list { s += $1 } on && /^\($/ { list = 1 } END { printf "%.12g\n", s }' "$1"
}
