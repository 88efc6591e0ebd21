#include "viewer/camera.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace arris::viewer {

Camera::Camera(double azimuth, double elevation) {
  const double a = azimuth * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
  right_ = {std::cos(a), std::sin(a), 0};
  forward_ = {-std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), -std::sin(e)};
  up_ = cross(right_, forward_);
  eye_ = -eye_distance * forward_;
}

void Camera::fit(const std::vector<Vec3>& points, double width, double height, double zoom) {
  constexpr double filled = 0.9;  // share of the picture, the rest is margin
  constexpr double infinity = std::numeric_limits<double>::infinity();
  scale_ = 1;
  centre_ = {};
  Pixel low = {infinity, infinity}, high = {-infinity, -infinity};
  for (const Vec3 p : points) {
    const Pixel q = project(p);
    low = {std::min(low.x, q.x), std::min(low.y, q.y)};
    high = {std::max(high.x, q.x), std::max(high.y, q.y)};
  }
  constexpr double smallest = 1e-3;  // of a model that is seen as a point
  scale_ = zoom * filled *
           std::min(width / std::max(high.x - low.x, smallest),
                    height / std::max(high.y - low.y, smallest));
  centre_ = {width / 2 - scale_ * (low.x + high.x) / 2, height / 2 - scale_ * (low.y + high.y) / 2};
}

Pixel Camera::project(Vec3 p) const {
  const Vec3 q = p - eye_;
  const double s = scale_ / dot(q, forward_);
  return {centre_.x + s * dot(q, right_), centre_.y - s * dot(q, up_)};
}

Ray Camera::ray(Pixel at) const {
  const Vec3 across = ((at.x - centre_.x) / scale_) * right_;
  const Vec3 upwards = ((centre_.y - at.y) / scale_) * up_;
  return {eye_, normalized(forward_ + across + upwards)};
}

}  // namespace arris::viewer
