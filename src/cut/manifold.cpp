#include "cut/manifold.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "base/parallel.h"
#include "base/triangle.h"
#include "tetra/facet_stars.h"

namespace arris {
namespace {

// Flips a tetrahedron may make in both directions before it may only leave the solid. A pinch that
// is still there after two rounds of filling and carving is not worth a third.
constexpr std::uint8_t free_flips = 4;

constexpr std::size_t tetrahedra_per_tick = 1 << 16;

// Where a tetrahedron stands in a star: a small open-addressing table, refilled for each star. A
// binary search in the star costs ten times as much, in mispredicted branches.
class StarIndex {
 public:
  void fill(std::span<const Tet> star) {
    std::size_t size = 64;
    while (size < 2 * star.size()) size *= 2;
    slots_.assign(size, {no_tet, 0});
    for (std::uint32_t k = 0; k < star.size(); ++k) slots_[slot(star[k])] = {star[k], k};
  }
  // Its place; no_tet if it is not in the star.
  std::uint32_t operator[](Tet t) const {
    const Slot& s = slots_[slot(t)];
    return s.tet == t ? s.place : no_tet;
  }

 private:
  struct Slot {
    Tet tet;
    std::uint32_t place;
  };
  std::size_t slot(Tet t) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t s = t & mask;
    while (slots_[s].tet != t && slots_[s].tet != no_tet) s = (s + 1) & mask;
    return s;
  }
  std::vector<Slot> slots_;
};

// The connected parts of a star: tetrahedra of one label joined through facets at the vertex.
struct Parts {
  std::vector<std::uint32_t> part;   // per tetrahedron of the star
  std::vector<std::uint8_t> inside;  // per part
  std::array<std::uint32_t, 2> count = {0, 0};
  std::vector<std::uint32_t> stack;
  StarIndex index;
};

void find_parts(const TetMesh& mesh, const Labels& labels, std::span<const Tet> star, Index v,
                Parts& parts) {
  constexpr std::uint32_t unset = 0xFFFFFFFFu;
  parts.part.assign(star.size(), unset);
  parts.inside.clear();
  parts.count = {0, 0};
  parts.index.fill(star);
  for (std::uint32_t first = 0; first < star.size(); ++first) {
    if (parts.part[first] != unset) continue;
    const auto id = static_cast<std::uint32_t>(parts.inside.size());
    const std::uint8_t label = labels[star[first]];
    parts.inside.push_back(label);
    ++parts.count[label];
    parts.part[first] = id;
    parts.stack.assign(1, first);
    while (!parts.stack.empty()) {
      const Tet t = star[parts.stack.back()];
      parts.stack.pop_back();
      for (std::size_t i = 0; i < 4; ++i) {
        const Tet n = mesh.neighbours[t][i];
        if (mesh.vertices[t][i] == v || labels[n] != label) continue;
        const std::uint32_t k = parts.index[n];
        if (parts.part[k] != unset) continue;
        parts.part[k] = id;
        parts.stack.push_back(k);
      }
    }
  }
}

// Of facet i of t, outward.
Triangle corners_of(const TetMesh& mesh, Tet t, std::size_t i) {
  Triangle corners;
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] = mesh.vertices[t][static_cast<std::size_t>(facet_corners[i][k])];
  return corners;
}

// The curve between inside and outside on the link of a vertex, as directed edges (from, to) with
// the inside on the left.
class LinkCurve {
 public:
  void collect(const TetMesh& mesh, const Labels& labels, std::span<const Tet> star, Index v) {
    edges_.clear();
    for (Tet t : star) {
      if (!labels[t]) continue;
      for (std::size_t i = 0; i < 4; ++i)
        if (mesh.vertices[t][i] != v && !labels[mesh.neighbours[t][i]])
          add(corners_of(mesh, t, i), v);
    }
  }
  void collect(const std::vector<Triangle>& triangles, std::span<const Index> star, Index v) {
    edges_.clear();
    for (Index t : star) add(triangles[t], v);
  }

  // No curve, or one simple closed curve.
  bool is_simple() {
    if (edges_.empty()) return true;
    if (edges_.size() > few) std::sort(edges_.begin(), edges_.end());
    std::size_t at = 0;
    for (std::size_t step = 1;; ++step) {
      const std::size_t next =
          edges_.size() > few ? only_in_order(edges_[at].to) : only_one_from(edges_[at].to);
      if (next == edges_.size()) return false;  // the curve meets itself here
      if (next == 0) return step == edges_.size();
      at = next;
    }
  }

 private:
  struct Edge {
    Index from, to;
    auto operator<=>(const Edge&) const = default;
  };
  void add(const Triangle& facet, Index v) {
    edges_.push_back({next_corner(facet, v), previous_corner(facet, v)});
  }

  // Up to so many edges the search from the first on is faster.
  static constexpr std::size_t few = 32;

  // The edge that starts at v, the number of edges if there are several.
  std::size_t only_one_from(Index v) const {
    std::size_t found = edges_.size();
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      if (edges_[k].from != v) continue;
      if (found != edges_.size()) return edges_.size();
      found = k;
    }
    return found;
  }
  std::size_t only_in_order(Index v) const {
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), Edge{v, 0});
    const auto next = at + 1;
    if (next < edges_.end() && next->from == v) return edges_.size();
    return static_cast<std::size_t>(at - edges_.begin());
  }
  std::vector<Edge> edges_;
};

class Untangler {
 public:
  Untangler(const TetMesh& mesh, const Stars& stars, const FacetCost& cost, Labels& labels)
      : mesh_(mesh), stars_(stars), cost_(cost), labels_(labels), flips_(mesh.size(), 0) {}

