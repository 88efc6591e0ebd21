// A perspective camera that looks at the origin.
#pragma once

#include <algorithm>
#include <vector>

#include "viewer/geometry.h"

namespace arris::viewer {

struct Ray {
  Vec3 origin, direction;  // direction of length 1
};

// The model is scaled into the unit ball. z is up. Zooming enlarges the picture and leaves the eye
// where it is, so nothing is ever behind the eye.
class Camera {
 public:
  // Azimuth in degrees: 0 looks along +y, larger ones from further to the right. Elevation in
  // degrees above the horizon, within [-90, 90].
  Camera(double azimuth, double elevation);

  // Sets scale and centre so that all points fit into width x height pixels, then enlarges by
  // `zoom` round the middle.
  void fit(const std::vector<Vec3>& points, double width, double height, double zoom);

  Pixel project(Vec3 p) const;
  Ray ray(Pixel at) const;
  double pixel_size() const { return eye_distance / scale_; }  // at the distance of the origin

  // 0 at the near end of the unit ball, 1 at the far end.
  double remoteness(double distance) const {
    return std::clamp((distance - eye_distance + 1) / 2, 0.0, 1.0);
  }

  Vec3 eye() const { return eye_; }
  Vec3 right() const { return right_; }
  Vec3 up() const { return up_; }
  Vec3 forward() const { return forward_; }

 private:
  // In radii of the model: mild perspective, which tells near from far without distortion.
  static constexpr double eye_distance = 4.5;

  Vec3 eye_, right_, up_, forward_;
  double scale_ = 1;  // pixels per unit of (offset / depth)
  Pixel centre_;
};

}  // namespace arris::viewer
