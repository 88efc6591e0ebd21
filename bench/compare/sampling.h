// Points drawn on surfaces, and loops over many of them.
#pragma once

#include <cstddef>
#include <functional>

#include "base/job.h"
#include "compare/draw.h"
#include "compare/surface.h"

namespace arris::compare {

struct SurfacePoint {
  Vec3 at;
  Index triangle = no_index;
};

// The point at `share` in [0, 1) of the area, placed in its triangle by two draws.
SurfacePoint point_on(const Surface& surface, double share, Draw& draw);

// body(begin, end) for consecutive chunks of [0, n) of `grain` elements, in parallel, ticking the
// stage of `job` from `from` to `to`. Throws Failure(cancelled).
void for_chunks(Job& job, std::size_t n, std::size_t grain, double from, double to,
                const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace arris::compare
