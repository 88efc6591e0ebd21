#include "compare/error_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/failure.h"
#include "base/job.h"
#include "base/parallel.h"
#include "base/vec.h"
#include "compare/colour_map.h"
#include "compare/compare.h"
#include "compare/sampling.h"
#include "compare/surface.h"

namespace arris::compare {
namespace {

constexpr std::size_t vertices_per_chunk = 1024;

const std::array<std::string, 4> names = {"distance", "red", "green", "blue"};

bool is_replaced(const Attribute& attribute) {
  return std::find(names.begin(), names.end(), attribute.name) != names.end();
}

void add_colours(const std::vector<double>& distances, double full, Mesh& mesh) {
  std::array<Attribute, 3> channels;
  for (std::size_t k = 0; k < 3; ++k) {
    channels[k].name = names[k + 1];
    channels[k].type = ScalarType::u8;
  }
  for (const double distance : distances) {
    const auto colour = viridis(std::isfinite(distance) ? distance / full : 1);
    for (std::size_t k = 0; k < 3; ++k) channels[k].values.push_back(std::round(255 * colour[k]));
  }
  for (Attribute& channel : channels) mesh.attributes.push_back(std::move(channel));
}

}  // namespace

struct DistanceToMesh::Tree {
  UnitFrame frame;
  Surface surface;
};

Result<DistanceToMesh> DistanceToMesh::make(const Mesh& mesh, const std::string& name,
                                            const Context& context) {
  return guarded([&] {
    require_surface(mesh, name);
    const UnitFrame frame = unit_frame(mesh, name);
    DistanceToMesh distance;
    distance.tree_ = std::make_shared<const Tree>(
        Tree{frame, make_surface(mesh, frame, name, resolve_threads(context.threads))});
    return distance;
  });
}

double DistanceToMesh::operator()(Vec3 p) const {
  if (!is_finite(p)) return undefined;
  return (*tree_->surface.tree)(tree_->frame.map(p)).distance * tree_->frame.diagonal;
}

double DistanceToMesh::diagonal() const {
  return tree_->frame.diagonal;
}

Result<Mesh> error_map(const Mesh& mesh, const DistanceToMesh& truth, double full,
                       const Context& context) {
  return guarded([&] {
    Job job(context);
    job.stage("error map", 1);
    const std::size_t n = mesh.vertices.size();
    Attribute distances{names[0], ScalarType::f64, std::vector<double>(n)};
    for_chunks(job, n, vertices_per_chunk, 0, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end && !job.cancelled(); ++v)
        distances.values[v] = truth(mesh.vertices[v]);
    });
    Mesh map = mesh;
    std::erase_if(map.attributes, is_replaced);
    map.attributes.push_back(std::move(distances));
    add_colours(map.attributes.back().values, full, map);
    job.finish();
    return map;
  });
}

}  // namespace arris::compare
