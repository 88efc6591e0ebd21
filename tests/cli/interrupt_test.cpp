// Signals: the command ends soon with exit code 130 and leaves no file.
#include <gtest/gtest.h>

#include <string>

#include "cli/workplace.h"

namespace arris::test {
namespace {

// Enough points that the work takes seconds; the signal comes as soon as the first progress line
// shows that it has begun.
Outcome interrupted(const Workplace& place, const std::string& signal) {
  place.write("in.xyz", sphere_xyz(150000));
  return place.shell(
      "\"$ARRIS\" reconstruct in.xyz -o out.ply --report r.json 2>progress & "
      "for i in $(seq 600); do [ -s progress ] && break; sleep 0.05; done; "
      "kill -" +
      signal +
      " $!; wait $!; status=$?; tail -n 2 progress >&2; rm progress; "
      "exit $status");
}

class Interrupt : public testing::TestWithParam<const char*> {};

TEST_P(Interrupt, LeavesNoFile) {
  const Workplace place;
  const Outcome outcome = interrupted(place, GetParam());
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(printed_error(outcome.err).message, "stopped on request") << outcome.err;
  EXPECT_EQ(place.entries(), std::set<std::string>{"in.xyz"});
}

// Not INT: a shell without job control makes its background processes ignore it.
INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values("TERM", "HUP"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Interrupt, ByCtrlC) {
  const Workplace place;
  place.write("in.xyz", sphere_xyz(150000));
  // timeout sends INT to a child that has not been told to ignore it.
  const Outcome outcome = place.shell(
      "timeout --preserve-status -s INT 0.3 \"$ARRIS\" reconstruct in.xyz -o out.ply --quiet");
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(printed_error(outcome.err).message, "stopped on request") << outcome.err;
  EXPECT_EQ(place.entries(), std::set<std::string>{"in.xyz"});
}

}  // namespace
}  // namespace arris::test
