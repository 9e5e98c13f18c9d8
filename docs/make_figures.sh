#!/usr/bin/env bash
# make_figures.sh BUILD FOLDER [NAME ...]: makes the pictures, charts and tables of the docs, all of
# them or those named. `./run --figures` calls it.
set -euo pipefail
build=$(cd "$1" && pwd)
mkdir -p "$2"
folder=$(cd "$2" && pwd)
shift 2
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
ic=$build/ictools/plenum-ic
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

known=(lattices walls relaxation blob report_card relaxed_sets densities at_rest dam vessel gas blob_wind blob_mass pairing methods)
chosen=("${@:-${known[@]}}")

# The disk in which the first pictures are taken.
cat > "$work/disk.toml" <<TOML
title     = "Disk"
dimension = 2
spacing   = 0.05
[geometry]
disk = { disk = { center = [0, 0], radius = 0.5 } }
[[fluid]]
region = "disk"
mass   = "exact"
[[wall]]
outside = "disk"
[solver]
smoothing_length = 1.5
TOML

disk() {  # disk NAME TITLE [KEY=VALUE ...]
  local name=$1 title=$2 sets=()
  shift 2
  for value in "$@"; do sets+=(--set "$value"); done
  "$ic" preview "$work/disk.toml" -q -o "$folder/$name.png" --width 600 --color type \
    --set "title=\"$title\"" ${sets[@]+"${sets[@]}"}
}

measured() {  # the tests print tables, and write them and charts there
  (cd "$root" && PLENUM_FIGURES=$folder OMP_NUM_THREADS=${OMP_NUM_THREADS:-1} \
    /usr/bin/python3 "tests/end_to_end/$1_test.py" "$ic" "$build/solver/plenum-sph" cases)
}

# dam NAME CASE TITLE [KEY=VALUE ...]: a picture of the last state of a dam break, also of one that
# blew up.
dam() {
  local name=$1 case=$2 title=$3 sets=() run=$work/$1
  shift 3
  for value in "$@"; do sets+=(--set "$value"); done
  "$ic" generate "$root/cases/$case.toml" -q --no-report -o "$work/$name.hdf" \
    --set "title=\"$title\"" ${sets[@]+"${sets[@]}"}
  "$build/solver/plenum-sph" run "$work/$name.hdf" -q -o "$run" || true
  if [ -f "$run/last.png" ]; then cp "$run/last.png" "$folder/$name.png"
  else cp "$run/failed.png" "$folder/$name.png"; fi
}

