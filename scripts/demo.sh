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
# Seen along the scanner's view, which looked down its z axis; a scan has no clean edges to draw.
view="--up z --azimuth 3 --elevation -84 --edge-angle 180 --common-frame --size 480x360"
picture() {
  # shellcheck disable=SC2086  # the options are split on purpose
  "$arris" render --quiet "$scan" "$out/angel.ply" -o "$out/angel.png" $view --point-size 1.6 \
    --caption "$1 points, positions only" --caption "a closed mesh of $2 triangles"
}
# The number after "element NAME" in the header of a PLY file.
elements() { sed -n "s/^element $1 //p;/^end_header/q" "$2"; }
rm -f "$out/angel.png"
picture "$(elements vertex "$scan")" "$(elements face "$out/angel.ply")" ||
  echo "The picture is left out: see above." >&2

echo
echo "The demo's files:"
for kind in "mesh ply" "report json" "picture png"; do
  file=$out/angel.${kind#* }
  if [ -f "$file" ]; then printf '  %-8s %s\n' "${kind% *}" "$file"; fi
done
