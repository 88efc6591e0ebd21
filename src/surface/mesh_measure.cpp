#include "surface/mesh_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/parallel.h"
#include "base/vec.h"

namespace arris {
namespace {

constexpr std::size_t triangles_per_sum = 4096;

double clamped_ldexp(double x, int exponent) {
  constexpr double largest = std::numeric_limits<double>::max();
  return std::clamp(std::ldexp(x, exponent), -largest, largest);
}

}  // namespace

Frame measuring_frame(std::span<const Vec3> points) {
  Frame frame;
  double largest = 0;
  for (Vec3 p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (largest == 0) return frame;
  // 2^-exponent must itself be a double.
  frame.exponent = std::clamp(std::ilogb(largest) + 1, -1000, 1000);
  frame.scale = std::ldexp(1.0, -frame.exponent);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 lo{infinity, infinity, infinity}, hi = -lo;
  for (Vec3 p : points) {
    const Vec3 q = frame.scale * p;
    lo = {std::min(lo.x, q.x), std::min(lo.y, q.y), std::min(lo.z, q.z)};
    hi = {std::max(hi.x, q.x), std::max(hi.y, q.y), std::max(hi.z, q.z)};
  }
  frame.origin = 0.5 * (lo + hi);
  return frame;
}

MeshMeasure measure(std::span<const Vec3> points, std::span<const Triangle> triangles,
                    const Frame& frame, unsigned threads) {
  std::vector<MeshMeasure> sums((triangles.size() + triangles_per_sum - 1) / triangles_per_sum);
  parallel_chunks(triangles.size(), triangles_per_sum, threads,
                  [&](std::size_t begin, std::size_t end) {
                    MeshMeasure sum;
                    for (std::size_t t = begin; t < end; ++t) {
                      const Vec3 a = frame.map(points[triangles[t][0]]);
                      const Vec3 b = frame.map(points[triangles[t][1]]);
                      const Vec3 c = frame.map(points[triangles[t][2]]);
                      const Vec3 normal = cross(b - a, c - a);
                      sum.volume += dot(a, normal) / 6;
                      sum.area += length(normal) / 2;
                    }
                    sums[begin / triangles_per_sum] = sum;
                  });
  MeshMeasure total;
  for (const MeshMeasure& sum : sums) {
    total.volume += sum.volume;
    total.area += sum.area;
  }
  return {clamped_ldexp(total.volume, 3 * frame.exponent),
          clamped_ldexp(total.area, 2 * frame.exponent)};
}

}  // namespace arris
