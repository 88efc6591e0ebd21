#include "arris/check.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/failure.h"
#include "base/parallel.h"
#include "base/vec.h"
#include "surface/certify.h"
#include "surface/component_orientation.h"
#include "surface/mesh_measure.h"
#include "surface/mesh_topology.h"
#include "surface/self_intersection.h"
#include "tetra/predicates.h"

namespace arris {
namespace {

// Everything found, with examples.
struct Findings {
  MeshTopology topology;
  Defects non_finite, collinear, intersections, inward;
  MeshMeasure measure;
};

Defects find_non_finite(const std::vector<Vec3>& points) {
  Defects bad;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!is_finite(points[v])) bad.add(static_cast<Index>(v));
  return bad;
}

// Triangles fit for the search for intersections. Counts the collinear ones.
std::vector<Index> select_solid(const Mesh& mesh, const MeshTopology& topology, unsigned threads,
                                Defects& collinear_triangles) {
  const std::size_t n = mesh.triangles.size();
  std::vector<std::uint8_t> solid(n);
  parallel_for(n, threads, [&](std::size_t t) {
    const Triangle& c = mesh.triangles[t];
    solid[t] = topology.component[t] != no_index &&
               !collinear(mesh.vertices[c[0]], mesh.vertices[c[1]], mesh.vertices[c[2]]);
  });
  std::vector<Index> selected;
  selected.reserve(n);
  for (std::size_t t = 0; t < n; ++t) {
    if (solid[t])
      selected.push_back(static_cast<Index>(t));
    else if (topology.component[t] != no_index)
      collinear_triangles.add(static_cast<Index>(t));
  }
  return selected;
}

void examine_geometry(const Mesh& mesh, Job& job, Findings& found) {
  const Frame frame = measuring_frame(mesh.vertices);
  found.measure = measure(mesh.vertices, mesh.triangles, frame, job.threads());
  auto selected = select_solid(mesh, found.topology, job.threads(), found.collinear);
  const bool all_solid = selected.size() == mesh.triangles.size();
  job.tick(0.25);
  const BoxTree tree(mesh.vertices, mesh.triangles, std::move(selected), frame, job.threads());
  found.intersections = find_intersections(mesh.vertices, mesh.triangles, tree, job, 0.4).pairs;
  if (!all_solid || !found.topology.is_closed_manifold() || found.intersections.count > 0) return;
  found.inward = find_inward_components(mesh.vertices, mesh.triangles, found.topology, tree, job);
  // Solids bounded the right way round hold something, though it may round to nothing.
  if (found.topology.components > 0 && found.inward.count == 0)
    found.measure.volume =
        std::max(found.measure.volume, std::numeric_limits<double>::denorm_min());
}

std::string edge(const Defects& d) {
  return "edge " + std::to_string(d.example[0]) + "-" + std::to_string(d.example[1]);
}

// The first defect in the order of the fields of Certificate.
std::string describe(const Findings& found, const Certificate& c) {
  const MeshTopology& topo = found.topology;
  const auto id = [](const Defects& d, std::size_t i) { return std::to_string(d.example[i]); };
  const std::string skipped = "; its geometry was not examined";
  if (c.invalid_indices > 0)
    return "triangle " + id(topo.invalid_corners, 0) + " names vertex " +
           id(topo.invalid_corners, 1) + " of " + std::to_string(c.vertices) + skipped;
  if (c.non_finite_vertices > 0)
    return "vertex " + id(found.non_finite, 0) + " is not finite" + skipped;
  if (topo.repeated_corners.count > 0)
    return "triangle " + id(topo.repeated_corners, 0) + " has the same corner twice";
  if (c.degenerate_triangles > 0)
    return "the corners of triangle " + id(found.collinear, 0) + " lie on one line";
  if (c.boundary_edges > 0) return edge(topo.boundary_edges) + " has only one triangle";
  if (c.nonmanifold_edges > 0)
    return edge(topo.nonmanifold_edges) + " has " + id(topo.nonmanifold_edges, 2) + " triangles";
  if (c.nonmanifold_vertices > 0)
    return "the triangles round vertex " + id(topo.nonmanifold_vertices, 0) + " form " +
           id(topo.nonmanifold_vertices, 1) + " fans";
  if (c.misoriented_edges > 0)
    return "both triangles at " + edge(topo.misoriented_edges) + " walk it in the same direction";
  if (c.intersecting_pairs > 0)
    return "triangles " + id(found.intersections, 0) + " and " + id(found.intersections, 1) +
           " intersect";
  if (c.inward_components > 0)
    return "the component of triangle " + id(found.inward, 0) +
           (found.inward.example[1] == 1 ? " bounds a cavity but its normals point out of it"
                                         : " has its normals pointing inwards");
  return c.triangles == 0 ? "the mesh has no triangles" : "";
}

Certificate summarize(const Mesh& mesh, const Findings& found) {
  const MeshTopology& topo = found.topology;
  Certificate c;
  c.vertices = mesh.vertices.size();
  c.triangles = mesh.triangles.size();
  c.edges = topo.edges;
  c.invalid_indices = topo.invalid_corners.count;
  c.non_finite_vertices = found.non_finite.count;
  c.unreferenced_vertices = topo.unreferenced_vertices.count;
  c.degenerate_triangles = topo.repeated_corners.count + found.collinear.count;
  c.boundary_edges = topo.boundary_edges.count;
  c.nonmanifold_edges = topo.nonmanifold_edges.count;
  c.nonmanifold_vertices = topo.nonmanifold_vertices.count;
  c.misoriented_edges = topo.misoriented_edges.count;
  c.intersecting_pairs = found.intersections.count;
  c.inward_components = found.inward.count;
  c.components = topo.components;
  c.euler = topo.euler;
  c.volume = found.measure.volume;
  c.area = found.measure.area;
  c.first_defect = describe(found, c);
  return c;
}

void require_memory(const Mesh& mesh, const Context& context) {
  const std::size_t limit =
      context.memory_limit > 0 ? context.memory_limit : std::size_t{machine_memory()};
  const std::size_t need = forecast_certify_memory(mesh.vertices.size(), mesh.triangles.size());
  if (limit > 0 && need > limit)
    throw Failure(ErrorCode::out_of_memory,
                  "checking the mesh needs up to " + std::to_string(need) +
                      " bytes of memory but the limit is " + std::to_string(limit),
                  "raise the memory limit or use a machine with more memory");
}

}  // namespace

