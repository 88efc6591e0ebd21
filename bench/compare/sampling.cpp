#include "compare/sampling.h"

#include <algorithm>

#include "base/parallel.h"
#include "base/vec.h"

namespace arris::compare {
namespace {

constexpr std::size_t chunks_per_tick = 64;

}  // namespace

SurfacePoint point_on(const Surface& surface, double share, Draw& draw) {
  const Index triangle = surface.solid[surface.solid_at(share)];
  double u = draw.unit(), v = draw.unit();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const auto& [a, b, c] = surface.triangles[triangle];
  const Vec3 p = surface.points[a];
  return {p + u * (surface.points[b] - p) + v * (surface.points[c] - p), triangle};
}

void for_chunks(Job& job, std::size_t n, std::size_t grain, double from, double to,
                const std::function<void(std::size_t, std::size_t)>& body) {
  const std::size_t batch = grain * chunks_per_tick;
  for (std::size_t start = 0; start < n; start += batch) {
    job.tick(from + (to - from) * static_cast<double>(start) / static_cast<double>(n));
    parallel_chunks(std::min(batch, n - start), grain, job.threads(),
                    [&](std::size_t begin, std::size_t end) { body(start + begin, start + end); });
  }
  job.tick(to);
}

}  // namespace arris::compare
