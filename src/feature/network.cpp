#include "feature/network.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/vec.h"

namespace arris {
namespace {

// A gap of at most this many edges is closed, along edges that turn by at least this much and bend
// the line by no more than that.
constexpr int longest_gap = 3;
constexpr double gap_turning = radians(4), gap_bend = radians(50);

// A gap does not lead through the tip of a fan of more edges: every loose end at its rim would look
// at all of them.
constexpr std::size_t most_edges = 64;

// A loose end shorter than this many edges is a stub, a line loose at both ends one of fewer than
// twice as many.
constexpr std::size_t shortest_spur = 3;

// The path from loose end v, which edge e leads to, up to the network; empty if there is none.
std::vector<Index> path_on(const Network& network, Index v, Index e) {
  const MeshEdges& edges = network.edges();
  std::vector<Index> path;
  for (int step = 0; step < longest_gap; ++step) {
    if (edges.at(v).size() > most_edges) return {};
    Index best = no_index;
    for (Index o : edges.at(v)) {
      if (o == e || network.has(o) || std::abs(edges.edges[o].turning) < gap_turning ||
          network.bend(e, v, o) > gap_bend)
        continue;
      if (best == no_index ||
          std::abs(edges.edges[o].turning) > std::abs(edges.edges[best].turning))
        best = o;
    }
    if (best == no_index) return {};
    path.push_back(best);
    v = edges.other_end(best, v);
    e = best;
    if (network.degree(v) > 0) return path;
  }
  return {};
}

// The line from loose end v along edge e, to the next vertex that is not of degree 2, or `limit`
// edges of it.
std::vector<Index> line_from(const Network& network, Index v, Index e, std::size_t limit) {
  std::vector<Index> line;
  for (; e != no_index && line.size() < limit; e = network.next(v, e)) {
    line.push_back(e);
    v = network.edges().other_end(e, v);
  }
  return line;
}

Index edge_at_end(const Network& network, Index v) {
  for (Index e : network.edges().at(v))
    if (network.has(e)) return e;
  return no_index;
}

// Removes the stub that starts at loose end v, if it is one; returns where it started from, or
// no_index.
Index remove_stub(Network& network, Index v) {
  const std::size_t limit = 2 * shortest_spur;
  const std::vector<Index> line = line_from(network, v, edge_at_end(network, v), limit);
  if (line.size() >= limit) return no_index;
  Index end = v;
  for (Index e : line) end = network.edges().other_end(e, end);
  const bool loose = network.degree(end) == 1;
  if (!loose && line.size() >= shortest_spur) return no_index;
  for (Index e : line) network.remove(e);
  return end;
}

}  // namespace

Network::Network(const Mesh& mesh, const MeshEdges& edges, std::vector<std::uint8_t> chosen)
    : mesh_(mesh), edges_(edges), chosen_(std::move(chosen)), degree_(mesh.vertices.size(), 0) {
  for (std::size_t e = 0; e < chosen_.size(); ++e)
    if (chosen_[e])
      for (Index v : edges.edges[e].ends) ++degree_[v];
}

void Network::add(Index e) {
  if (chosen_[e]) return;
  chosen_[e] = 1;
  for (Index v : edges_.edges[e].ends) ++degree_[v];
}

void Network::remove(Index e) {
  if (!chosen_[e]) return;
  chosen_[e] = 0;
  for (Index v : edges_.edges[e].ends) --degree_[v];
}

Index Network::next(Index v, Index e) const {
  if (degree_[v] != 2) return no_index;
  for (Index o : edges_.at(v))
    if (o != e && has(o)) return o;
  return no_index;
}

double Network::bend(Index in, Index v, Index out) const {
  const Vec3 a = mesh_.vertices[v] - mesh_.vertices[edges_.other_end(in, v)];
  const Vec3 b = mesh_.vertices[edges_.other_end(out, v)] - mesh_.vertices[v];
  const double sine = length(cross(a, b)), cosine = dot(a, b);
  return sine == 0 && cosine == 0 ? 0 : std::atan2(sine, cosine);
}

void close_gaps(Network& network) {
  std::vector<Index> ends;
  const MeshEdges& edges = network.edges();
  for (std::size_t v = 0; v + 1 < edges.star_begin.size(); ++v)
    if (network.degree(static_cast<Index>(v)) == 1) ends.push_back(static_cast<Index>(v));
  for (Index v : ends) {
    if (network.degree(v) != 1) continue;  // another gap was closed here
    for (Index e : path_on(network, v, edge_at_end(network, v))) network.add(e);
  }
}

void prune_stubs(Network& network) {
  std::vector<Index> ends;
  const std::size_t vertices = network.edges().star_begin.size() - 1;
  for (std::size_t v = 0; v < vertices; ++v)
    if (network.degree(static_cast<Index>(v)) == 1) ends.push_back(static_cast<Index>(v));
  // A junction that loses a stub may become a loose end itself.
  while (!ends.empty()) {
    const Index v = ends.back();
    ends.pop_back();
    if (network.degree(v) != 1) continue;
    const Index start = remove_stub(network, v);
    if (start != no_index && network.degree(start) == 1) ends.push_back(start);
  }
}

}  // namespace arris
