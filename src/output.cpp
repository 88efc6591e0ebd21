#include "output.h"

#include <algorithm>

#include "surface/extract.h"

namespace arris {
namespace {

// Where point v of the mesh lies for the user.
Vec3 user_position(const PointCloud& cloud, const Samples& samples, const TetMesh& mesh, Index v) {
  if (!mesh.is_sample(v)) return samples.frame.to_user(mesh.points[v]);
  const Vec3 given = cloud.positions[samples.source[v]];
  return samples.frame.to_local(given) == mesh.points[v] ? given
                                                         : samples.frame.to_user(mesh.points[v]);
}

std::vector<Attribute> pick_attributes(const PointCloud& cloud, const std::vector<Index>& source) {
  std::vector<Attribute> picked;
  for (const Attribute& given : cloud.attributes) {
    Attribute a{given.name, given.type, std::vector<double>(source.size(), 0)};
    for (std::size_t v = 0; v < source.size(); ++v)
      if (source[v] != no_index) a.values[v] = given.values[source[v]];
    picked.push_back(std::move(a));
  }
  return picked;
}

}  // namespace

Mesh output_mesh(const PointCloud& cloud, const Samples& samples, const TetMesh& mesh,
                 const Labels& labels) {
  ExtractedSurface surface = extract_surface(mesh, labels);
  Mesh out;
  out.triangles = std::move(surface.triangles);
  for (Index v : surface.point) {
    out.vertices.push_back(user_position(cloud, samples, mesh, v));
    out.source.push_back(mesh.is_sample(v) ? samples.source[v] : no_index);
  }
  out.attributes = pick_attributes(cloud, out.source);
  bool only_given = true;
  for (std::size_t v = 0; v < out.vertices.size() && only_given; ++v)
    only_given = out.source[v] != no_index && out.vertices[v] == cloud.positions[out.source[v]];
  out.position_type = only_given ? cloud.position_type : ScalarType::f64;
  return out;
}

TetVolume output_volume(const PointCloud& cloud, const Samples& samples, const TetMesh& mesh,
                        const Labels& labels) {
  ExtractedSolid solid = extract_solid(mesh, labels);
  TetVolume out;
  out.tetrahedra = std::move(solid.tetrahedra);
  for (Index v : solid.point) out.vertices.push_back(user_position(cloud, samples, mesh, v));
  return out;
}

std::vector<float> output_confidence(const Mesh& mesh, const Samples& samples, const Seeds& seeds) {
  const Index last = *std::max_element(samples.source.begin(), samples.source.end());
  std::vector<Index> sample_of(static_cast<std::size_t>(last) + 1, no_index);
  for (std::size_t k = 0; k < samples.source.size(); ++k)
    sample_of[samples.source[k]] = static_cast<Index>(k);
  std::vector<float> confidence(mesh.vertices.size(), 0);
  for (std::size_t v = 0; v < confidence.size(); ++v)
    if (mesh.source[v] != no_index) confidence[v] = seeds.confidence[sample_of[mesh.source[v]]];
  return confidence;
}

void fill_counts(const PointCloud& cloud, const Samples& samples, const TetMesh& mesh,
                 const std::vector<double>& spacing, const Seeds& seeds, Report& report) {
  report.input_points = cloud.positions.size();
  report.non_finite_points = samples.non_finite;
  report.duplicate_points = samples.duplicates;
  report.samples = samples.points.size();
  report.tetrahedra = mesh.finite;
  report.shift = samples.frame.shift;
  report.scale = samples.frame.scale;
  std::vector<double> sorted(spacing.begin(),
                             spacing.begin() + static_cast<std::ptrdiff_t>(report.samples));
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  report.spacing = sorted[sorted.size() / 2] / samples.frame.scale;
  report.contradiction = seeds.contradiction;
  report.warnings = cloud.warnings;
}

}  // namespace arris
