#include "seed/transfer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/known_solids.h"
#include "tetra/background.h"
#include "tetra/locate.h"

namespace arris {
namespace {

using namespace test;

// Coarse labels by formula, carried to a mesh with background points.
struct Carried {
  Measured coarse;
  Labels labels;
  TetMesh fine;
  Seeds given, seeds;

  explicit Carried(const KnownSolid& solid, unsigned threads = 1) : coarse(solid.samples) {
    OneStageJob job(threads);
    const std::size_t n = solid.samples.size();
    labels.assign(coarse.mesh.size(), 0);
    for (Tet t = 0; t < coarse.mesh.finite; ++t)
      labels[t] = solid.distance(centroid_of(coarse.mesh, t)) < 0;
    const Background background =
        background_points(solid.samples, coarse.spacing, LocalFrame{}, 10, job);
    std::vector<Vec3> points = solid.samples;
    points.insert(points.end(), background.points.begin(), background.points.end());
    fine = delaunay(points, n, job);
    fine.nearest = nearest_samples(n, background);
    given = find_seeds(coarse.mesh, coarse.stars, coarse.balls, coarse.spacing, job);
    seeds = transfer_seeds(coarse.mesh, labels, given, fine, job);
  }
};

TEST(TransferSeeds, EveryTetrahedronGetsALabelAndFirmOnesAreRight) {
  for (const KnownSolid& solid : known_solids(600)) {
    const Carried c(solid);
    std::size_t firm = 0;
    ASSERT_EQ(c.seeds.label.size(), c.fine.finite);
    ASSERT_EQ(c.seeds.firm.size(), c.fine.finite);
    for (Tet t = 0; t < c.fine.finite; ++t) {
      EXPECT_NE(c.seeds.label[t], seed_free);
      if (!c.seeds.firm[t]) continue;
      ++firm;
      const double d = solid.distance(centroid_of(c.fine, t));
      const double h = c.coarse.spacing[c.fine.nearest_sample(c.fine.vertices[t][0])];
      if (std::abs(d) < 0.25 * h) continue;
      EXPECT_EQ(c.seeds.label[t], d < 0 ? seed_inside : seed_outside) << solid.name << " " << d;
    }
    EXPECT_GT(firm, c.fine.finite / 10) << solid.name;
  }
}

TEST(TransferSeeds, ConfidenceIsCarried) {
  const Carried c(known_solids(600)[2]);
  EXPECT_EQ(c.seeds.confidence, c.given.confidence);
  EXPECT_EQ(c.seeds.contradiction, c.given.contradiction);
}

TEST(TransferSeeds, DoNotDependOnThreads) {
  const KnownSolid torus = known_solids(600)[2];
  const Carried one(torus, 1), three(torus, 3);
  EXPECT_EQ(one.seeds.label, three.seeds.label);
  EXPECT_EQ(one.seeds.firm, three.seeds.firm);
}

// Nothing else is known of any tetrahedron.
std::vector<Seed> untold(const TetMesh& mesh) {
  return std::vector<Seed>(mesh.finite, seed_free);
}

// With one point more: the middle between sample 0 and `other`.
struct OneAdded {
  const Carried& carried;
  Extension extension;
  std::vector<double> spacing;

  OneAdded(const Carried& c, Vec3 other) : carried(c), spacing(c.coarse.spacing) {
    OneStageJob job;
    extension = add_points(c.coarse.mesh, {0.5 * (c.coarse.mesh.points[0] + other)}, {0}, job);
    spacing.push_back(spacing[0]);
  }

