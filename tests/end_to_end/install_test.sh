#!/usr/bin/env bash
# `cmake --install` gives programs that work away from the build folder.
set -euo pipefail
build=$1 cases=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$build" --prefix "$folder/installed" >/dev/null
cd "$folder"
installed/bin/plenum-ic generate "$cases/gas_box.toml" -o box.hdf >/dev/null
installed/bin/plenum-sph run box.hdf -o box --quiet --set solver.end_time=0.01
[ -s box/box.pvd ] && [ -s box/history.csv ] && [ -s box/summary.json ] && [ -s box/last.png ]
echo "installed programs work"
