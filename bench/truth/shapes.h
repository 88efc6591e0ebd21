// Solids made by code, with what is known about them: the ground truth of tests of the whole
// pipeline. Every mesh is closed, manifold and oriented outwards (towards the void in a cavity).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "arris/types.h"

namespace arris::truth {

// What is known of a solid by pencil and paper, not by measuring its mesh.
struct Facts {
  std::size_t components = 1;  // of the surface; a cavity is one
  long euler = 2;              // V - E + F of the whole surface
  double volume = 0, area = 0;
  // Sum of length * |pi - theta| / 2 over the edges. Of a smooth surface: the integral of
  // (|k1| + |k2|) / 2, to which the sum tends on a mesh along its lines of curvature. (That is the
  // integral of |H| but for saddles, where a sum of absolute values depends on the mesh.)
  double total_mean_curvature = 0;
  bool curved = false;  // facts are those of the smooth solid; the mesh agrees within 0.5 %
};

struct Shape {
  std::string name;
  Mesh mesh;
  Facts facts;
};

// Boxes and what boxes make. The angle at every edge is 90 or 270 degrees.
Shape cube();             // [0,1]^3
Shape two_cubes();        // two unit cubes that overlap in one eighth
Shape perforated_cube();  // [0,3]^3 with a unit square tunnel along every axis: genus 5
Shape l_bracket();        // an L of arms 3 x 1, 2 deep
Shape thin_plate();       // 1 x 1 x 0.05
Shape tangled_frames();   // two frames of a cube of side 5, interlocked, 1 apart everywhere
Shape nested_shells();    // cubes of side 5, 3 (void) and 1 (solid): three components
Shape steps();            // a staircase of three unit steps, 2 wide

// Convex polyhedra.
Shape octahedron();       // corners at distance 1
Shape icosahedron();      // edge 2
Shape dodecahedron();     // edge 2 / golden ratio
Shape hexagonal_prism();  // sides 1, height 1
Shape wedge();  // right-angled triangle 2 x 1 extruded by 1: its sharpest edge is 26.6 deg

// Surfaces of revolution about z, finely tessellated.
Shape sphere();    // radius 1
Shape torus();     // radii 1 and 0.4
Shape cylinder();  // radius 0.5, height 1
Shape cone();      // radius 0.5, height 1

// All of the above, in that order, or one by its name; throws std::out_of_range if there is none.
std::vector<Shape> all_shapes();
Shape make_shape(std::string_view name);

// An axis-aligned box, to be added to the solid or (solid = false) carved from it.
struct Box {
  Vec3 low, high;
  bool solid = true;
};
// The boundary of the boxes applied in order, on the grid of all their coordinates. Throws
// std::invalid_argument if that is not manifold (boxes that touch in an edge or a corner only).
Mesh box_complex(const std::vector<Box>& boxes);

// The convex hull of a few points, faces cut into fans. O(n^4): for dozens of points.
Mesh convex_hull(const std::vector<Vec3>& points);

// The mesh turned by a rotation drawn from `seed`, then scaled, then shifted: takes grid-aligned
// shapes out of degenerate position and away from the origin.
Mesh moved(Mesh mesh, std::uint64_t seed, double scale = 1, Vec3 shift = {});

}  // namespace arris::truth