for name in "${chosen[@]}"; do
  case $name in
    lattices)
      for lattice in hexagonal square random; do
        disk "lattice_$lattice" "lattice = $lattice" "fluid[0].lattice=$lattice"
      done ;;
    walls)
      disk walls_lattice "method = lattice"
      disk walls_conformal "method = conformal" "wall[0].method=conformal" ;;
    relaxation)
      disk relaxed_lattice "hexagonal, conformal walls, relaxed" "wall[0].method=conformal" \
        "relax.method=packing"
      disk relaxed_random "random, conformal walls, relaxed" "wall[0].method=conformal" \
        "fluid[0].lattice=random" "relax.method=packing" ;;
    blob)
      "$ic" preview "$root/cases/initial_conditions/blob.toml" -q --width 900 --color material \
        --slice y=0.5 -o "$folder/blob.png" ;;
    report_card)
      "$ic" generate "$root/cases/initial_conditions/relaxed_ball.toml" -q -o "$work/ball.hdf"
      cp "$work/ball.report.png" "$folder/report_card.png" ;;
    dam)  # figures 8 and 9 of Kruisbrink et al. 2018
      sums=(solver.density=summation 'solver.collisions.pairs="wall"' solver.wall_pressure=zero
        solver.collisions.range=0.85 solver.time_step=5e-5 solver.end_time=0.1)
      dam dam_early_wendland dam_break_multiphase "Sums, kernel (1.1)" "${sums[@]}"
      dam dam_early_convex dam_break_multiphase "Sums, convex kernel" "${sums[@]}" \
        solver.kernel=convex
      dam dam_early_collisions dam_break_multiphase "Continuity, kernel (1.1), collisions" \
        solver.end_time=0.1
      dam dam_late_single dam_break_single "Water alone, kernel (1.1)"
      dam dam_late_wendland dam_break_multiphase "Continuity, kernel (1.1), no collisions" \
        'solver.collisions.pairs="wall"' solver.wall_pressure=zero solver.collisions.range=0.85
      dam dam_late_collisions dam_break_multiphase "Continuity, kernel (1.1), collisions" ;;
    vessel)  # ten minutes
      "$ic" generate "$root/cases/cad_vessel.toml" -q --no-report -o "$work/vessel.hdf"
      "$build/solver/plenum-sph" run "$work/vessel.hdf" -q -o "$work/vessel"
      cp "$work/vessel/last.png" "$folder/cad_vessel.png" ;;
    blob_wind)  # the blob in the wind at tau_KH/2 and tau_KH, cut through and looked through; six minutes
      "$ic" generate "$root/cases/blob_wind_tunnel.toml" -q --no-report -o "$work/wind.hdf"
      for part in "half 1.185" "whole 2.37"; do
        read -r when until <<< "$part"
        "$build/solver/plenum-sph" run "$work/wind.hdf" -q --anew -o "$work/wind" \
          --set solver.end_time="$until"
        for look in "slice --slice y=0 --smooth --range 0 6" "column --column y --range 8 26"; do
          read -r name options <<< "$look"
          # shellcheck disable=SC2086 # options are several words
          "$ic" preview "$work/wind/wind_end.hdf" -q --width 900 --color density $options \
            -o "$folder/blob_wind_${name}_$when.png"
        done
      done ;;
    methods)  # of docs/methods; half an hour, and what is in ./run --study already is not run again
      study=$build/studies/plenum-study
      kept=$root/out/study
      "$root/studies/overview.sh" "$build" "$root/cases" "$kept" > "$work/overview.txt"
      map() { "$study" stability "$@" -o "$kept/stability" | grep -vE '^(written to|table and page)'; }
      map transforms > "$folder/methods_transforms.txt"
      map modes > "$folder/methods_modes.txt"
      for lattice in hexagonal square fcc; do
        map growth --lattice $lattice
      done > "$folder/methods_growth.txt"
      map pairing > "$folder/methods_pairing.txt"
      map pairing --start noise > "$folder/methods_pairing_noise.txt"
      map pairing --neighbours 12,16,20,28,40,60,80,100 --seeds 3 \
        > "$folder/methods_pairing_neighbours.txt"
      map pairing --dimension 3 --smoothing-length 1,1.2,1.5,2,2.5 --quick \
        > "$folder/methods_pairing_3d.txt"
      map modes --kernels wendland_c2 --smoothing-length 1.2,1.5,2,2.5,3 \
        --background-pressure=1,0.1,0.01,0,-0.01,-0.03,-0.1,-0.3,-1 \
        > "$folder/methods_modes_tension.txt"
      for scanned in tension collisions interface time-step; do
        map $scanned
      done > "$folder/methods_maps.txt"
      "$study" stability transforms -o "$work/few" > "$work/few.txt" \
        --kernels cubic_spline,quintic_spline,wendland_c2,wendland_c2_1d,convex
      cp "$work/few/transforms_2d.png" "$folder/methods_transforms_2d.png"
      for drawn in modes_hexagonal modes_hexagonal_pressures pairing_2d pairing_2d_noise \
        pairing_2d_neighbours pairing_3d tension collisions interface time_step; do
        cp "$kept/stability/$drawn.png" "$folder/methods_$drawn.png"
      done
      cp "$kept/tank/error_cost.png" "$folder/methods_tank.png"
      cp "$kept/tank/closed_form.png" "$folder/methods_closed_form.png"
      "$root/docs/methods/make_studies.sh" "$study" "$root/cases" "$kept" "$folder" ;;
    blob_mass) measured blob ;;
    relaxed_sets | densities | at_rest | gas | pairing) measured "$name" ;;
    *) echo "make_figures.sh: $name: no such figure; known: ${known[*]}" >&2; exit 1 ;;
  esac
  echo "figures: $name"
done
