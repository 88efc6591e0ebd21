// The coloured error map as a picture.
#pragma once

#include "arris/context.h"
#include "arris/error.h"
#include "arris/types.h"
#include "compare/error_map.h"
#include "viewer/image.h"
#include "viewer/render.h"

namespace arris::cli {

// The result coloured by the distance to the truth beside the truth coloured by the distance to the
// result, in one frame, with a legend. `full` is the distance of the last colour, user's unit.
Result<viewer::Image> error_picture(const Mesh& result, const Mesh& truth,
                                    const compare::DistanceToMesh& to_truth, double full,
                                    const viewer::View& view, const Context& context);

}  // namespace arris::cli
