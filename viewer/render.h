// Pictures of meshes and point clouds, without a display: the same bytes every time.
#pragma once

#include <string>
#include <vector>

#include "arris/context.h"
#include "arris/error.h"
#include "arris/types.h"
#include "viewer/image.h"
#include "viewer/shade.h"

namespace arris::viewer {

// One picture of several side by side. A mesh, or points drawn as small balls, or both.
struct Panel {
  Mesh mesh;
  std::vector<Vec3> points;
  std::string caption;  // printable ASCII; anything else appears as question marks
  Paint paint{};        // colour of the mesh at a position of its own; if empty, as always
};

enum class Up { x, y, z };

struct View {
  int width = 640, height = 480;  // pixels of each panel without its caption, 16 to 16384
  Up up = Up::z;                  // the axis of the model that points up
  double azimuth = 30;    // degrees round it: larger looks from further to the right; 0 looks along
                          // +y (up z), -z (up y) or +z (up x)
  double elevation = 25;  // degrees above the horizon, -90 to 90
  double zoom = 1;        // 1 fits the model into the panel, > 0
  double edge_angle = 30;     // degrees, 0 to 180: edges that turn by more are drawn, and contours
  bool wireframe = false;     // draw all edges
  double point_size = 4;      // pixels across
  int columns = 0;            // panels a row; 0: all in one row
  bool common_frame = false;  // one scale and position for all panels, else each fills its own
  Quality quality;
};

// Draws every panel with the same view. Errors: usage (no panels, a number out of range, a picture
// of more than 2^28 pixels), bad_points (nothing to draw, or coordinates that are not finite or
// beyond 1e150), unreadable (a triangle with a corner that names no vertex), out_of_memory,
// internal.
Result<Image> render(const std::vector<Panel>& panels, const View& view,
                     const Context& context = {});

}  // namespace arris::viewer
