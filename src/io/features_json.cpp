// Feature curves as JSON.
#include <nlohmann/json.hpp>

#include "arris/version.h"
#include "io/writers.h"

namespace arris {
namespace {

using Json = nlohmann::ordered_json;

Json to_array(Vec3 p) {
  return Json::array({p.x, p.y, p.z});
}

Json to_object(const Mesh& mesh, const FeatureCurve& curve) {
  Json positions = Json::array();
  for (Index v : curve.vertices) positions.push_back(to_array(mesh.vertices[v]));
  return {{"kind", name(curve.kind)},
          {"closed", curve.closed},
          {"length", curve.length},
          {"mean_angle", curve.mean_angle},
          {"sharpest_angle", curve.sharpest_angle},
          {"vertices", curve.vertices},
          {"positions", std::move(positions)}};
}

Json to_object(const FeatureCorner& corner) {
  return {{"vertex", corner.vertex},
          {"degree", corner.degree},
          {"position", to_array(corner.position)}};
}

}  // namespace

// A line per curve and corner: the file stays fit for people and for line tools.
void write_network_json(AtomicFile& file, const Mesh& mesh, const FeatureNetwork& network,
                        Job& job) {
  const auto write_list = [&](const char* key, const auto& things, auto&& object) {
    file.text("  \"" + std::string(key) + "\": [");
    for (std::size_t k = 0; k < things.size(); ++k)
      file.text((k > 0 ? ",\n    " : "\n    ") + object(things[k]).dump());
    file.text(things.empty() ? "],\n" : "\n  ],\n");
  };
  file.text("{\n  \"version\": " + Json(version()).dump() + ",\n");
  write_list("curves", network.curves, [&](const FeatureCurve& c) { return to_object(mesh, c); });
  job.tick(0.9);
  write_list("corners", network.corners, [](const FeatureCorner& c) { return to_object(c); });
  file.text("  \"patches\": " + std::to_string(network.patches) + "\n}\n");
}

}  // namespace arris
