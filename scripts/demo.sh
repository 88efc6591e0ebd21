#!/bin/sh
# make demo: a real scan to a certified mesh, its report and its picture.
#   scripts/demo.sh [BUILD_DIRECTORY]
set -eu
build=${1:-build}
arris=$build/arris
out=$build/demo
scan=examples/data/angel.ply
mkdir -p "$out"

"$arris" info "$scan"
"$arris" reconstruct "$scan" -o "$out/angel.ply" --report "$out/angel.json"
"$arris" check --quiet "$out/angel.ply"
if "$arris" help render >/dev/null 2>&1; then
  "$arris" render "$out/angel.ply" -o "$out/angel.png"
fi

echo
echo "The demo's files:"
for kind in "mesh ply" "report json" "picture png"; do
  file=$out/angel.${kind#* }
  [ -f "$file" ] && printf '  %-8s %s\n' "${kind% *}" "$file"
done
