#!/bin/sh
# Draws the pictures of the README and of docs/benchmark.md into docs/images: the demo's scan, solids
# with sharp edges, and the paper's figure 6.
#   scripts/pictures.sh [BUILD_DIRECTORY]
set -eu
build=${1:-build}
arris=$build/arris
work=$build/pictures
images=docs/images
mkdir -p "$work" "$images"

scripts/demo.sh "$build" >/dev/null
cp "$build/demo/angel.png" "$images/scan.png"

# samples MODEL N MODE: points in $work/MODEL.ply; feature: on corners and edges, too, blue: not.
samples() {
  "$arris" model "$1" --quiet --unit -o "$work/$1.off"
  "$arris" sample "$work/$1.off" --quiet -n "$2" --mode "$3" -o "$work/$1.ply"
}
# The number after "element NAME" in the header of a PLY file.
elements() { sed -n "s/^element $1 //p;/^end_header/q" "$2"; }

# Above, points none of which is on an edge; below, the meshes of these points alone.
set --
meshes=""
for model in perforated_cube l_bracket dodecahedron tangled_cubes; do
  samples $model 3000 blue
  "$arris" reconstruct --quiet "$work/$model.ply" -o "$work/${model}_mesh.ply"
  set -- "$@" --caption "$(elements vertex "$work/$model.ply") points" "$work/$model.ply"
  meshes="$meshes $work/${model}_mesh.ply"
done
for mesh in $meshes; do
  set -- "$@" --caption "$(elements face "$mesh") triangles" "$mesh"
done
"$arris" render --quiet --columns 4 --size 220x200 --azimuth 40 --point-size 2.5 "$@" \
  -o "$images/edges.png"

# Figure 6: what lambda weighs, where swaps may take samples off the surface; and where they may not.
samples two_cubes 2472 feature
set --
while IFS='|' read -r name caption options; do
  # shellcheck disable=SC2086  # the options are split on purpose
  "$arris" reconstruct --quiet "$work/two_cubes.ply" -o "$work/$name.ply" --method paper $options
  set -- "$@" --caption "$caption" "$work/$name.ply"
done <<END
area|total variation|--curvature area --free-samples
cotangent|the paper's curvature|--free-samples
polyhedral|polyhedral curvature|--curvature polyhedral --free-samples
kept|curvature, samples kept|
END
"$arris" render --quiet --size 220x200 --azimuth 40 "$@" -o "$images/figure6.png"

ls -l "$images"
