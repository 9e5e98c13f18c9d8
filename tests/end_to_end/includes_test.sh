#!/usr/bin/env bash
# Dependencies between folders run one way, and CGAL and gmsh stay in geometry's sources.
set -euo pipefail
cd "$1"
status=0

# expect FOLDER ALLOWED...: the quoted includes of FOLDER name only these folders.
expect() {
  local folder=$1 allowed
  allowed=$(IFS='|'; echo "${*}")
  local bad
  bad=$(grep -rnE '#include "' "$folder" --include='*.hpp' --include='*.cpp' |
    grep -vE "#include \"(${allowed// /|})/" || true)
  if [ -n "$bad" ]; then
    echo "includes that $folder/ must not have:"
    echo "$bad"
    status=1
  fi
}
expect particles
expect engine particles
expect geometry particles
expect ictools geometry engine particles
expect solver engine particles
expect studies solver ictools geometry engine particles
expect bench solver ictools geometry engine particles

leak=$(grep -rnE '#include [<"](CGAL|gmsh)' particles engine ictools solver studies bench --include='*.?pp' ||
  true)
leak+=$(grep -nE '#include [<"](CGAL|gmsh)' geometry/*.hpp || true)
if [ -n "$leak" ]; then
  echo "CGAL or gmsh outside geometry/*.cpp:"
  echo "$leak"
  status=1
fi
[ $status = 0 ] && echo "all includes run one way"
exit $status
