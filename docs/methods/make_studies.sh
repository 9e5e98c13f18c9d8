#!/usr/bin/env bash
# make_studies.sh STUDY CASES KEPT FOLDER: the studies of accuracy behind docs/methods, as tables and
# charts in FOLDER; runs stay in KEPT. `./run --figures methods` calls it.
set -euo pipefail
study=$1 cases=$2 kept=$3 folder=$4
collisions='collisions=case,{restitution=0.01,range=0.85}'

# What collisions cost and buy. The case itself is the reference, for want of an exact value; the
# table has all of what the case measures.
"$study" accuracy "$cases/gas_box.toml" --against-case --quantity psi6 -o "$kept/gas_box" -q \
  --vary kernel=cubic_spline,wendland_c2_1d,convex --vary "$collisions" --repeats 2
"$study" accuracy "$cases/rotating_shaft.toml" --against-case --quantity f.5 -o "$kept/shaft" -q \
  --vary kernel=wendland_quadratic,wendland_c2_1d,convex --vary "$collisions" --repeats 5

# What finer spacing buys.
"$study" accuracy "$cases/sod.toml" -o "$kept/sod" -q --within 0.02 --repeats 2 \
  --vary kernel=cubic_spline,wendland_c2,wendland_c4 --vary h=1.2,1.5,2 \
  --vary spacing=0.04,0.02,0.01,0.005
"$study" accuracy "$cases/taylor_green.toml" -o "$kept/taylor_green" -q --within 0.02 \
  --vary spacing=0.04,0.02,0.01 --vary h=1.5,2,2.5

# What an even start buys: lattices, random places, and those relaxed; with shifting and all but
# without.
"$study" accuracy "$cases/taylor_green.toml" -o "$kept/starts" -q --within 0.02 \
  --vary 'fluid[0].lattice:relax=square:case,hexagonal:case,random:case,random:{}' \
  --vary 'shifting=case,{coefficient=1e-9}' --vary spacing=0.04,0.02,0.01

for name in gas_box shaft sod taylor_green starts; do
  cp "$kept/$name/results.csv" "$folder/methods_$name.csv"
done
for name in sod taylor_green starts; do cp "$kept/$name/error_cost.png" "$folder/methods_$name.png"; done
