#include "surface/short_loops.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>

#include "base/distinct.h"
#include "base/triangle.h"
#include "base/vec.h"

namespace arris {
namespace {

using Bits = std::uint64_t;

// A well-mixed number for each k (the finalizer of SplitMix64).
Bits bits_of(Bits k) {
  k = (k + 1) * 0x9E3779B97F4A7C15u;
  k = (k ^ (k >> 30)) * 0xBF58476D1CE4E5B9u;
  k = (k ^ (k >> 27)) * 0x94D049BB133111EBu;
  return k ^ (k >> 31);
}

struct Side {
  Index facet;
  std::size_t corner;  // opposite
};

// A class per side, as bits: those of a loop's sides, combined by exclusive or, are 0 if and (but
// for chance) only if it bounds.
class LoopClasses {
 public:
  LoopClasses(const FacetMesh& mesh, std::size_t points)
      : mesh_(mesh), sides_(mesh.facets.size()), in_tree_(mesh.facets.size()) {
    grow_tree(points);
    grow_cotree();
  }

  // Whether there is a handle at all.
  bool any() const noexcept { return left_over_ > 0; }
  Bits of(Index facet, std::size_t corner) const noexcept { return sides_[facet][corner]; }

 private:
  Side twin(Side s) const {
    const Index g = mesh_.neighbours[s.facet][s.corner];
    const auto& across = mesh_.neighbours[g];
    return {g, across[0] == s.facet ? 0u : across[1] == s.facet ? 1u : 2u};
  }

  void mark(Side s) {
    const Side t = twin(s);
    in_tree_[s.facet][s.corner] = in_tree_[t.facet][t.corner] = 1;
  }

  void set(Side s, Bits bits) {
    const Side t = twin(s);
    sides_[s.facet][s.corner] = sides_[t.facet][t.corner] = bits;
  }

  // Breadth first over the points of each component.
  void grow_tree(std::size_t points) {
    std::vector<std::uint8_t> reached(points, 0);
    std::vector<Index> queue;
    for (Index root = 0; root < points; ++root) {
      if (reached[root] || mesh_.star(root).empty()) continue;
      reached[root] = 1;
      queue.assign(1, root);
      for (std::size_t i = 0; i < queue.size(); ++i)
        for (Index f : mesh_.star(queue[i])) {
          const Triangle& t = mesh_.facets[f];
          const std::size_t at = corner_of(t, queue[i]);
          if (const Index w = t[(at + 1) % 3]; !reached[w]) {
            reached[w] = 1;
            queue.push_back(w);
            mark({f, (at + 2) % 3});
          }
        }
    }
  }

  // Breadth first over the facets, across sides that are not in the tree. What is left over gets
  // bits of its own; a side of the cotree those of all loops through it: one for each side left
  // over that has one facet beyond it, seen from the root.
  void grow_cotree() {
    constexpr std::uint8_t root = 3, none = 4;
    const std::size_t facets = mesh_.facets.size();
    std::vector<std::uint8_t> up(facets, none);  // the corner opposite the side to the parent
    std::vector<Index> order;
    for (Index f = 0; f < facets; ++f) {
      if (up[f] != none) continue;
      up[f] = root;
      order.push_back(f);
      for (std::size_t i = order.size() - 1; i < order.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
          if (in_tree_[order[i]][k]) continue;
          const Side t = twin({order[i], k});
          if (up[t.facet] != none) continue;
          up[t.facet] = static_cast<std::uint8_t>(t.corner);
          order.push_back(t.facet);
        }
    }
    std::vector<Bits> beyond(facets, 0);
    for (Index f = 0; f < facets; ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const Side t = twin({f, k});
        if (in_tree_[f][k] || t.facet < f || up[f] == k || up[t.facet] == t.corner) continue;
        const Bits bits = bits_of(left_over_++);
        set({f, k}, bits);
        beyond[f] ^= bits;
        beyond[t.facet] ^= bits;
      }
    for (auto f = order.rbegin(); f != order.rend(); ++f) {
      if (up[*f] == root) continue;
      set({*f, up[*f]}, beyond[*f]);
      beyond[mesh_.neighbours[*f][up[*f]]] ^= beyond[*f];
    }
  }

  const FacetMesh& mesh_;
  std::vector<std::array<Bits, 3>> sides_;            // [f][i]: of the side opposite corner i
  std::vector<std::array<std::uint8_t, 3>> in_tree_;  // likewise
  std::size_t left_over_ = 0;
};

struct Loop {
  Bits bits = 0;
  std::vector<Index> points;
};

// The shortest loop through a point, by a breadth-first walk from it.
class LoopFinder {
 public:
  LoopFinder(const FacetMesh& mesh, const LoopClasses& classes, const std::vector<Vec3>& points,
             const std::vector<double>& spacing, int most_sides, double longest)
      : mesh_(mesh),
        classes_(classes),
        points_(points),
        spacing_(spacing),
        most_sides_(most_sides),
        longest_(longest),
        reached_(points.size()) {}

