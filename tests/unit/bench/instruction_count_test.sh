#!/usr/bin/env bash
# instruction_count_test.sh PLENUM-COUNT-STEPS: the pair loops must stay vectorised. Counts the
# instructions of K and of 2K steps of a small dam break with callgrind; the difference over the
# interactions of K steps is compared with a bound. Unlike a time, it is the same on every machine.
set -euo pipefail
program=$1
steps=20
command -v valgrind >/dev/null || { echo "valgrind is not installed"; exit 77; }
[ "$(uname -m)" = x86_64 ] || { echo "the bounds are those of x86-64"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# run STEPS: instructions, interactions a step and the name of the instruction set.
run() {
  valgrind --tool=callgrind --callgrind-out-file="$folder/out" "$program" "$1" \
    >"$folder/stdout" 2>"$folder/stderr" || { cat "$folder/stderr" >&2; return 1; }
  echo "$(sed -n 's/.*Collected *: *//p' "$folder/stderr")" \
    "$(sed 's/ interactions a step; .* particles; / /' "$folder/stdout")"
}

# check: with the instruction set that the program takes under valgrind.
check() {
  local first second once twice interactions name
  first=$(run $steps)
  second=$(run $((2 * steps)))
  read -r once _ <<<"$first"
  read -r twice interactions name <<<"$second"
  local bound=$avx2_bound
  [ "$name" != baseline ] || bound=$baseline_bound
  awk -v d=$((twice - once)) -v n=$((interactions * steps)) -v b="$bound" -v name="$name" 'BEGIN {
    printf "%s: %.1f instructions an interaction, at most %s\n", name, d / n, b
    exit !(d / n <= b) }' || { echo "the pair loops are no longer vectorised"; failed=1; }
}

# With packs 30 (AVX2) and 54 (SSE2) by g++ 12; one pair at a time 124 and 154.
avx2_bound=40
baseline_bound=80
failed=0
unset PLENUM_INSTRUCTION_SET  # valgrind hides AVX-512, so the best is AVX2 at most
check
PLENUM_INSTRUCTION_SET=baseline check
exit $failed
