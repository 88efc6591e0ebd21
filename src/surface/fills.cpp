#include "surface/fills.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "base/vec.h"

namespace arris {
namespace {

// In units of spacing. Faces between blue, graded or scanned samples span gaps of up to 1.0,
// between random ones up to 1.7 (38 models each): from the first value on a gap is a hole in the
// data, and from the second a face beside one belongs to it.
constexpr double sure_gap = 2.0, likely_gap = 1.25;

// In squares of the spacing. A filled region below the first, less than a disc of one spacing, is
// no hole worth the name; a supported one in the midst of a fill below the second, a disc of two
// spacings, says nothing about the surface there.
constexpr double smallest_fill = std::numbers::pi, smallest_island = 4 * std::numbers::pi;

// A face that hangs by one edge hangs too far if it reaches beyond it by this multiple of its
// length, and is a sliver if it is less high than this share of its longest edge.
constexpr double longest_ear = 2.0, thinnest_ear = 0.15;

class FillFinder {
 public:
  FillFinder(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
             const MeshTopology& topology, const FaceGaps& gaps)
      : vertices_(vertices),
        triangles_(triangles),
        topology_(topology),
        filled_(triangles.size(), 0),
        taken_(triangles.size(), 0),
        area_(triangles.size()) {
    for (std::size_t t = 0; t < area_.size(); ++t)
      area_[t] = face_area(t) / (gaps.spacing[t] * gaps.spacing[t]);
    grow(gaps.gap);
  }

  std::vector<std::uint8_t> run() {
    flip_small_regions(1, smallest_fill);
    // Every step only adds to the fill, so this ends.
    bool changed = true;
    while (changed) {
      changed = flip_small_regions(0, smallest_island);
      changed = part_touching_fans() || changed;
      changed = drop_ears() || changed;
    }
    return std::move(filled_);
  }

 private:
  Vec3 corner(std::size_t t, std::size_t k) const { return vertices_[triangles_[t][k % 3]]; }
  double face_area(std::size_t t) const {
    return 0.5 * length(cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0)));
  }

  void grow(const std::vector<float>& gaps) {
    std::vector<Index> stack;
    const auto fill = [&](Index t) {
      filled_[t] = 1;
      stack.push_back(t);
    };
    for (std::size_t t = 0; t < gaps.size(); ++t)
      if (gaps[t] > sure_gap && !filled_[t]) fill(static_cast<Index>(t));
    while (!stack.empty()) {
      const Index t = stack.back();
      stack.pop_back();
      for (Index n : topology_.neighbours[t])
        if (n != no_index && !filled_[n] && gaps[n] > likely_gap) fill(n);
    }
  }

  // Connected regions of faces with this flag that border on others and have less area: gives them
  // the other flag. True if there were any.
  bool flip_small_regions(std::uint8_t flag, double smallest) {
    bool flipped = false;
    std::vector<std::uint8_t> seen(filled_.size(), 0);
    std::vector<Index> region;
    for (std::size_t first = 0; first < filled_.size(); ++first) {
      if (seen[first] || filled_[first] != flag) continue;
      region.assign(1, static_cast<Index>(first));
      seen[first] = 1;
      double area = 0;
      bool borders = false;
      for (std::size_t k = 0; k < region.size(); ++k) {
        area += area_[region[k]];
        for (Index n : topology_.neighbours[region[k]]) {
          if (n == no_index) continue;
          borders = borders || filled_[n] != flag;
          if (seen[n] || filled_[n] != flag) continue;
          seen[n] = 1;
          region.push_back(n);
        }
      }
      if (!borders || area >= smallest) continue;
      flipped = true;
      for (Index t : region) {
        filled_[t] = flag ^ 1;
        seen[t] = 1;
      }
    }
    return flipped;
  }

