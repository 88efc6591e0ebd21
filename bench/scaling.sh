#!/usr/bin/env bash
# Time and memory of the default pipeline over sizes, each in a process of its own.
#   bench/scaling.sh BUILD_DIRECTORY [SIZE ...]
set -euo pipefail
build=${1:?give the build directory}
shift
[ $# -gt 0 ] || set -- 10000 30000 100000 300000 1000000
for size in "$@"; do "$build/scaling_bench" "$size"; done