std::size_t forecast_certify_memory(std::size_t vertices, std::size_t triangles) {
  // Per vertex: where its star begins, twice while sorting, and whether it is named. Per triangle:
  // star 12, neighbours 12, component and stack 8, selection 5, boxes and nodes 24 to 72, order 4,
  // and 16 while building. Not foreseen: some 300 more for each triangle round the tip of a fan, or
  // among long ones, whose box overlaps hundreds of others (crowd.h).
  constexpr std::size_t bytes_per_vertex = 17, bytes_per_triangle = 129;
  return bytes_per_vertex * vertices + bytes_per_triangle * triangles;
}

Certificate certify(const Mesh& mesh, Job& job) {
  if (mesh.vertices.size() >= no_index || mesh.triangles.size() >= no_index)
    throw Failure(ErrorCode::out_of_memory, "the mesh has more than 4294967294 elements of a kind",
                  "check it in parts");
  Findings found;
  found.topology = build_topology(mesh.vertices.size(), mesh.triangles, job);
  found.non_finite = find_non_finite(mesh.vertices);
  if (found.topology.invalid_corners.count == 0 && found.non_finite.count == 0)
    examine_geometry(mesh, job, found);
  job.tick(1);
  return summarize(mesh, found);
}

Result<Certificate> check(const Mesh& mesh, const Context& context) {
  return guarded([&] {
    require_memory(mesh, context);
    Job job(context);
    job.stage("check", 1);
    Certificate certificate = certify(mesh, job);
    job.finish();
    return certificate;
  });
}

}  // namespace arris
