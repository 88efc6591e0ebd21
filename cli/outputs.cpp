#include "outputs.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "text.h"

namespace arris::cli {
namespace {

namespace fs = std::filesystem;

// The two paths name one file, whether it exists yet or not.
bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const fs::path first = fs::weakly_canonical(a, error);
  if (error) return a == b;
  const fs::path second = fs::weakly_canonical(b, error);
  return error ? a == b : first == second;
}

Result<void> check_extension(const Output& output) {
  if (output.extensions.empty()) return {};
  std::string extension = fs::path(output.path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto& known = output.extensions;
  if (std::find(known.begin(), known.end(), extension) != known.end()) return {};
  std::string list;
  for (const std::string& e : known) list += " " + e;
  return Error{ErrorCode::unsupported,
               "cannot write the " + output.what + " to " + quoted(output.path) +
                   ": its extension is not one of" + list,
               "give it a name such as " + output.what + known.front()};
}

Result<void> check_place(const std::string& path) {
  const auto refusal = [&](const std::string& why, const std::string& remedy) {
    return Error{ErrorCode::unwritable, "cannot write " + quoted(path) + ": " + why, remedy};
  };
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return refusal("it is a directory", "name a file in it");
  if (fs::exists(status) && !fs::is_regular_file(status))
    return refusal("it is not an ordinary file", "name an ordinary file");
  fs::path directory = fs::path(path).parent_path();
  if (directory.empty()) directory = ".";
  const std::string shown = quoted(directory.string());
  const fs::file_status place = fs::status(directory, error);
  if (!fs::exists(place))
    return refusal("the directory " + shown + " does not exist", "create it, or name another");
  if (!fs::is_directory(place))
    return refusal(shown + " is not a directory", "name a directory that exists");
  if (access(directory.c_str(), W_OK | X_OK) != 0)
    return refusal("the directory " + shown + " is closed to writing: " + std::strerror(errno),
                   "name a directory that you may write to");
  return {};
}

}  // namespace

Result<void> check_outputs(const std::string& input, const std::vector<Output>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Output& output = outputs[i];
    if (output.path.empty()) continue;
    if (same_file(input, output.path))
      return Error{ErrorCode::usage,
                   "the " + output.what + " " + quoted(output.path) + " would overwrite the input",
                   "give the output another name"};
    for (std::size_t j = 0; j < i; ++j)
      if (!outputs[j].path.empty() && same_file(outputs[j].path, output.path))
        return Error{ErrorCode::usage,
                     "the " + outputs[j].what + " and the " + output.what +
                         " would both be written to " + quoted(output.path),
                     "give one of them another name"};
    if (Result<void> known = check_extension(output); !known) return known;
    if (Result<void> place = check_place(output.path); !place) return place;
  }
  return {};
}

}  // namespace arris::cli
