#include "feature/small_set.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>

#include "support/random.h"

namespace arris {
namespace {

using namespace test;

// Few values and many, so that it grows and slots collide; filled again after clear().
RC_GTEST_PROP(SmallSet, KnowsWhatWasInserted, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  SmallSet set;
  for (int filling = 0; filling < 5; ++filling) {
    std::set<Index> truth;
    const std::size_t range = *rc::gen::element<std::size_t>(3, 100, 5000, 4'000'000'000);
    const std::size_t stride = *rc::gen::element<std::size_t>(1, 256);
    const std::size_t count = *rc::gen::inRange<std::size_t>(0, 2000);
    for (std::size_t k = 0; k < count; ++k) {
      const auto i = static_cast<Index>(stride * random.below(range));
      RC_ASSERT(set.insert(i) == truth.insert(i).second);
    }
    set.clear();
  }
}

// Values are fresh where an index is new, whatever it held before clear().
RC_GTEST_PROP(SmallMap, KeepsWhatWasPutThere, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  SmallMap<std::uint64_t> map;
  for (int filling = 0; filling < 3; ++filling) {
    std::map<Index, std::uint64_t> truth;
    for (int k = 0; k < 1000; ++k) {
      const auto i = static_cast<Index>(random.below(300));
      RC_ASSERT(map[i] == truth[i]);
      map[i] = truth[i] = random.below(1000);
    }
    map.clear();
  }
}

}  // namespace
}  // namespace arris
