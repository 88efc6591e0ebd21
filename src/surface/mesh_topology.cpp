#include "surface/mesh_topology.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"
#include "base/triangle.h"

namespace arris {
namespace {

constexpr std::size_t vertices_per_chunk = 4096;

bool is_proper(const Triangle& t, std::size_t vertices) {
  return t[0] < vertices && t[1] < vertices && t[2] < vertices && t[0] != t[1] && t[1] != t[2] &&
         t[2] != t[0];
}

// Counting sort of the corners of proper triangles by vertex; counts bad corners on the way.
void collect_stars(std::size_t vertices, std::span<const Triangle> triangles, MeshTopology& topo) {
  std::vector<bool> named(vertices);
  topo.star_begin.assign(vertices + 1, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Triangle& corners = triangles[t];
    bool valid = true;
    for (Index v : corners) {
      if (v < vertices) {
        named[v] = true;
      } else {
        topo.invalid_corners.add(static_cast<Index>(t), v);
        valid = false;
      }
    }
    if (is_proper(corners, vertices))
      for (Index v : corners) ++topo.star_begin[v + 1];
    else if (valid)
      topo.repeated_corners.add(static_cast<Index>(t));
  }
  for (std::size_t v = 0; v < vertices; ++v)
    if (!named[v]) topo.unreferenced_vertices.add(static_cast<Index>(v));

  std::partial_sum(topo.star_begin.begin(), topo.star_begin.end(), topo.star_begin.begin());
  topo.star.resize(topo.star_begin.back());
  std::vector<std::size_t> next(topo.star_begin.begin(), topo.star_begin.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (is_proper(triangles[t], vertices))
      for (Index v : triangles[t]) topo.star[next[v]++] = static_cast<Index>(t);
}

// One side of a triangle at the vertex examined.
struct Spoke {
  Index other;          // the vertex at its far end
  std::uint32_t local;  // the triangle, as an index into the star
  std::uint8_t side;    // of that triangle
  bool outgoing;        // the triangle walks from the vertex to `other`
};

// Counts of one chunk of vertices. An edge belongs to its lower vertex.
struct StarCounts {
  std::uint64_t vertices = 0, edges = 0;
  Defects boundary_edges, nonmanifold_edges, misoriented_edges, nonmanifold_vertices;
};

// Examines the stars of a run of vertices, one after the other.
class StarWalker {
 public:
  StarWalker(std::span<const Triangle> triangles, MeshTopology& topo)
      : triangles_(triangles), topo_(topo) {}

  void examine(Index v) {
    const auto star = topo_.star_of(v);
    if (star.empty()) return;
    ++counts.vertices;
    gather_spokes(v, star);
    std::size_t fans = star.size();
    bool branches = false;
    for (std::size_t begin = 0, end; begin < spokes_.size(); begin = end) {
      end = begin + 1;
      while (end < spokes_.size() && spokes_[end].other == spokes_[begin].other) ++end;
      const std::span<const Spoke> edge(spokes_.data() + begin, end - begin);
      for (const Spoke& spoke : edge) fans -= unite(edge[0].local, spoke.local);
      branches |= edge.size() > 2;
      if (v < edge[0].other) examine_edge(v, star, edge);
    }
    if (branches || fans != 1) counts.nonmanifold_vertices.add(v, static_cast<Index>(fans));
  }

  StarCounts counts;

 private:
  void gather_spokes(Index v, std::span<const Index> star) {
    spokes_.clear();
    fan_.resize(star.size());
    std::iota(fan_.begin(), fan_.end(), 0u);
    for (std::uint32_t i = 0; i < star.size(); ++i) {
      const Triangle& t = triangles_[star[i]];
      const std::size_t out = corner_of(t, v), in = (out + 2) % 3;
      spokes_.push_back({t[(out + 1) % 3], i, static_cast<std::uint8_t>(out), true});
      spokes_.push_back({t[in], i, static_cast<std::uint8_t>(in), false});
    }
    std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) {
      return a.other != b.other ? a.other < b.other : a.local < b.local;
    });
  }

