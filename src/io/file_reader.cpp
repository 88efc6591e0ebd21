#include "io/file_reader.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "base/failure.h"
#include "io/source.h"
#include "io/text_scan.h"

namespace arris {

FileReader::FileReader(const std::string& path) : path_(path) {
  // Non-blocking, or opening a pipe without a writer would wait for ever.
  descriptor_ = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) fail_with_errno("cannot be opened");
  struct stat info {};
  const bool known = fstat(descriptor_, &info) == 0;
  const char* problem = !known                   ? "cannot be examined"
                        : S_ISDIR(info.st_mode)  ? "is a directory"
                        : !S_ISREG(info.st_mode) ? "is not a regular file"
                        : info.st_size == 0      ? "is empty"
                                                 : nullptr;
  if (problem) {
    close(descriptor_);
    throw Failure(ErrorCode::unreadable, "'" + path_ + "': " + problem,
                  "give the path of a file with points or a mesh in it");
  }
  size_ = static_cast<std::uint64_t>(info.st_size);
}

FileReader::~FileReader() {
  close(descriptor_);
}

std::string_view FileReader::load(Job& job) {
  constexpr std::uint64_t piece = std::uint64_t{8} << 20;  // bytes between two looks at `cancel`
  if (size_ > memory_limit(job.context()))
    throw Failure(
        ErrorCode::out_of_memory,
        "'" + path_ + "': its " + std::to_string(size_) + " bytes are more than the memory limit",
        "use a smaller file, or raise the memory limit");
  bytes_.reset(new char[size_]);  // left uninitialised: it is filled at once
  std::uint64_t have = 0;
  while (have < size_) {
    job.tick(static_cast<double>(have) / static_cast<double>(size_));
    const ssize_t got = read(descriptor_, bytes_.get() + have, std::min(piece, size_ - have));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_with_errno("cannot be read");
    if (got == 0) break;  // cut short since it was opened: the parser will say where
    have += static_cast<std::uint64_t>(got);
  }
  return {bytes_.get(), have};
}

void FileReader::fail_with_errno(const std::string& what) const {
  const int error = errno;
  const char* remedy = error == ENOENT || error == ENOTDIR ? "check the path"
                       : error == EACCES                   ? "ask for the permission to read it"
                                         : "check the path and the medium it is on";
  throw Failure(ErrorCode::unreadable,
                "'" + path_ + "': " + what + ": " + std::generic_category().message(error), remedy);
}

std::string extension_of(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

}  // namespace arris
