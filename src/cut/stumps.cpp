#include "cut/stumps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/distinct.h"
#include "base/vec.h"
#include "energy/facet.h"

namespace arris {
namespace {

// In units of spacing: a facet that spans more than the first is a gap, one beside it that spans
// more than the second belongs to it. The cap of a square bar of four spacings just does.
constexpr double sure_gap = 1.5, likely_gap = 1.25;
// A cap has more area than a disc of one spacing, in squares of the spacing.
constexpr double smallest_cap = std::numbers::pi;
// Mean cosine between a region and the surface round it, at most: of a stump's cap, 60 degrees, and
// of what faces it, from which it may have branched off. A sparse spot on a wall has nearly 1.
constexpr double stump_rim = 0.5, straightest_rim = 0.8;
// Cosine between the axis and either cap, at least; the stumps at a missing corner of a cube's
// frame have 0.71.
constexpr double least_facing = 0.7;
// Length of the axis, at most, in units of the root of the smaller cap's area: the width of a bar.
constexpr double longest_axis = 4;

// The largest distance of a point of the triangle to the nearest of its corners.
double reach_of(Vec3 a, Vec3 b, Vec3 c) {
  // Opposite c the longest side.
  if (squared_length(b - c) > squared_length(a - b)) std::swap(a, c);
  if (squared_length(a - c) > squared_length(a - b)) std::swap(b, c);
  const double ab = distance(a, b), ac = distance(a, c), bc = distance(b, c);
  if (dot(a - c, b - c) > 0) return 0.5 * ab * ac * bc / length(cross(b - a, c - a));
  // Obtuse: on the longest side, where a or b is as near as c.
  const double cos_a = dot(b - a, c - a) / (ab * ac), cos_b = dot(a - b, c - b) / (ab * bc);
  return std::max(0.5 * ac / cos_a, 0.5 * bc / cos_b);
}

// False without a root if the points are near enough together that no point of the triangle is so
// far from a corner: the circumradius of an acute triangle is at most its longest side over root
// three, and an obtuse one's farthest point is nearer than half of that side.
bool may_reach(Vec3 a, Vec3 b, Vec3 c, double far) {
  constexpr double slack = 0.999;  // for rounding
  return std::max({squared_length(a - b), squared_length(b - c), squared_length(c - a)}) >
         3 * slack * far * far;
}

// A connected region of facets that span a gap.
struct Region {
  std::vector<std::size_t> facets;
  double area = 0;   // in squares of the spacing
  double width = 0;  // root of the area, as a length
  double rim = 1;    // mean cosine between it and the surface round it
  Vec3 centre, normal;
};

// Looks round every point once, however many facets it has.
std::vector<Region> find_regions(const CutSurface& s) {
  std::vector<Region> regions;
  std::vector<std::uint8_t> seen(s.facets.size(), 0), looked_round(s.points, 0);
  for (std::size_t k = 0; k < s.facets.size(); ++k) {
    if (seen[k] || s.facets[k].reach <= sure_gap) continue;
    Region region;
    region.facets.push_back(k);
    seen[k] = 1;
    for (std::size_t r = 0; r < region.facets.size(); ++r) {
      const CutSurface::Facet& f = s.facets[region.facets[r]];
      region.area += f.area;
      for (Index v : f.corners) {
        if (std::exchange(looked_round[v], std::uint8_t{1})) continue;
        for (std::size_t n : s.round(v))
          if (!seen[n] && s.facets[n].reach > likely_gap) {
            seen[n] = 1;
            region.facets.push_back(n);
          }
      }
    }
    if (region.area >= smallest_cap) regions.push_back(std::move(region));
  }
  return regions;
}

struct FacetName {
  Tet inside;
  std::uint32_t i;
};

std::array<Index, 3> corners_of(const TetMesh& mesh, const FacetName& f) {
  const auto& v = mesh.vertices[f.inside];
  const auto& k = facet_corners[f.i];
  return {v[static_cast<std::size_t>(k[0])], v[static_cast<std::size_t>(k[1])],
          v[static_cast<std::size_t>(k[2])]};
}

std::vector<FacetName> boundary_facets(const TetMesh& mesh, const Labels& labels) {
  std::vector<FacetName> facets;
  for (Tet t = 0; t < mesh.finite; ++t) {
    if (!labels[t]) continue;
    for (std::uint32_t i = 0; i < 4; ++i)
      if (!labels[mesh.neighbours[t][i]]) facets.push_back({t, i});
  }
  return facets;
}

CutSurface::Facet measure_facet(const TetMesh& mesh, const std::vector<double>& spacing,
                                const FacetName& f) {
  const std::array<Index, 3> c = corners_of(mesh, f);
  const double h = std::max({spacing[c[0]], spacing[c[1]], spacing[c[2]]});
  const Vec3 n = facet_normal(mesh, f.inside, static_cast<int>(f.i));
  const double twice = length(n);
  const double reach = reach_of(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]) / h;
  return {f.inside, f.i, c, (twice > 0 ? 1 / twice : 0) * n, 0.5 * twice / (h * h), reach};
}

CutSurface measure_all(const TetMesh& mesh, const std::vector<double>& spacing,
                       const std::vector<FacetName>& facets) {
  CutSurface s;
  std::vector<Triangle> corners;
  s.facets.reserve(facets.size());
  corners.reserve(facets.size());
  for (const FacetName& f : facets) {
    s.facets.push_back(measure_facet(mesh, spacing, f));
    corners.push_back(s.facets.back().corners);
  }
  s.points = mesh.points.size();
  s.stars = FacetStars(s.points, corners);
  return s;
}

// 1 at the points of every region that find_regions would find among all facets.
std::vector<std::uint8_t> points_of_gaps(const TetMesh& mesh, const std::vector<double>& spacing,
                                         const std::vector<FacetName>& facets) {
  std::vector<FacetName> wide;
  for (const FacetName& f : facets) {
    const std::array<Index, 3> c = corners_of(mesh, f);
    const double h = std::max({spacing[c[0]], spacing[c[1]], spacing[c[2]]});
    if (may_reach(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]], likely_gap * h))
      wide.push_back(f);
  }
  const CutSurface gaps = measure_all(mesh, spacing, wide);
  std::vector<std::uint8_t> marked(mesh.points.size(), 0);
  for (const Region& r : find_regions(gaps))
    for (std::size_t k : r.facets)
      for (Index v : gaps.facets[k].corners) marked[v] = 1;
  return marked;
}

