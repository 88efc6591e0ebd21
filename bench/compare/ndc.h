// The edge metric of the learning literature.
#pragma once

#include "base/job.h"
#include "compare/compare.h"
#include "compare/surface.h"

namespace arris::compare {

// Edge Chamfer distance and edge F1 as in the evaluation of Chen, Tagliasacchi, Funkhouser, Zhang,
// Neural Dual Contouring, ACM TOG 41(4), 2022 (first in Chen, Tagliasacchi, Zhang, BSP-Net, CVPR
// 2020): 100,000 points drawn on each surface, whatever CompareOptions::samples is, since the
// figure depends on their density. Throws Failure(cancelled).
NdcScore ndc_edges(const Surface& result, const Surface& truth, const CompareOptions& options,
                   Job& job);

}  // namespace arris::compare