  // Its points in order, or none.
  Loop through(Index start) {
    queue_.assign(1, start);
    reached_[start] = {start, no_index, 0, 0};
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const Index v = queue_[i];
      const Reached here = reached_[v];
      if (2 * here.sides + 1 > most_sides_) break;
      for (Index f : mesh_.star(v)) {
        const std::size_t at = corner_of(mesh_.facets[f], v);
        const Index w = mesh_.facets[f][(at + 1) % 3];
        if (is_long(v, w)) continue;
        const Bits bits = here.bits ^ classes_.of(f, (at + 2) % 3);
        Reached& there = reached_[w];
        if (there.start != start) {
          there = {start, v, here.sides + 1, bits};
          queue_.push_back(w);
        } else if (there.bits != bits && here.sides + there.sides < most_sides_) {
          return {there.bits ^ bits, loop(v, w)};
        }
      }
    }
    return {};
  }

 private:
  struct Reached {
    Index start = no_index;  // of the walk that reached it last
    Index from = no_index;
    int sides = 0;
    Bits bits = 0;
  };

  bool is_long(Index v, Index w) const {
    return distance(points_[v], points_[w]) > longest_ * (spacing_[v] + spacing_[w]) / 2;
  }

  // Without the stem that both ways have in common.
  std::vector<Index> loop(Index v, Index w) const {
    std::vector<Index> there, back;
    for (; v != no_index; v = reached_[v].from) there.push_back(v);
    for (; w != no_index; w = reached_[w].from) back.push_back(w);
    while (there.size() > 1 && back.size() > 1 &&
           there[there.size() - 2] == back[back.size() - 2]) {
      there.pop_back();
      back.pop_back();
    }
    there.insert(there.end(), back.rbegin() + 1, back.rend());
    return there;
  }

  const FacetMesh& mesh_;
  const LoopClasses& classes_;
  const std::vector<Vec3>& points_;
  const std::vector<double>& spacing_;
  const int most_sides_;
  const double longest_;
  std::vector<Reached> reached_;  // per point
  std::vector<Index> queue_;
};

// One end of each side that is of some class: every loop that does not bound has such a side.
std::vector<Index> starts(const FacetMesh& mesh, const LoopClasses& classes) {
  std::vector<Index> at;
  for (Index f = 0; f < mesh.facets.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      if (classes.of(f, k) != 0 && f < mesh.neighbours[f][k])
        at.push_back(mesh.facets[f][(k + 1) % 3]);
  keep_distinct(at);
  return at;
}

}  // namespace

std::vector<std::vector<Index>> short_loops(const FacetMesh& mesh, const std::vector<Vec3>& points,
                                            const std::vector<double>& spacing, int most_sides,
                                            double longest) {
  const LoopClasses classes(mesh, points.size());
  if (!classes.any()) return {};
  LoopFinder finder(mesh, classes, points, spacing, most_sides, longest);
  std::vector<Loop> found;
  for (Index v : starts(mesh, classes))
    if (Loop loop = finder.through(v); !loop.points.empty()) found.push_back(std::move(loop));
  std::stable_sort(found.begin(), found.end(),
                   [](const Loop& a, const Loop& b) { return a.points.size() < b.points.size(); });
  std::vector<std::uint8_t> taken(points.size(), 0);
  std::unordered_set<Bits> known;
  std::vector<std::vector<Index>> apart;
  for (Loop& loop : found) {
    const auto& at = loop.points;
    if (std::any_of(at.begin(), at.end(), [&](Index v) { return taken[v] != 0; })) continue;
    if (!known.insert(loop.bits).second) continue;
    for (Index v : at) taken[v] = 1;
    apart.push_back(std::move(loop.points));
  }
  return apart;
}

int sides_across(const FacetMesh& mesh, const std::vector<Index>& loop, int most) {
  // The facet beside each side of the loop, and what its third corner is.
  std::unordered_map<Index, int> far;  // from the left
  std::vector<Index> queue;
  std::unordered_set<Index> right;
  const auto is_on = [&](Index v) { return std::find(loop.begin(), loop.end(), v) != loop.end(); };
  const auto third = [&](Index v, Index w) {  // of the facet that walks from v to w
    for (Index f : mesh.star(v))
      if (next_corner(mesh.facets[f], v) == w) return previous_corner(mesh.facets[f], v);
    return no_index;
  };
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Index v = loop[k], w = loop[(k + 1) % loop.size()];
    if (const Index l = third(v, w); !is_on(l) && far.try_emplace(l, 1).second) queue.push_back(l);
    if (const Index r = third(w, v); !is_on(r)) right.insert(r);
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index v = queue[i];
    const int here = far[v];
    if (right.contains(v)) return here + 1;
    if (here + 1 >= most) continue;
    for (Index f : mesh.star(v))
      if (const Index w = next_corner(mesh.facets[f], v);
          !is_on(w) && far.try_emplace(w, here + 1).second)
        queue.push_back(w);
  }
  return most + 1;
}

}  // namespace arris
