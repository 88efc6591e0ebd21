// Cut problems like those of the pipeline, from surfaces whose inside is known.
#pragma once

#include <string>

#include "cut/contract.h"

namespace arris {

enum class Shape { bumpy_sphere, torus, box_with_holes };
enum class Flaw { none, noise, outliers };
// hard: tetrahedra above the spacing are seeds. sparse: only those far above it, so more are free.
// soft: only the infinite ones are, and all others have a noisy preference.
enum class Terminals { hard, sparse, soft };

struct Scene {
  Shape shape = Shape::bumpy_sphere;
  Flaw flaw = Flaw::none;
  Terminals terminals = Terminals::hard;
};

std::string name(const Scene& scene);

struct SceneCut {
  TetMesh mesh;
  CutProblem problem;
};

// Samples the surface, tetrahedralizes, and weighs facets by mean distance x area.
SceneCut make_scene(const Scene& scene, std::size_t samples, Job& job);

}  // namespace arris
