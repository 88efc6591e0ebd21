#!/bin/sh
# Draws the pictures of the README into docs/images: the demo's scan, and shapes with sharp edges.
#   scripts/pictures.sh [BUILD_DIRECTORY]
set -eu
build=${1:-build}
arris=$build/arris
work=$build/pictures
images=docs/images
mkdir -p "$work" "$images"

scripts/demo.sh "$build" >/dev/null
cp "$build/demo/angel.png" "$images/scan.png"

# Above, points sampled on corners, edges and faces; below, the meshes of these points alone.
shapes="perforated_cube l_bracket dodecahedron tangled_cubes"
points="" meshes=""
for shape in $shapes; do
  "$arris" model --quiet "$shape" -o "$work/$shape.truth.ply"
  "$arris" sample --quiet "$work/$shape.truth.ply" -n 3000 --mode feature -o "$work/$shape.ply"
  "$arris" reconstruct --quiet "$work/$shape.ply" -o "$work/$shape.off"
  points="$points $work/$shape.ply"
  meshes="$meshes $work/$shape.off"
done
# shellcheck disable=SC2086  # the lists are split on purpose
"$arris" render --quiet --columns 4 --size 220x200 --azimuth 40 --point-size 2.5 $points $meshes \
  -o "$images/edges.png"

ls -l "$images"
