#include "describe.h"

#include <algorithm>

#include "base/failure.h"
#include "base/vec.h"
#include "feature/find_features.h"
#include "surface/certify.h"
#include "surface/fills.h"
#include "surface/mesh_topology.h"
#include "surface/support.h"

namespace arris {
namespace {

// Spans a gap of one spacing at most: fully supported.
float support_of(float gap) {
  return 1 / std::max(gap, 1.0f);
}

void find_fills(const Samples& samples, const std::vector<double>& spacing, Reconstruction& result,
                Job& job) {
  std::vector<Vec3> vertices;
  vertices.reserve(result.mesh.vertices.size());
  for (Vec3 p : result.mesh.vertices) vertices.push_back(samples.frame.to_local(p));
  const FaceGaps gaps = face_gaps({vertices, result.mesh.triangles, samples.points, spacing}, job);
  const MeshTopology topology = build_topology(vertices.size(), result.mesh.triangles, job);
  result.filled = filled_faces(vertices, result.mesh.triangles, topology, gaps);
  result.support.reserve(gaps.gap.size());
  for (float gap : gaps.gap) result.support.push_back(support_of(gap));
  double all = 0, filled = 0;
  for (std::size_t t = 0; t < result.filled.size(); ++t) {
    const Triangle& c = result.mesh.triangles[t];
    const Vec3 a = vertices[c[0]];
    const double area = length(cross(vertices[c[1]] - a, vertices[c[2]] - a));
    all += area;
    if (result.filled[t]) filled += area;
  }
  result.report.filled_faces =
      static_cast<std::uint64_t>(std::count(result.filled.begin(), result.filled.end(), 1));
  result.report.filled_area = all > 0 ? filled / all : 0;
}

template <class T>
void pick(std::vector<T>& values, const std::vector<Index>& kept) {
  std::vector<T> picked;
  for (Index k : kept) picked.push_back(values[k]);
  values = std::move(picked);
}

void trim(Reconstruction& result, Job& job) {
  const Kept kept = kept_elements(result.mesh, result.filled);
  if (kept.triangles.empty())
    throw Failure(ErrorCode::no_surface, "no face of the mesh is supported by samples",
                  "do not trim, or give more points");
  result.mesh = extract_part(result.mesh, kept);
  pick(result.confidence, kept.vertices);
  pick(result.support, kept.triangles);
  pick(result.filled, kept.triangles);
  Report& report = result.report;
  report.trimmed = true;
  report.certificate = certify(result.mesh, job);
  if (!report.certificate.sound())
    throw Failure(ErrorCode::certificate,
                  "the trimmed mesh failed its check: " + report.certificate.first_defect,
                  "please report it with the input");
}

}  // namespace

void describe_surface(const Samples& samples, const std::vector<double>& spacing,
                      Reconstruction& result, Job& job) {
  job.stage("support", 0.5 * describe_share);
  find_fills(samples, spacing, result, job);
  if (result.report.options.trim) {
    job.stage("trim", 0);
    trim(result, job);
  }
  job.stage("features", 0.5 * describe_share);
  result.features = feature_network(result.mesh, job);
  result.report.features = count_features(result.features);
}

}  // namespace arris
