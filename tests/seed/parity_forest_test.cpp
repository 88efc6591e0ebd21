#include "seed/parity_forest.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <optional>
#include <tuple>
#include <vector>

namespace arris {
namespace {

using Statement = std::tuple<std::uint32_t, std::uint32_t, bool>;

// The side of each node with the first node of its component on side 0, by repeated relaxation;
// nothing if the statements contradict each other.
std::optional<std::vector<int>> two_colouring(std::size_t n, const std::vector<Statement>& all) {
  std::vector<int> side(n, -1);
  for (std::size_t first = 0; first < n; ++first) {
    if (side[first] >= 0) continue;
    side[first] = 0;
    for (bool grown = true; grown;) {
      grown = false;
      for (auto [a, b, opposite] : all) {
        if (side[a] < 0) std::swap(a, b);
        if (side[a] < 0) continue;
        const int wanted = side[a] ^ static_cast<int>(opposite);
        if (side[b] >= 0 && side[b] != wanted) return {};
        grown |= side[b] < 0;
        side[b] = wanted;
      }
    }
  }
  return side;
}

RC_GTEST_PROP(ParityForest, AcceptsWhatCanBeColoured, ()) {
  const auto n = *rc::gen::inRange<std::uint32_t>(1, 30);
  const auto node = rc::gen::inRange<std::uint32_t>(0, n);
  const auto statements = *rc::gen::container<std::vector<Statement>>(
      rc::gen::tuple(node, node, rc::gen::arbitrary<bool>()));
  ParityForest forest(n);
  std::vector<Statement> accepted;
  for (const Statement& s : statements) {
    accepted.push_back(s);
    const bool possible = two_colouring(n, accepted).has_value();
    RC_ASSERT(forest.join(std::get<0>(s), std::get<1>(s), std::get<2>(s)) == possible);
    if (!possible) accepted.pop_back();
  }
  const std::vector<int> side = *two_colouring(n, accepted);
  for (std::uint32_t a = 0; a < n; ++a) {
    std::vector<Statement> more = accepted;  // joined to 0 exactly if one parity is impossible
    more.push_back({0, a, true});
    const bool can_differ = two_colouring(n, more).has_value();
    std::get<2>(more.back()) = false;
    const bool can_agree = two_colouring(n, more).has_value();
    const ParityForest::Root zero = forest.find(0), root = forest.find(a);
    RC_ASSERT((zero.node == root.node) == !(can_differ && can_agree));
    if (zero.node == root.node) RC_ASSERT((zero.opposite != root.opposite) == (side[0] != side[a]));
  }
}

}  // namespace
}  // namespace arris
