// The lines of a mesh that are drawn: sharp edges, contours, boundaries, and all edges if asked;
// hidden parts removed.
#pragma once

#include <vector>

#include "viewer/ink.h"
#include "viewer/ray_scene.h"

namespace arris::viewer {

enum class LineKind { smooth, contour, sharp, boundary };

struct Line {
  Vec3 a, b;
  LineKind kind = LineKind::smooth;
};

// All edges of the mesh, once each. An edge of one triangle is a boundary; of two whose planes
// turn by more than `angle` (radians), sharp; of three or more, sharp; of two of which one faces
// the eye and one does not, a contour. O(n log n).
std::vector<Line> classify_edges(const Model& model, double angle, Vec3 eye);

// Draws the visible parts of a line: pieces of a pixel whose middle nothing hides from the eye.
void draw_visible(const Line& line, const RayScene& scene, const Camera& camera, double pen,
                  Ink& ink);

}  // namespace arris::viewer
