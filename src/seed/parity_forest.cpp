#include "seed/parity_forest.h"

#include <algorithm>

namespace arris {

ParityForest::ParityForest(std::size_t n) : link_(n) {
  for (std::size_t node = 0; node < n; ++node) link_[node] = static_cast<std::uint32_t>(node) << 1;
}

ParityForest::Root ParityForest::find(std::uint32_t node) noexcept {
  std::uint32_t parity = 0;
  while (link_[node] >> 1 != node) {
    const std::uint32_t up = link_[node] >> 1;
    link_[node] = link_[up] ^ (link_[node] & 1);  // the root's parity is 0
    parity ^= link_[node] & 1;
    node = link_[node] >> 1;
  }
  return {node, parity != 0};
}

bool ParityForest::join(std::uint32_t a, std::uint32_t b, bool opposite) noexcept {
  const Root ra = find(a), rb = find(b);
  const bool parity = opposite != (ra.opposite != rb.opposite);
  if (ra.node == rb.node) return !parity;
  link_[std::min(ra.node, rb.node)] = std::max(ra.node, rb.node) << 1 | (parity ? 1u : 0u);
  return true;
}

}  // namespace arris
