// Tables of commands that are refused: each ends with its exit code, prints one error and no
// result, and leaves the files of its workplace as they were.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "cli/workplace.h"

namespace arris::test {

struct Refusal {
  const char* name;
  const char* arguments;
  int exit_code;
  const char* message;  // exact, or a beginning that ends with "..."
};

inline void PrintTo(const Refusal& row, std::ostream* out) {
  *out << row.name;
}

// For INSTANTIATE_TEST_SUITE_P.
inline std::string name_of(const testing::TestParamInfo<Refusal>& info) {
  return info.param.name;
}

// Runs "arris COMMAND ARGUMENTS".
inline void expect_refused(const Workplace& place, const std::string& command, const Refusal& row) {
  const auto before = place.entries();
  const Outcome outcome = place.arris(command + " " + row.arguments);
  EXPECT_EQ(outcome.exit_code, row.exit_code) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const PrintedError error = printed_error(outcome.err);
  EXPECT_TRUE(matches(error.message, row.message)) << outcome.err;
  EXPECT_NE(error.remedy, "") << outcome.err;
  EXPECT_EQ(place.entries(), before);
}

}  // namespace arris::test