  // Where supported faces form several fans round a vertex, leaves the one of the largest area.
  bool part_touching_fans() {
    bool changed = false;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      const auto star = topology_.star_of(static_cast<Index>(v));
      const bool mixed = std::any_of(star.begin(), star.end(), [&](Index t) { return filled_[t]; });
      if (mixed) changed = keep_largest_fan(static_cast<Index>(v), star) || changed;
    }
    return changed;
  }

  bool keep_largest_fan(Index v, std::span<const Index> star) {
    std::vector<Index> best, fan;
    double best_area = 0;
    bool changed = false;
    for (Index first : star) {
      if (filled_[first] || taken_[first]) continue;
      take_fan(v, first, fan);
      double area = 0;
      for (Index t : fan) area += area_[t];
      if (best.empty() || area > best_area) {
        best.swap(fan);
        best_area = area;
      }
    }
    for (Index t : star) taken_[t] = 0;
    for (Index t : best) taken_[t] = 1;
    for (Index t : star)
      if (!filled_[t] && !taken_[t]) {
        filled_[t] = 1;
        changed = true;
      }
    for (Index t : best) taken_[t] = 0;
    return changed;
  }

  // The fan of supported faces round v that `first` is of; marks them as taken.
  void take_fan(Index v, Index first, std::vector<Index>& fan) {
    fan.assign(1, first);
    taken_[first] = 1;
    for (std::size_t k = 0; k < fan.size(); ++k)
      for (std::size_t side = 0; side < 3; ++side) {
        const Triangle& c = triangles_[fan[k]];
        if (c[side] != v && c[(side + 1) % 3] != v) continue;
        const Index n = topology_.neighbours[fan[k]][side];
        if (n == no_index || filled_[n] || taken_[n]) continue;
        taken_[n] = 1;
        fan.push_back(n);
      }
  }

  // Supported faces that hang by one edge, too far or as a sliver.
  bool drop_ears() {
    bool changed = false;
    for (std::size_t t = 0; t < filled_.size(); ++t) {
      if (filled_[t]) continue;
      std::size_t open = 0, held = 0;
      for (std::size_t side = 0; side < 3; ++side) {
        const Index n = topology_.neighbours[t][side];
        if (n != no_index && filled_[n])
          ++open;
        else
          held = side;
      }
      if (open < 2 || !hangs_badly(t, held)) continue;
      filled_[t] = 1;
      changed = true;
    }
    return changed;
  }

  bool hangs_badly(std::size_t t, std::size_t held) const {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, distance(corner(t, k), corner(t, k + 1)));
    const double base = distance(corner(t, held), corner(t, held + 1)), area = face_area(t);
    return 2 * area < thinnest_ear * longest * longest || 2 * area > longest_ear * base * base;
  }

  std::span<const Vec3> vertices_;
  std::span<const Triangle> triangles_;
  const MeshTopology& topology_;
  std::vector<std::uint8_t> filled_;
  std::vector<std::uint8_t> taken_;  // all 0 between calls
  std::vector<double> area_;         // in squares of the local spacing
};

std::vector<Attribute> pick(const std::vector<Attribute>& attributes,
                            const std::vector<Index>& kept) {
  std::vector<Attribute> picked;
  for (const Attribute& a : attributes) {
    picked.push_back({a.name, a.type, {}});
    for (Index k : kept) picked.back().values.push_back(a.values[k]);
  }
  return picked;
}

}  // namespace

std::vector<std::uint8_t> filled_faces(std::span<const Vec3> vertices,
                                       std::span<const Triangle> triangles,
                                       const MeshTopology& topology, const FaceGaps& gaps) {
  return FillFinder(vertices, triangles, topology, gaps).run();
}

Kept kept_elements(const Mesh& mesh, const std::vector<std::uint8_t>& filled) {
  Kept kept;
  std::vector<std::uint8_t> used(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (filled[t]) continue;
    kept.triangles.push_back(static_cast<Index>(t));
    for (Index v : mesh.triangles[t]) used[v] = 1;
  }
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) kept.vertices.push_back(static_cast<Index>(v));
  return kept;
}

Mesh extract_part(const Mesh& mesh, const Kept& kept) {
  Mesh part;
  std::vector<Index> number(mesh.vertices.size(), no_index);
  for (Index v : kept.vertices) {
    number[v] = static_cast<Index>(part.vertices.size());
    part.vertices.push_back(mesh.vertices[v]);
    if (!mesh.source.empty()) part.source.push_back(mesh.source[v]);
  }
  for (Index t : kept.triangles) {
    const Triangle& c = mesh.triangles[t];
    part.triangles.push_back({number[c[0]], number[c[1]], number[c[2]]});
  }
  part.attributes = pick(mesh.attributes, kept.vertices);
  part.face_attributes = pick(mesh.face_attributes, kept.triangles);
  part.position_type = mesh.position_type;
  return part;
}

}  // namespace arris
