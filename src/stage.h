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
#include "seed/seeds.h"
#include "surface/handles.h"
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

bool has_inside(const Labels& labels);

// Frees the stars and the labels of the seeds, which nothing asks for once the surface is cut.
void forget_evidence(Stage& stage);

// Of the boundary of the labels, which must be a 2-manifold.
Topology topology_of(const TetMesh& mesh, const Labels& labels);

// Makes a manifold of changed labels, without specks.
void remanifold(const Stage& stage, Labels& labels, Report& report, Job& job);

// Joins the stumps of parts whose sides are missing all round (cut/join.h) where that makes tubes
// of them and nothing else. Every point of the stage must be a sample.
void join_parts(const Stage& stage, Labels& labels, Report& report, Job& job);

void run_swaps(const Stage& stage, Labels& labels, Report& report, Job& job);

}  // namespace arris
