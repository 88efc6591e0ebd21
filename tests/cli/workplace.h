// A directory of its own for one test, in which the command is run.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace arris::test {

struct Outcome {
  int exit_code = -1;  // 128 + n if signal n ended the process
  std::string out, err;
};

// Made fresh, and removed with everything in it.
class Workplace {
 public:
  Workplace();
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  void write(const std::string& name, const std::string& content) const;
  std::string read(const std::string& name) const;
  std::filesystem::path path(const std::string& name) const { return directory_ / name; }
  std::set<std::string> entries() const;  // names, hidden ones too

  // Runs `before` and then "arris ARGUMENTS" by the shell in this directory. `before` is shell text
  // such as "ulimit -f 1;".
  Outcome arris(const std::string& arguments, const std::string& before = "") const;
  // The same for any shell command, in which $ARRIS is the command.
  Outcome shell(const std::string& command) const;

 private:
  std::filesystem::path directory_, records_;
};

// What the command prints for an error: "arris: MESSAGE", then "  remedy: REMEDY".
struct PrintedError {
  std::string message, remedy;
};

// Takes the text of standard error apart; both are empty unless it is exactly one printed error.
PrintedError printed_error(const std::string& err);

// True if `text` is `pattern`, or starts with it up to a final "...".
bool matches(const std::string& text, const std::string& pattern);

// n points of a sphere of radius 1 as text, a spiral: evenly spread and in general position. The
// centre is at (offset, offset, offset).
std::string sphere_xyz(int n, double offset = 0);

}  // namespace arris::test
