#include "seed/seeds.h"

#include <array>
#include <numeric>

#include "seed/parity_forest.h"
#include "seed/recount.h"
#include "seed/votes.h"

namespace arris {
namespace {

// A vote by number: 4 t + i for the facet, 4 * finite + v for the poles of sample v.
struct Ballot {
  const TetMesh& mesh;
  const Votes& votes;

  std::size_t size() const { return votes.facet.size() + votes.pole.size(); }
  std::uint8_t packed(std::size_t id) const {
    return id < votes.facet.size() ? votes.facet[id] : votes.pole[id - votes.facet.size()];
  }
  // The outside is one node, numbered `finite`.
  std::array<std::uint32_t, 2> ends(std::size_t id) const {
    const auto node = [&](Tet t) {
      return t != no_tet && mesh.is_finite(t) ? t : static_cast<Tet>(mesh.finite);
    };
    if (id < votes.facet.size())
      return {static_cast<Tet>(id / 4), node(mesh.neighbours[id / 4][id % 4])};
    const auto& pair = votes.pole_pair[id - votes.facet.size()];
    return {node(pair[0]), node(pair[1])};
  }
};

// Ids of all votes, strongest first, by counting sort; within a level in the order of the mesh,
// which keeps the union-find in cache.
std::vector<std::uint32_t> strongest_first(const Ballot& ballot) {
  std::array<std::size_t, Votes::levels + 1> start{};
  const auto rank = [&](std::size_t id) {
    return static_cast<std::size_t>(Votes::levels - 1 - Votes::unpack(ballot.packed(id)).strength);
  };
  for (std::size_t id = 0; id < ballot.size(); ++id) ++start[rank(id) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  const std::size_t votes = start[Votes::levels - 1];  // the last rank is "no vote"
  std::vector<std::uint32_t> order(votes);
  for (std::size_t id = 0; id < ballot.size(); ++id)
    if (ballot.packed(id) != 0 && rank(id) < Votes::levels - 1)
      order[start[rank(id)]++] = static_cast<std::uint32_t>(id);
  return order;
}

// Strength for the forest and in all, summed over the votes round each sample and over the cloud.
// Sums of small integers: exact in any order.
struct Tally {
  std::vector<float> agree, all;
  double refused = 0, total = 0;
};

void count_vote(const Ballot& ballot, std::size_t id, bool agrees, Tally& tally) {
  const auto strength = static_cast<float>(Votes::unpack(ballot.packed(id)).strength);
  tally.total += strength;
  if (!agrees) tally.refused += strength;
  const auto add = [&](Index v) {
    if (v >= ballot.mesh.samples) return;
    tally.all[v] += strength;
    if (agrees) tally.agree[v] += strength;
  };
  if (id >= ballot.votes.facet.size())
    return add(static_cast<Index>(id - ballot.votes.facet.size()));
  for (int corner : facet_corners[id % 4])
    add(ballot.mesh.vertices[id / 4][static_cast<std::size_t>(corner)]);
}

// The ends of every vote are joined by now: it was accepted if the forest says the same.
Tally count_votes(const Ballot& ballot, ParityForest& forest) {
  const std::size_t samples = ballot.mesh.samples;
  Tally tally{std::vector<float>(samples, 0), std::vector<float>(samples, 0)};
  for (std::size_t id = 0; id < ballot.size(); ++id) {
    const Vote vote = Votes::unpack(ballot.packed(id));
    if (vote.strength == 0) continue;
    const auto [a, b] = ballot.ends(id);
    const bool opposite = forest.find(a).opposite != forest.find(b).opposite;
    count_vote(ballot, id, opposite == vote.opposite, tally);
  }
  return tally;
}

}  // namespace

Seeds find_seeds(const TetMesh& mesh, const Stars& stars, const std::vector<Circumball>& balls,
                 const std::vector<double>& spacing, Job& job) {
  const Votes votes = collect_votes(mesh, stars, balls, spacing, job);
  const Ballot ballot{mesh, votes};
  const std::vector<std::uint32_t> order = strongest_first(ballot);

  ParityForest forest(mesh.finite + 1);
  constexpr std::size_t between_ticks = 1 << 16;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k % between_ticks == 0)
      job.tick(static_cast<double>(k) / static_cast<double>(order.size()));
    const Vote vote = Votes::unpack(ballot.packed(order[k]));
    const auto [a, b] = ballot.ends(order[k]);
    forest.join(a, b, vote.opposite);
  }
  const Tally tally = count_votes(ballot, forest);

  Seeds seeds;
  seeds.contradiction = tally.total > 0 ? tally.refused / tally.total : 0;
  const auto outside = forest.find(static_cast<std::uint32_t>(mesh.finite));
  seeds.label.resize(mesh.finite);
  seeds.firm.resize(mesh.finite);
  for (std::size_t t = 0; t < mesh.finite; ++t) {
    seeds.firm[t] =
        balls[t].radius > firm_radius * mean_spacing(mesh, spacing, static_cast<Tet>(t));
    const auto root = forest.find(static_cast<std::uint32_t>(t));
    seeds.label[t] = root.node != outside.node           ? seed_free
                     : root.opposite != outside.opposite ? seed_inside
                                                         : seed_outside;
  }
  recount_votes(mesh, votes, seeds.firm, seeds.label);
  seeds.confidence.resize(mesh.samples);
  for (std::size_t v = 0; v < mesh.samples; ++v)
    seeds.confidence[v] = tally.all[v] > 0 ? tally.agree[v] / tally.all[v] : 0;
  return seeds;
}

}  // namespace arris
