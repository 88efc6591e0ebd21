// Sets and maps of indices that are filled and emptied again and again: what a walk has seen.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "arris/types.h"

namespace arris {

// Open addressing with linear probing. O(1) each; clear() too, by a stamp.
template <class Value>
class SmallMap {
 public:
  void clear() noexcept {
    ++stamp_;
    size_ = 0;
  }
  // The value of i; a fresh one if i is new. Good until the next call.
  Value& operator[](Index i) {
    if (4 * size_ >= 3 * slots_.size()) grow();
    Slot& s = slots_[place(i)];
    if (s.stamp != stamp_) {
      s = {i, stamp_, Value{}};
      ++size_;
    }
    return s.value;
  }

 private:
  struct Slot {
    Index index = no_index;
    std::uint64_t stamp = 0;  // of the filling that it belongs to
    Value value{};
  };
  // The slot that holds i, or the free one where it belongs.
  std::size_t place(Index i) const noexcept {
    const std::size_t mask = slots_.size() - 1;
    std::size_t s = (i * 0x9E3779B1u >> 16) & mask;
    while (slots_[s].stamp == stamp_ && slots_[s].index != i) s = (s + 1) & mask;
    return s;
  }
  void grow() {
    std::vector<Slot> before(2 * slots_.size());
    before.swap(slots_);
    for (const Slot& s : before)
      if (s.stamp == stamp_) slots_[place(s.index)] = s;
  }

  std::vector<Slot> slots_ = std::vector<Slot>(256);  // a power of two
  std::size_t size_ = 0;
  std::uint64_t stamp_ = 1;
};

class SmallSet {
 public:
  void clear() noexcept { holds_.clear(); }
  // Returns whether i is new.
  bool insert(Index i) { return !std::exchange(holds_[i], true); }

 private:
  SmallMap<bool> holds_;
};

}  // namespace arris
