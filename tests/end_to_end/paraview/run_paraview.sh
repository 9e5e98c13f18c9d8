#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# run_paraview.sh FOLDER [OUT]: opens a run's particle file, its first .vtu and its .pvd in ParaView
# and renders one picture of each into OUT (default: FOLDER/paraview). Installs ParaView and a
# virtual X server from Debian if they are missing (root or sudo). Fails if a file cannot be opened
# or a picture is missing or blank.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
folder=${1:?usage: run_paraview.sh FOLDER [OUT]}
out=${2:-$folder/paraview}

first() {  # first KIND: the first file of that kind in the folder
  for file in "$folder"/*."$1"; do
    if [ -f "$file" ]; then
      printf '%s\n' "$file"
      return
    fi
  done
  echo "run_paraview.sh: $folder: there is no .$1 file; run a case into it first" >&2
  exit 1
}

missing=""
for package in paraview python3-paraview xvfb xauth; do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q "ok installed" ||
    missing="$missing $package"
done
if [ -n "$missing" ]; then
  echo "run_paraview.sh: installing$missing"
  root=""
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      { echo "run_paraview.sh: install$missing as root first" >&2; exit 1; }
    root=sudo
  fi
  $root apt-get update -qq
  # shellcheck disable=SC2086  # one word a package
  $root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing
fi

hdf=$(first hdf)
vtu=$(first vtu)
pvd=$(first pvd)
mkdir -p "$out"
# Without an X server ParaView reads but cannot render.
render() {
  LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 1024x768x24" \
    pvbatch "$here/render.py" "$out" "$hdf" "$vtu" "$pvd"
}
# Seen once in eight runs: pvbatch aborts right at its start (signal 6, before any file is opened)
# when the new X server is not ready for it. Only that is tried again.
render || { code=$?; [ $code = 134 ] && { echo "pvbatch aborted at its start; once more"; render; }; }
for kind in hdf vtu pvd; do
  ls "$out"/*_"$kind".png >/dev/null 2>&1 ||
    { echo "run_paraview.sh: the picture of the .$kind file is missing" >&2; exit 1; }
done
