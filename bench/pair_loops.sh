#!/usr/bin/env bash
# pair_loops.sh BUILD: how many loops over pairs were compiled for each instruction set, and how long
# that took: the budget of solver/pass_choice.hpp. Counts the instances of sumChosen in the objects of
# solver/pair_loops.cpp and ictools/sum_loops.cpp; tuned loops know their kernel, generic ones choose it at run time
# (kernel::Any). Times are ninja's, of the last time that each object was made.
set -euo pipefail
build=$1
declare -A tuned generic seconds
cached=0

# time OBJECT: seconds with one digit, by ninja's log; the last entry counts.
time_of() {
  [ -f "$build/.ninja_log" ] || { echo -1; return; }
  awk -v object="$1" -F '\t' '$4 == object { t = ($2 - $1) / 1000; found = 1 }
    END { if (found) printf "%.1f", t; else print -1 }' "$build/.ninja_log"
}

for set in Baseline Avx2 Avx512; do
  tuned[$set]=0 generic[$set]=0 seconds[$set]=0
  while IFS= read -r object; do
    symbols=$(nm -C "$object" | grep -E ' [tTwW] ' | grep -F '::sumChosen<' || true)
    all=$(grep -c . <<<"$symbols" || true)
    any=$(grep -cF 'kernel::Any' <<<"$symbols" || true)
    generic[$set]=$((generic[$set] + any))
    tuned[$set]=$((tuned[$set] + all - any))
    t=$(time_of "${object#"$build"/}")
    seconds[$set]=$(awk -v a="${seconds[$set]}" -v b="$t" 'BEGIN { print b < 0 ? a : a + b }')
    # No compiler makes these in so short a time.
    awk -v t="$t" 'BEGIN { exit !(t >= 0 && t < 3) }' && cached=$((cached + 1))
  done < <(find "$build/solver" "$build/ictools" -path "*_loops_cpp_${set}_*" -name '*.o' | sort)
  all=$((tuned[$set] + generic[$set]))
  [ $all -gt 0 ] || continue
  echo "pair loops, ${set,,}: $all in float and double, ${tuned[$set]} tuned," \
    "${generic[$set]} generic; compiled in ${seconds[$set]} s"
done
[ $cached = 0 ] || echo "pair loops: $cached objects came from ccache, so the times are no compiler's"
