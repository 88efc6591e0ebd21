#include "feature/find_features.h"

#include <string>

#include "arris/report.h"
#include "base/failure.h"
#include "base/vec.h"
#include "feature/creases.h"
#include "feature/curves.h"
#include "feature/mesh_edges.h"
#include "feature/network.h"
#include "feature/patches.h"
#include "feature/small_patches.h"

namespace arris {
namespace {

void require_sound(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (Index v : mesh.triangles[t])
      if (v >= mesh.vertices.size())
        throw Failure(ErrorCode::usage,
                      "triangle " + std::to_string(t) + " names vertex " + std::to_string(v) +
                          " of " + std::to_string(mesh.vertices.size()),
                      "correct the mesh");
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (!is_finite(mesh.vertices[v]))
      throw Failure(ErrorCode::bad_points, "vertex " + std::to_string(v) + " is not finite",
                    "correct the mesh");
}

}  // namespace

Network crease_network(const Mesh& mesh, const MeshEdges& edges, Job& job) {
  const std::vector<Crease> creases = judge_edges(mesh, edges, job);
  job.tick(0.9);
  Network network(mesh, edges, connect_creases(mesh, edges, creases));
  close_gaps(network);
  prune_stubs(network);
  merge_small_patches(network);
  prune_stubs(network);
  return network;
}

FeatureNetwork feature_network(const Mesh& mesh, Job& job) {
  const MeshEdges edges = collect_edges(mesh, job);
  job.tick(0.4);
  const Network network = crease_network(mesh, edges, job);
  FeatureNetwork result;
  trace_curves(mesh, network, result);
  label_patches(network, result);
  job.tick(1);
  return result;
}

FeatureCounts count_features(const FeatureNetwork& network) {
  FeatureCounts counts;
  counts.curves = network.curves.size();
  for (const FeatureCurve& curve : network.curves) {
    counts.closed_curves += curve.closed;
    counts.convex_curves += curve.kind == CurveKind::convex;
    counts.concave_curves += curve.kind == CurveKind::concave;
    counts.length += curve.length;
  }
  for (const FeatureCorner& corner : network.corners)
    ++(corner.degree == 1 ? counts.ends : counts.corners);
  counts.patches = network.patches;
  return counts;
}

Result<FeatureNetwork> find_features(const Mesh& mesh, const Context& context) {
  return guarded([&] {
    require_sound(mesh);
    Job job(context);
    job.stage("features", 1);
    FeatureNetwork result = feature_network(mesh, job);
    job.finish();
    return result;
  });
}

}  // namespace arris
