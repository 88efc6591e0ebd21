#include "seed/parity_forest.h"

#include <numeric>
#include <utility>

namespace arris {

ParityForest::ParityForest(std::size_t n) : parent_(n), size_(n, 1), parity_(n, 0) {
  std::iota(parent_.begin(), parent_.end(), 0u);
}

ParityForest::Root ParityForest::find(std::uint32_t node) noexcept {
  std::uint8_t parity = 0;
  while (parent_[node] != node) {
    const std::uint32_t up = parent_[node];
    parity_[node] ^= parity_[up];  // the root's parity is 0
    parent_[node] = parent_[up];
    parity ^= parity_[node];
    node = parent_[node];
  }
  return {node, parity != 0};
}

bool ParityForest::join(std::uint32_t a, std::uint32_t b, bool opposite) noexcept {
  Root ra = find(a), rb = find(b);
  const bool parity = opposite != (ra.opposite != rb.opposite);
  if (ra.node == rb.node) return !parity;
  if (size_[ra.node] < size_[rb.node]) std::swap(ra, rb);
  parent_[rb.node] = ra.node;
  parity_[rb.node] = parity;
  size_[ra.node] += size_[rb.node];
  return true;
}

}  // namespace arris
