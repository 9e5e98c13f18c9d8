#!/usr/bin/env bash
# loop_symbols_test.sh BUILD: loops compiled for AVX2 or AVX-512 must not lend their code to the rest
# of the program. The linker keeps one copy of a function that several sources define; were it one
# made for a newer processor, every other would stop with an illegal instruction. So each function
# that such a source shares must bear the name of its instruction set.
set -euo pipefail
build=$1
failed=0
count=0
for set in Avx2 Avx512; do
  while IFS= read -r object; do
    count=$((count + 1))
    shared=$(nm -C "$object" | grep -E ' [WVu] ' | grep -v "isa::$set" || true)
    if [ -n "$shared" ]; then
      echo "$object shares code without naming $set:"
      echo "$shared"
      failed=1
    fi
  done < <(find "$build/engine" "$build/solver" -path "*_${set}_*" -name '*.o')
done
[ $count -gt 0 ] || { echo "no loops for AVX2 or AVX-512: not an x86 build"; exit 77; }
echo "$count objects"
exit $failed