  std::uint64_t run(Job& job) {
    std::vector<Index> queue = singular_vertices(job.threads());
    queued_.assign(mesh_.points.size(), 0);
    for (Index v : queue) queued_[v] = 1;
    std::size_t looked_at = tetrahedra_per_tick;
    for (std::size_t k = 0; k < queue.size(); ++k) {
      const Index v = queue[k];
      queued_[v] = 0;
      do {
        if (looked_at >= tetrahedra_per_tick) {
          job.tick(static_cast<double>(k) / static_cast<double>(queue.size()));
          looked_at = 0;
        }
        looked_at += stars_[v].size();
      } while (repair(v));
      for (Index w : touched_)
        if (!queued_[w]) {
          queued_[w] = 1;
          queue.push_back(w);
        }
      touched_.clear();
    }
    return total_;
  }

 private:
  std::vector<Index> singular_vertices(unsigned threads) const {
    std::vector<Triangle> facets;
    for (Tet t = 0; t < mesh_.finite; ++t) {
      if (!labels_[t]) continue;
      for (std::size_t i = 0; i < 4; ++i)
        if (!labels_[mesh_.neighbours[t][i]]) facets.push_back(corners_of(mesh_, t, i));
    }
    const FacetStars stars(mesh_.points.size(), facets);
    std::vector<std::uint8_t> singular(mesh_.points.size());
    parallel_chunks(singular.size(), 4096, threads, [&](std::size_t begin, std::size_t end) {
      LinkCurve curve;
      for (std::size_t v = begin; v < end; ++v) {
        curve.collect(facets, stars[static_cast<Index>(v)], static_cast<Index>(v));
        singular[v] = !curve.is_simple();
      }
    });
    std::vector<Index> list;
    for (std::size_t v = 0; v < singular.size(); ++v)
      if (singular[v]) list.push_back(static_cast<Index>(v));
    return list;
  }

  // One flip towards a regular star; false if it is regular.
  bool repair(Index v) {
    const auto star = stars_[v];
    find_parts(mesh_, labels_, star, v, parts_);
    if (parts_.count[0] <= 1 && parts_.count[1] <= 1) return false;
    std::uint32_t best = 0;
    double best_cost = std::numeric_limits<double>::infinity();
    for (std::uint32_t p = 0; p < parts_.inside.size(); ++p) {
      const double c = flip_cost(star, p);
      if (c < best_cost) {
        best_cost = c;
        best = p;
      }
    }
    for (std::size_t k = 0; k < star.size(); ++k)
      if (parts_.part[k] == best) flip(star[k]);
    return true;
  }

  // Change of the surface's cost if part p changes sides; infinity if it may not, or need not.
  double flip_cost(std::span<const Tet> star, std::uint32_t p) const {
    constexpr double forbidden = std::numeric_limits<double>::infinity();
    const std::uint8_t label = parts_.inside[p];
    if (parts_.count[label] < 2 && (label == 0 || !must_carve(star)))
      return forbidden;  // the only part of its side: flipping it takes the vertex off the surface
    double change = 0;
    for (std::size_t k = 0; k < star.size(); ++k) {
      if (parts_.part[k] != p) continue;
      const Tet t = star[k];
      if (!mesh_.is_finite(t) || (label == 0 && flips_[t] >= free_flips)) return forbidden;
      for (std::size_t i = 0; i < 4; ++i) {
        const Tet n = mesh_.neighbours[t][i];
        const bool same = labels_[n] == label;
        if (same && in_part(n, p)) continue;
        change += same ? cost_(t, static_cast<int>(i)) : -cost_(t, static_cast<int>(i));
      }
    }
    return change;
  }

  bool in_part(Tet t, std::uint32_t p) const {
    const std::uint32_t k = parts_.index[t];
    return k != no_tet && parts_.part[k] == p;
  }

  // Inside is one part, outside several, and none of those may be filled any more.
  bool must_carve(std::span<const Tet> star) const {
    if (parts_.count[1] != 1) return false;
    for (std::uint32_t p = 0; p < parts_.inside.size(); ++p) {
      if (parts_.inside[p]) continue;
      bool fillable = true;
      for (std::size_t k = 0; k < star.size(); ++k)
        if (parts_.part[k] == p && (!mesh_.is_finite(star[k]) || flips_[star[k]] >= free_flips))
          fillable = false;
      if (fillable) return false;
    }
    return true;
  }

  void flip(Tet t) {
    labels_[t] ^= 1;
    if (flips_[t] < free_flips) ++flips_[t];
    ++total_;
    for (Index w : mesh_.vertices[t])
      if (w != infinite_vertex) touched_.push_back(w);
  }

  const TetMesh& mesh_;
  const Stars& stars_;
  const FacetCost& cost_;
  Labels& labels_;
  std::vector<std::uint8_t> flips_, queued_;
  std::vector<Index> touched_;
  Parts parts_;
  std::uint64_t total_ = 0;
};

}  // namespace

bool is_regular_vertex(const TetMesh& mesh, const Labels& labels, std::span<const Tet> star,
                       Index v) {
  LinkCurve curve;
  curve.collect(mesh, labels, star, v);
  return curve.is_simple();
}

std::uint64_t make_manifold(const TetMesh& mesh, const Stars& stars, const FacetCost& cost,
                            Labels& labels, Job& job) {
  return Untangler(mesh, stars, cost, labels).run(job);
}

}  // namespace arris
