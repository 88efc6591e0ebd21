#include "seed/recount.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/known_solids.h"

namespace arris {
namespace {

using namespace test;

Votes votes_of(const Measured& m) {
  OneStageJob job;
  return collect_votes(m.mesh, m.stars, m.balls, m.spacing, job);
}

Seeds seeds_of(const Measured& m) {
  OneStageJob job;
  return find_seeds(m.mesh, m.stars, m.balls, m.spacing, job);
}

// Strength of all votes that these labels refuse.
int refused(const TetMesh& mesh, const Votes& votes, const std::vector<Seed>& label) {
  const auto at = [&](Tet t) { return t != no_tet && mesh.is_finite(t) ? label[t] : seed_outside; };
  int sum = 0;
  const auto add = [&](Tet a, Tet b, std::uint8_t packed) {
    const Vote vote = Votes::unpack(packed);
    if (at(a) == seed_free || at(b) == seed_free) return;
    if ((at(a) != at(b)) != vote.opposite) sum += vote.strength;
  };
  for (Tet t = 0; t < mesh.finite; ++t)
    for (std::size_t i = 0; i < 4; ++i) add(t, mesh.neighbours[t][i], votes.facet[4 * t + i]);
  for (std::size_t v = 0; v < votes.pole.size(); ++v)
    if (votes.pole[v] != 0) add(votes.pole_pair[v][0], votes.pole_pair[v][1], votes.pole[v]);
  return sum;
}

void turn(Seed& label) {
  if (label != seed_free) label = label == seed_inside ? seed_outside : seed_inside;
}

TEST(Recount, LeavesWhatTheVotesAgreeOn) {
  for (const KnownSolid& solid : known_solids(2000)) {
    const Measured m(solid.samples);
    const Seeds seeds = seeds_of(m);
    std::vector<Seed> label = seeds.label;
    EXPECT_EQ(recount_votes(m.mesh, votes_of(m), seeds.firm, label), 0u) << solid.name;
    EXPECT_EQ(label, seeds.label) << solid.name;
  }
}

// The end of a bar that went to the wrong side, as where the samples lack a ring round it.
TEST(Recount, TurnsTheEndOfABarBack) {
  const Mesh bar = box_complex({{{0, 0, 0}, {4, 0.6, 0.6}}});
  for (const double from : {2.0, 3.0, 3.5}) {
    SCOPED_TRACE(from);
    const Measured m(sample_blue(bar, 1500, 1));
    const Seeds seeds = seeds_of(m);
    std::vector<Seed> label = seeds.label;
    std::size_t wrong = 0;
    for (Tet t = 0; t < m.mesh.finite; ++t)
      if (label[t] == seed_inside && centroid_of(m.mesh, t).x > from) {
        label[t] = seed_outside;
        ++wrong;
      }
    EXPECT_GT(wrong, 100u);
    EXPECT_GE(recount_votes(m.mesh, votes_of(m), seeds.firm, label), wrong * 9 / 10);
    std::size_t left = 0;
    for (Tet t = 0; t < m.mesh.finite; ++t) left += label[t] != seeds.label[t];
    EXPECT_LE(left, wrong / 10);
  }
}

RC_GTEST_PROP(Recount, RefusesLessThanBeforeAndLeavesTheFreeFree, ()) {
  static const Measured m(known_solids(800)[0].samples);
  static const Seeds seeds = seeds_of(m);
  static const Votes votes = votes_of(m);
  std::vector<Seed> label = seeds.label;
  const auto step = *rc::gen::inRange<std::size_t>(2, 60);
  for (std::size_t t = *rc::gen::inRange<std::size_t>(0, 60); t < label.size(); t += step)
    *rc::gen::arbitrary<bool>() ? turn(label[t]) : void(label[t] = seed_free);
  const std::vector<Seed> given = label;
  const std::size_t turned = recount_votes(m.mesh, votes, seeds.firm, label);
  const int before = refused(m.mesh, votes, given), after = refused(m.mesh, votes, label);
  const int least = turned == 0 ? 0 : 4 * (Votes::levels - 2);
  RC_ASSERT(after <= before - least);
  for (std::size_t t = 0; t < label.size(); ++t)
    RC_ASSERT((label[t] == seed_free) == (given[t] == seed_free));
}

}  // namespace
}  // namespace arris