  std::uint32_t fan_of(std::uint32_t i) {
    while (fan_[i] != i) i = fan_[i] = fan_[fan_[i]];
    return i;
  }
  // Joins two triangles into one fan; 1 if they were in different ones.
  std::size_t unite(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t a = fan_of(i), b = fan_of(j);
    fan_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

  void examine_edge(Index v, std::span<const Index> star, std::span<const Spoke> edge) {
    ++counts.edges;
    const Index other = edge[0].other;
    if (edge.size() == 1) {
      counts.boundary_edges.add(v, other);
      return;
    }
    if (edge.size() > 2)
      counts.nonmanifold_edges.add(v, other, static_cast<Index>(edge.size()));
    else if (edge[0].outgoing == edge[1].outgoing)
      counts.misoriented_edges.add(v, other);
    for (std::size_t i = 0; i < edge.size(); ++i)
      topo_.neighbours[star[edge[i].local]][edge[i].side] = star[edge[(i + 1) % edge.size()].local];
  }

  std::span<const Triangle> triangles_;
  MeshTopology& topo_;
  std::vector<Spoke> spokes_;
  std::vector<std::uint32_t> fan_;  // union-find over the star
};

void examine_stars(std::span<const Triangle> triangles, MeshTopology& topo, Job& job) {
  const std::size_t vertices = topo.star_begin.size() - 1;
  topo.neighbours.assign(triangles.size(), {no_index, no_index, no_index});
  std::vector<StarCounts> parts((vertices + vertices_per_chunk - 1) / vertices_per_chunk);
  parallel_chunks(vertices, vertices_per_chunk, job.threads(),
                  [&](std::size_t begin, std::size_t end) {
                    StarWalker walker(triangles, topo);
                    for (std::size_t v = begin; v < end; ++v) walker.examine(static_cast<Index>(v));
                    parts[begin / vertices_per_chunk] = walker.counts;
                  });
  for (const StarCounts& part : parts) {
    topo.edges += part.edges;
    topo.euler += static_cast<std::int64_t>(part.vertices) - static_cast<std::int64_t>(part.edges);
    topo.boundary_edges.append(part.boundary_edges);
    topo.nonmanifold_edges.append(part.nonmanifold_edges);
    topo.misoriented_edges.append(part.misoriented_edges);
    topo.nonmanifold_vertices.append(part.nonmanifold_vertices);
  }
  topo.euler += static_cast<std::int64_t>(topo.star.size() / 3);
}

// Flood fill across edges.
void label_components(std::span<const Triangle> triangles, MeshTopology& topo) {
  topo.component.assign(triangles.size(), no_index);
  std::vector<Index> stack;
  const std::size_t vertices = topo.star_begin.size() - 1;
  for (std::size_t seed = 0; seed < triangles.size(); ++seed) {
    if (topo.component[seed] != no_index || !is_proper(triangles[seed], vertices)) continue;
    const auto label = static_cast<Index>(topo.components++);
    topo.component[seed] = label;
    stack.push_back(static_cast<Index>(seed));
    while (!stack.empty()) {
      const Index t = stack.back();
      stack.pop_back();
      for (Index n : topo.neighbours[t]) {
        if (n == no_index || topo.component[n] != no_index) continue;
        topo.component[n] = label;
        stack.push_back(n);
      }
    }
  }
}

}  // namespace

MeshTopology build_topology(std::size_t vertices, std::span<const Triangle> triangles, Job& job) {
  MeshTopology topo;
  collect_stars(vertices, triangles, topo);
  job.tick(0.05);
  examine_stars(triangles, topo, job);
  job.tick(0.15);
  label_components(triangles, topo);
  job.tick(0.2);
  return topo;
}

}  // namespace arris
