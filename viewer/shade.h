// Light and colour of surfaces: flat shading by three lights fixed to the eye, and ambient
// occlusion.
#pragma once

#include <functional>

#include "arris/context.h"
#include "viewer/image.h"
#include "viewer/ray_scene.h"

namespace arris::viewer {

struct Quality {
  int supersampling = 3;  // rays per pixel and axis
  int occlusion = 64;     // rays per pixel for ambient occlusion; 0: none
};

// A part of a picture.
struct Region {
  int x = 0, y = 0, width = 0, height = 0;
};

// The colour of a surface at a position of the scene. Called from several threads.
using Paint = std::function<Colour(Vec3)>;

// Fills the region, the camera's pixel (0, 0) being its upper left corner. Surfaces seen from
// behind are ochre, so that wrong orientation shows. Cost: pixels * (supersampling^2 + occlusion)
// rays. Triangles have the colour that `paint`, if not empty, gives them on either side. Stops
// early if cancelled.
void shade(const RayScene& scene, const Camera& camera, const Quality& quality, const Paint& paint,
           const Region& region, const Context& context, Image& image);

}  // namespace arris::viewer