  Seeds follow(const std::vector<std::uint8_t>& settled, const std::vector<Seed>& told) const {
    OneStageJob job;
    return follow_seeds(carried.coarse.mesh, carried.labels, carried.given, extension.mesh,
                        extension.former, {0}, spacing, settled, told, job);
  }
};

// Points added on the surface of a known solid: what is well inside or outside keeps its label.
TEST(FollowSeeds, LabelsAreThoseOfThePlace) {
  for (const KnownSolid& solid : known_solids(600)) {
    const Carried c(solid);
    std::vector<Vec3> added;
    std::vector<double> spacing = c.coarse.spacing;
    std::vector<Index> near;
    for (Index v = 0; v + 1 < solid.samples.size(); v += 7) {
      const Tet t = c.coarse.stars[v][0];
      Vec3 middle;  // of an edge, which is near the surface or in its hull
      for (Index w : c.coarse.mesh.vertices[t])
        if (w != v && w < solid.samples.size())
          middle = 0.5 * (solid.samples[v] + solid.samples[w]);
      added.push_back(middle);
      near.push_back(v);
      spacing.push_back(c.coarse.spacing[v]);
    }
    OneStageJob job;
    const auto [fine, former] = add_points(c.coarse.mesh, added, near, job);
    const Seeds seeds = follow_seeds(c.coarse.mesh, c.labels, c.given, fine, former, near, spacing,
                                     std::vector<std::uint8_t>(fine.size(), 0), untold(fine), job);
    EXPECT_EQ(seeds.confidence, c.given.confidence);
    ASSERT_EQ(seeds.label.size(), fine.finite);
    std::size_t deep = 0, wrong = 0;
    for (Tet t = 0; t < fine.finite; ++t) {
      if (seeds.firm[t]) {
        EXPECT_NE(seeds.label[t], seed_free);
      }
      const double d = solid.distance(centroid_of(fine, t));
      if (seeds.label[t] == seed_free || std::abs(d) < 0.5 * mean_spacing(fine, spacing, t))
        continue;
      ++deep;
      wrong += seeds.label[t] != (d < 0 ? seed_inside : seed_outside);
    }
    EXPECT_GT(deep, 100u) << solid.name;
    EXPECT_EQ(wrong, 0u) << solid.name << " of " << deep;
  }
}

TEST(FollowSeeds, SettledTetrahedraAreFirm) {
  const Carried c(known_solids(600)[2]);
  const OneAdded grown(c, c.coarse.mesh.points[1]);
  const auto& [fine, former] = grown.extension;
  std::vector<std::uint8_t> settled(fine.size(), 0);
  for (Tet t = 0; t < fine.finite; t += 2) settled[t] = former[t] != no_tet;
  const Seeds seeds = grown.follow(settled, untold(fine));
  std::size_t soft = 0;
  for (Tet t = 0; t < fine.finite; ++t) {
    soft += !seeds.firm[t];
    if (!settled[t]) continue;
    EXPECT_TRUE(seeds.firm[t]);
    EXPECT_EQ(seeds.label[t], c.labels[former[t]]);
  }
  EXPECT_GT(soft, 100u);
}

// What is told is firm, against the label before, but for slivers and what is settled.
TEST(FollowSeeds, TakeWhatIsTold) {
  const Carried c(known_solids(600)[2]);
  const OneAdded grown(c, c.coarse.mesh.points[1]);
  const auto& [fine, former] = grown.extension;
  const std::vector<std::uint8_t> settled(fine.size(), 0);
  std::vector<Seed> told = untold(fine);
  for (Tet t = 0; t < fine.finite; t += 3)
    if (former[t] != no_tet) told[t] = !c.labels[former[t]];
  const Seeds seeds = grown.follow(settled, told);
  std::size_t taken = 0, all = 0;
  for (Tet t = 0; t < fine.finite; ++t) {
    if (told[t] == seed_free) continue;
    ++all;
    taken += seeds.firm[t] && seeds.label[t] == told[t];
  }
  EXPECT_GT(10 * taken, 9 * all);
}

// Where a point was added, and one facet beyond, the label of its place may be overruled.
TEST(FollowSeeds, AreHintsAtAddedPoints) {
  const Carried c(known_solids(600)[0]);
  const std::vector<Vec3>& samples = c.coarse.mesh.points;
  const Vec3 nearest = *std::min_element(samples.begin() + 1, samples.end(), [&](Vec3 a, Vec3 b) {
    return distance(a, samples[0]) < distance(b, samples[0]);
  });
  const OneAdded grown(c, nearest);
  const auto& [fine, former] = grown.extension;
  const std::uint8_t place =
      c.labels[locate(c.coarse.mesh, fine.points.back(), c.coarse.stars[0][0])];
  const Seeds seeds = grown.follow(std::vector<std::uint8_t>(fine.size(), 0), untold(fine));
  const TetMesh& mesh = fine;  // a structured binding cannot be captured
  const auto is_new = [&](Tet t) {
    const auto& corners = mesh.vertices[t];
    return mesh.is_finite(t) && std::count(corners.begin(), corners.end(), samples.size()) > 0;
  };
  std::size_t at = 0, beyond = 0, elsewhere = 0;
  for (Tet t = 0; t < mesh.finite; ++t) {
    const auto& round = mesh.neighbours[t];
    const bool near = std::any_of(round.begin(), round.end(), is_new);
    const bool flat =
        largest_base(mesh, t).height < sliver_height * mean_spacing(mesh, grown.spacing, t);
    (is_new(t) ? at : near ? beyond : elsewhere) += 1;
    const bool won = seeds.label[t] == place && (is_new(t) || near);
    EXPECT_TRUE(flat || seeds.label[t] == seed_free || seeds.hint[t] == won);
  }
  EXPECT_GT(at, 4u);
  EXPECT_GT(beyond, 4u);
  EXPECT_GT(elsewhere, 100u);
}

}  // namespace
}  // namespace arris
