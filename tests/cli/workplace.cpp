#include "cli/workplace.h"

#include <stdlib.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace arris::test {
namespace {

namespace fs = std::filesystem;

fs::path fresh_directory() {
  std::string pattern = (fs::temp_directory_path() / "arris-test-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary directory");
  return pattern;
}

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

// The records of what was printed lie elsewhere, so that entries() sees only what arris left.
Workplace::Workplace() : directory_(fresh_directory()), records_(fresh_directory()) {}

Workplace::~Workplace() {
  std::error_code ignored;
  fs::remove_all(directory_, ignored);
  fs::remove_all(records_, ignored);
}

void Workplace::write(const std::string& name, const std::string& content) const {
  std::ofstream(path(name), std::ios::binary) << content;
}

std::string Workplace::read(const std::string& name) const {
  return content(path(name));
}

std::set<std::string> Workplace::entries() const {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory_))
    names.insert(entry.path().filename().string());
  return names;
}

Outcome Workplace::arris(const std::string& arguments, const std::string& before) const {
  return shell(before + " exec \"$ARRIS\" " + arguments);
}

Outcome Workplace::shell(const std::string& command) const {
  const fs::path out = records_ / "out", err = records_ / "err";
  const std::string line = "cd " + directory_.string() + " && ARRIS='" ARRIS_COMMAND "'; ( " +
                           command + " ) </dev/null >" + out.string() + " 2>" + err.string();
  const int status = std::system(line.c_str());
  Outcome outcome;
  outcome.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  outcome.out = content(out);
  outcome.err = content(err);
  return outcome;
}

PrintedError printed_error(const std::string& err) {
  const std::string head = "arris: ", middle = "\n  remedy: ";
  const std::size_t split = err.find(middle);
  if (!err.starts_with(head) || split == err.npos || !err.ends_with('\n')) return {};
  const std::size_t begin = split + middle.size();
  if (err.find('\n', begin) != err.size() - 1) return {};
  return {err.substr(head.size(), split - head.size()), err.substr(begin, err.size() - 1 - begin)};
}

bool matches(const std::string& text, const std::string& pattern) {
  if (!pattern.ends_with("...")) return text == pattern;
  return text.starts_with(pattern.substr(0, pattern.size() - 3));
}

std::string sphere_xyz(int n, double offset) {
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  std::string text;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z), a = golden_angle * i;
    char line[96];
    std::snprintf(line, sizeof line, "%.9f %.9f %.9f\n", offset + r * std::cos(a),
                  offset + r * std::sin(a), offset + z);
    text += line;
  }
  return text;
}

}  // namespace arris::test