void measure(const TetMesh& mesh, const CutSurface& s, Region& region) {
  double area = 0;
  for (std::size_t k : region.facets) {
    const CutSurface::Facet& f = s.facets[k];
    const double a = 0.5 * length(facet_normal(mesh, f.inside, static_cast<int>(f.i)));
    area += a;
    region.normal = region.normal + a * f.normal;
    for (Index v : f.corners) region.centre = region.centre + a / 3 * mesh.points[v];
  }
  region.width = std::sqrt(area);
  region.centre = 1 / area * region.centre;
  const double turned = length(region.normal);
  if (turned > 0) region.normal = 1 / turned * region.normal;
}

// Those facets and all that share a point with them, ascending. O(n log n) whatever the degrees.
std::vector<std::size_t> grow(const CutSurface& s, const std::vector<std::size_t>& facets) {
  std::vector<Index> points;
  for (std::size_t k : facets)
    points.insert(points.end(), s.facets[k].corners.begin(), s.facets[k].corners.end());
  keep_distinct(points);
  std::vector<std::size_t> grown;
  for (Index v : points) grown.insert(grown.end(), s.round(v).begin(), s.round(v).end());
  keep_distinct(grown);
  return grown;
}

// Mean cosine, by area, between the region and the facets outside it within two rings.
double cosine_at_rim(const CutSurface& s, const Region& region) {
  const std::vector<std::size_t> ring = grow(s, grow(s, region.facets));
  std::vector<std::size_t> inner = region.facets;
  std::sort(inner.begin(), inner.end());
  double sum = 0, area = 0;
  for (std::size_t k : ring) {
    if (std::binary_search(inner.begin(), inner.end(), k)) continue;
    sum += s.facets[k].area * dot(s.facets[k].normal, region.normal);
    area += s.facets[k].area;
  }
  return area > 0 ? sum / area : 1;
}

bool face_each_other(const Region& a, const Region& b) {
  const Vec3 axis = b.centre - a.centre;
  const double d = length(axis);
  return std::min(a.rim, b.rim) <= stump_rim && d > 0 &&
         d < longest_axis * std::min(a.width, b.width) && dot(a.normal, axis) > least_facing * d &&
         dot(b.normal, axis) < -least_facing * d;
}

}  // namespace

CutSurface cut_surface_of(const TetMesh& mesh, const std::vector<double>& spacing,
                          const Labels& labels) {
  return measure_all(mesh, spacing, boundary_facets(mesh, labels));
}

CutSurface surface_near_gaps(const TetMesh& mesh, const std::vector<double>& spacing,
                             const Labels& labels) {
  std::vector<FacetName> facets = boundary_facets(mesh, labels);
  const std::vector<std::uint8_t> at_gap = points_of_gaps(mesh, spacing, facets);
  std::vector<std::uint8_t> near = at_gap;
  const auto touches = [&](const std::vector<std::uint8_t>& marked, const FacetName& f) {
    const auto c = corners_of(mesh, f);
    return marked[c[0]] || marked[c[1]] || marked[c[2]];
  };
  for (const FacetName& f : facets)
    if (touches(at_gap, f))
      for (Index v : corners_of(mesh, f)) near[v] = 1;
  std::erase_if(facets, [&](const FacetName& f) { return !touches(near, f); });
  return measure_all(mesh, spacing, facets);
}

Stumps find_stumps(const TetMesh& mesh, const CutSurface& surface) {
  Stumps stumps{std::vector<std::uint8_t>(surface.facets.size(), 0), {}, 0};
  std::vector<Region> caps = find_regions(surface);
  for (Region& r : caps) {
    measure(mesh, surface, r);
    r.rim = cosine_at_rim(surface, r);
  }
  std::erase_if(caps, [](const Region& r) { return r.rim > straightest_rim; });
  stumps.caps = caps.size();
  for (std::size_t a = 0; a < caps.size(); ++a)
    for (std::size_t b = a + 1; b < caps.size(); ++b) {
      if (!face_each_other(caps[a], caps[b])) continue;
      stumps.axes.push_back({a, b, {caps[a].centre, caps[b].centre}});
      for (std::size_t k : caps[a].facets) stumps.cap[k] = 1;
      for (std::size_t k : caps[b].facets) stumps.cap[k] = 1;
    }
  return stumps;
}

}  // namespace arris
