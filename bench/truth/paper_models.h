// Models of Figures 7-10 of the paper that are not in shapes.h, and others with holes. The paper
// shows them without dimensions; these have the same parts. Resolution: segments round a circle.
#pragma once

#include "arris/types.h"

namespace arris::truth {

Mesh two_spheres(int resolution);    // radii 1 and 0.85, overlapping
Mesh male_symbol(int resolution);    // a flat ring, a bar and an arrow head, all with sharp edges
Mesh female_symbol(int resolution);  // a torus and a cross of two round bars
Mesh buckyball();                    // truncated icosahedron, edge 2
Mesh brilliant_diamond();            // round brilliant cut: 57 facets, culet and girdle of 16 sides
Mesh power_wheel(int resolution);    // a wheel with ten teeth, a bored hub and a groove: genus 1
Mesh tear_drop(int resolution);      // smooth but for its tip, a cone of 90 degrees
Mesh dumb_bell(int resolution);      // two balls on a bar
Mesh bolt(int resolution);           // hexagonal head, shank, thread
Mesh drilled_bracket(int resolution);  // an L of two plates, two holes in each: genus 4

// The threaded rod of the bolt: a thread of triangular profile round the z axis, from below z = 0
// to above `length`, between the radii `root` and `crest`.
Mesh threaded_rod(double root, double crest, double pitch, double length, int resolution);

}  // namespace arris::truth
