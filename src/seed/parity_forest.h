// Union-find with parity: a set of statements "a and b are on the same / on opposite sides", each
// accepted or refused against those accepted before.
#pragma once

#include <cstdint>
#include <vector>

namespace arris {

// Path halving with parities, union by index. O(log n) a call amortized, in practice near-constant;
// 4 bytes a node, of which there are at most 2^31.
class ParityForest {
 public:
  explicit ParityForest(std::size_t n);

  struct Root {
    std::uint32_t node;
    bool opposite;  // to the side of the root
  };
  Root find(std::uint32_t node) noexcept;

  // Joins a and b with the given parity. False if they are joined already with the other parity.
  bool join(std::uint32_t a, std::uint32_t b, bool opposite) noexcept;

 private:
  std::vector<std::uint32_t> link_;  // twice the parent, plus one if it is on the other side
};

}  // namespace arris
