#!/bin/sh
# Builds the fuzz targets with clang and runs each for SECONDS; fails on the first crash, whose input
# is left in BUILD. Every target starts from the seeds in seeds/READER.
#   tests/fuzz/run.sh [SECONDS [BUILD]]
set -eu
seconds=${1:-20}
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${2:-$root/build-fuzz}

cmake -S "$root" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER="${CXX:-clang++}" -DARRIS_BUILD_FUZZ=ON \
  ${ARRIS_FUZZ_CMAKE:-} >/dev/null
cmake --build "$build" --target fuzz
for reader in ply_points ply_mesh text off obj stl; do
  echo "== $reader, $seconds s"
  mkdir -p "$build/corpus/$reader"
  "$build/fuzz_$reader" -max_total_time="$seconds" -max_len=4096 -timeout=10 -rss_limit_mb=2048 \
    -dict="$root/tests/fuzz/words.dict" -artifact_prefix="$build/crash-$reader-" \
    -print_final_stats=1 -verbosity=0 "$build/corpus/$reader" "$root/tests/fuzz/seeds/$reader"
done
