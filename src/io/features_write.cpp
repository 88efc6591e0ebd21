// Feature curves as PLY with edges and as OBJ with polylines.
#include <string>
#include <vector>

#include "arris/version.h"
#include "base/failure.h"
#include "io/writers.h"

namespace arris {
namespace {

// The vertices that the network uses, in the order of the mesh.
struct UsedVertices {
  std::vector<Index> vertex;          // ascending
  std::vector<Index> number;          // per vertex of the mesh, or no_index
  std::vector<std::uint32_t> degree;  // of the corner there; 0 within a curve
};

UsedVertices used_vertices(const Mesh& mesh, const FeatureNetwork& network) {
  UsedVertices used;
  std::vector<std::uint32_t> degree(mesh.vertices.size(), 0);
  used.number.assign(mesh.vertices.size(), no_index);
  for (const FeatureCurve& curve : network.curves)
    for (Index v : curve.vertices) used.number[v] = 0;
  for (const FeatureCorner& corner : network.corners) {
    used.number[corner.vertex] = 0;
    degree[corner.vertex] = corner.degree;
  }
  for (std::size_t v = 0; v < used.number.size(); ++v) {
    if (used.number[v] == no_index) continue;
    used.number[v] = static_cast<Index>(used.vertex.size());
    used.vertex.push_back(static_cast<Index>(v));
    used.degree.push_back(degree[v]);
  }
  return used;
}

std::size_t edges_of(const FeatureCurve& curve) {
  return curve.vertices.size() - (curve.closed ? 0 : 1);
}

void require_vertex(const std::string& path, Index v, std::size_t vertices) {
  if (v >= vertices)
    throw Failure(ErrorCode::usage,
                  "'" + path + "': a curve names vertex " + std::to_string(v) + ", but there are " +
                      std::to_string(vertices),
                  "give the mesh on which the curves were found");
}

}  // namespace

void require_consistent(const std::string& path, const Mesh& mesh, const FeatureNetwork& network) {
  for (const FeatureCurve& curve : network.curves) {
    if (curve.vertices.size() < 2)
      throw Failure(ErrorCode::usage, "'" + path + "': a curve has fewer than two vertices",
                    "give curves as find_features finds them");
    for (Index v : curve.vertices) require_vertex(path, v, mesh.vertices.size());
  }
  for (const FeatureCorner& corner : network.corners)
    require_vertex(path, corner.vertex, mesh.vertices.size());
}

void write_network_ply(AtomicFile& file, const Mesh& mesh, const FeatureNetwork& network,
                       Job& job) {
  const UsedVertices used = used_vertices(mesh, network);
  std::size_t edges = 0;
  for (const FeatureCurve& curve : network.curves) edges += edges_of(curve);
  file.text("ply\nformat binary_little_endian 1.0\ncomment arris " ARRIS_VERSION
            "\ncomment kind 0 convex, 1 concave, 2 mixed; angle: interior, in degrees\n");
  file.text("element vertex " + std::to_string(used.vertex.size()) +
            "\nproperty double x\nproperty double y\nproperty double z\n"
            "property uint vertex\nproperty uint degree\n");
  file.text("element edge " + std::to_string(edges) +
            "\nproperty int vertex1\nproperty int vertex2\nproperty int curve\n"
            "property float angle\nproperty uchar kind\nend_header\n");
  for (std::size_t k = 0; k < used.vertex.size(); ++k) {
    const Vec3 p = mesh.vertices[used.vertex[k]];
    for (const double c : {p.x, p.y, p.z}) file.binary(c);
    file.binary(used.vertex[k]);
    file.binary(used.degree[k]);
  }
  Ticker tick(job, 0.5, 1, network.curves.size());
  for (std::size_t c = 0; c < network.curves.size(); ++c) {
    tick(c);
    const FeatureCurve& curve = network.curves[c];
    for (std::size_t k = 0; k < edges_of(curve); ++k) {
      file.binary(used.number[curve.vertices[k]]);
      file.binary(used.number[curve.vertices[(k + 1) % curve.vertices.size()]]);
      file.binary(static_cast<std::int32_t>(c));
      file.binary(static_cast<float>(curve.mean_angle));
      file.binary(static_cast<std::uint8_t>(curve.kind));
    }
  }
}

void write_network_obj(AtomicFile& file, const Mesh& mesh, const FeatureNetwork& network,
                       Job& job) {
  const UsedVertices used = used_vertices(mesh, network);
  const auto write_number = [&](Index v) {
    file.text(" ");
    file.number(std::uint64_t{used.number[v]} + 1);
  };
  for (Index v : used.vertex) {
    file.text("v ");
    write_position(file, mesh.vertices[v]);
    file.text("\n");
  }
  Ticker tick(job, 0.5, 1, network.curves.size());
  for (std::size_t c = 0; c < network.curves.size(); ++c) {
    tick(c);
    const FeatureCurve& curve = network.curves[c];
    file.text("g curve_" + std::to_string(c) + " " + name(curve.kind) + "\nl");
    for (Index v : curve.vertices) write_number(v);
    if (curve.closed) write_number(curve.vertices.front());
    file.text("\n");
  }
  if (network.corners.empty()) return;
  file.text("g corners\np");
  for (const FeatureCorner& corner : network.corners) write_number(corner.vertex);
  file.text("\n");
}

}  // namespace arris
