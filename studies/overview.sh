#!/usr/bin/env bash
# overview.sh BUILD CASES FOLDER: the study that `./run --study` makes: what accuracy costs in a tank
# of water at rest, and which kernels pair. What is there already is not run again.
set -euo pipefail
study=$1/studies/plenum-study
cases=$2
folder=$3
mkdir -p "$folder"

# A column of .24 m is as wide as the largest support of the coarser particles asks.
"$study" accuracy "$cases/hydrostatic_tank.toml" -o "$folder/tank" \
  --vary kernel=cubic_spline,quintic_spline,wendland_c2,wendland_c4,wendland_c2_1d,convex \
  --vary h=1.5,2,2.5 --vary spacing=0.02,0.01 --vary precision=mixed,double \
  --set 'domain.upper=[0.24,1]' --set 'geometry.column.box.upper=[0.24,1]' \
  --within 1 --within 0.6 --compare kernel=convex,h=2 kernel=wendland_c2_1d,h=1.5
"$study" stability transforms -o "$folder/stability"
"$study" stability modes -o "$folder/stability"
"$study" stability pairing -o "$folder/stability" --seeds 2
