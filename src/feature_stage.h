// The step of the pipeline that puts points on features that no sample marks.
#pragma once

#include <vector>

#include "feature/candidates.h"
#include "stage.h"

namespace arris {

// One round: adds the feature points that the surface of `labels` lets sense to the stage and to
// `features`, and cuts anew. Points [samples ..) of a stage are the features, where the user's
// frame can hold them exactly. Points are taken back where the new surface has a handle that the
// former has not; those across gaps, too, where the topology is another in any way. Returns whether
// any were added; else all is as it was.
bool add_features(const Samples& samples, Stage& stage, Labels& labels,
                  std::vector<FeaturePoint>& features, Report& report, Job& job);

}  // namespace arris
