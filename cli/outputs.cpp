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

Error refusal(ErrorCode code, const std::string& path, const std::string& why,
              const std::string& remedy) {
  return {code, quoted(path) + ": " + why, remedy};
}

Result<void> check_extension(const Output& output) {
  if (output.extensions.empty()) return {};
  const std::string extension = fs::path(output.path).extension().string();
  std::string lower = extension;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto& known = output.extensions;
  if (std::find(known.begin(), known.end(), lower) != known.end()) return {};
  std::string list;
  for (const std::string& e : known) list += " " + e;
  return refusal(ErrorCode::unsupported, output.path,
                 output.what + " is not written to files with the extension " + quoted(extension),
                 "use one of" + list);
}

Result<void> check_place(const std::string& path) {
  const auto refuse = [&](const std::string& why, const std::string& remedy) {
    return refusal(ErrorCode::unwritable, path, why, remedy);
  };
  const char* const ask = "write elsewhere or ask for the permission";
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return refuse("is a directory", "give the path of a file in it");
  if (fs::exists(status) && access(path.c_str(), W_OK) != 0)
    return refuse(std::string("cannot be overwritten: ") + std::strerror(errno), ask);
  fs::path directory = fs::path(path).parent_path();
  if (directory.empty()) directory = ".";
  const std::string shown = quoted(directory.string());
  const fs::file_status place = fs::status(directory, error);
  if (!fs::exists(place))
    return refuse("the directory " + shown + " does not exist", "create the directory first");
  if (!fs::is_directory(place))
    return refuse(shown + " is not a directory", "name a directory that exists");
  // A new file replaces the old one, so the directory must be open even if the file is there.
  if (access(directory.c_str(), W_OK | X_OK) != 0)
    return refuse("the directory " + shown + " cannot be written to: " + std::strerror(errno), ask);
  return {};
}

}  // namespace

Result<void> check_outputs(const std::string& input, const std::vector<Output>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Output& output = outputs[i];
    if (output.path.empty()) continue;
    if (same_file(input, output.path))
      return refusal(ErrorCode::usage, output.path, output.what + " would overwrite the input",
                     "give it another name");
    for (std::size_t j = 0; j < i; ++j)
      if (!outputs[j].path.empty() && same_file(outputs[j].path, output.path))
        return refusal(ErrorCode::usage, output.path,
                       outputs[j].what + " and " + output.what + " would both be written to it",
                       "give one of them another name");
    if (Result<void> known = check_extension(output); !known) return known;
    if (Result<void> place = check_place(output.path); !place) return place;
  }
  return {};
}

}  // namespace arris::cli
