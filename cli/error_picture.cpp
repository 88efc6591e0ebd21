#ifdef ARRIS_HAS_VIEWER

#include "error_picture.h"

#include <array>
#include <string>
#include <vector>

#include "compare/colour_map.h"
#include "text.h"
#include "viewer/legend.h"

namespace arris::cli {
namespace {

viewer::Colour colour_of(double t) {
  const std::array<double, 3> c = compare::viridis(t);
  return {c[0], c[1], c[2]};
}

viewer::Panel panel(const Mesh& mesh, const compare::DistanceToMesh& distance, double full,
                    const char* caption) {
  viewer::Panel panel;
  panel.mesh = mesh;
  panel.paint = [distance, full](Vec3 p) { return colour_of(distance(p) / full); };
  panel.caption = caption;
  return panel;
}

}  // namespace

Result<viewer::Image> error_picture(const Mesh& result, const Mesh& truth,
                                    const compare::DistanceToMesh& to_truth, double full,
                                    const viewer::View& view, const Context& context) {
  const auto to_result = compare::DistanceToMesh::make(result, "result", context);
  if (!to_result) return to_result.error();
  viewer::View both = view;
  both.common_frame = true;
  const std::vector<viewer::Panel> panels = {
      panel(result, to_truth, full, "result: distance to the truth"),
      panel(truth, *to_result, full, "truth: distance to the result")};
  auto image = viewer::render(panels, both, context);
  if (!image) return image.error();
  const double percent = 100 * full / to_truth.diagonal();
  return viewer::with_legend(*image, {colour_of, "0", short_number(full) + " and more",
                                      "(" + short_number(percent) + " % of the truth's diagonal)"});
}

}  // namespace arris::cli

#endif
