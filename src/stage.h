// What the steps of the pipeline hand to each other: tetrahedra, what is known of them, the energy.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "arris/options.h"
#include "arris/report.h"
#include "base/job.h"
#include "cloud/prepare.h"
#include "cut/surface_cut.h"
#include "energy/model.h"
#include "feature/candidates.h"
#include "seed/seeds.h"
#include "tetra/stars.h"
#include "tetra/tet_mesh.h"

namespace arris {

struct Stage {
  TetMesh mesh;
  Stars stars;
  Seeds seeds;
  EnergyModel model;
  // Per tetrahedron: 1 where it lies far from every feature point and was swapped already; or
  // empty.
  std::vector<std::uint8_t> settled;
  double roughness = 0;  // by which samples lie off the surface, as a length
};

// Cut, and the manifold next to it, without specks.
SurfaceCut cut_manifold(const Stage& stage, const std::vector<double>& curvature, Report& report,
                        Job& job);

// Frees the stars and the labels of the seeds, which nothing asks for once the surface is cut.
void forget_evidence(Stage& stage);

struct Topology {
  std::size_t components;
  std::int64_t euler;
  bool operator==(const Topology&) const = default;
};

// Of the boundary of the labels, which must be a 2-manifold.
Topology topology_of(const TetMesh& mesh, const Labels& labels);

// Joins the stumps of parts whose sides are missing all round (cut/join.h) where that makes tubes
// of them and nothing else. Every point of the stage must be a sample.
void join_parts(const Stage& stage, Labels& labels, Report& report, Job& job);

void run_swaps(const Stage& stage, Labels& labels, Report& report, Job& job);

// Adds the feature points that the surface of `labels` lets sense to `features`; returns the stage
// that has them among its points, or nothing (no points) if there is none to add. Points
// [samples ..) of a stage are the features, where the user's frame can hold them exactly. Across
// gaps none is added near a `refused` one.
Stage add_features(const Stage& stage, const Labels& labels, const Samples& samples,
                   const std::vector<FeaturePoint>& refused, std::vector<FeaturePoint>& features,
                   Job& job);

// What it takes to keep features across gaps from changing the topology. `next` has
// features[known ..) added to `stage`, `cut` is its surface. If that has another Euler
// characteristic than the surface of `labels`, adds those across gaps to `refused` that are off the
// new surface or that it does not follow the planes at; all of them if there is none such, or if
// some have been refused before. Returns whether it added any: then the round should be done again.
bool refuse_features(const Stage& stage, const Labels& labels, const Stage& next, const Labels& cut,
                     const std::vector<FeaturePoint>& features, std::size_t known,
                     std::vector<FeaturePoint>& refused);

}  // namespace arris
