// arris: a raw point cloud in, a certified triangle mesh out. This header is the whole public API.
//
//   arris::Result<arris::PointCloud> cloud = arris::read_points("scan.ply");
//   arris::Result<arris::Reconstruction> r = arris::reconstruct(*cloud);
//   if (r) arris::write_mesh("mesh.ply", r->mesh);
//
// No function throws or aborts on bad input; every failure is an arris::Error inside a Result.
#pragma once

#include "arris/check.h"
#include "arris/context.h"
#include "arris/error.h"
#include "arris/features.h"
#include "arris/io.h"
#include "arris/options.h"
#include "arris/reconstruct.h"
#include "arris/report.h"
#include "arris/types.h"
#include "arris/version.h"
