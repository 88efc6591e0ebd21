#include "io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "base/failure.h"

namespace arris {
namespace {

std::string directory_of(const std::string& path) {
  const std::string directory = std::filesystem::path(path).parent_path().string();
  return directory.empty() ? "." : directory;
}

// The file that a symbolic link stands for; `path` itself if it is none, or leads nowhere.
std::string resolved(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  const std::filesystem::path target = std::filesystem::canonical(path, error);
  return error ? path : target.string();
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path), target_(resolved(path)) {
  struct stat info {};
  const bool exists = stat(target_.c_str(), &info) == 0;
  if (exists && S_ISDIR(info.st_mode)) {
    errno = EISDIR;
    fail_with_errno("cannot be written");
  }
  if (exists && !S_ISREG(info.st_mode)) {
    open_special();
    return;
  }
  if (exists && access(target_.c_str(), W_OK) != 0) fail_with_errno("cannot be overwritten");
  open_temporary();
  if (exists) fchmod(descriptor_, info.st_mode & 07777);  // a courtesy: failing does no harm
}

AtomicFile::~AtomicFile() {
  discard();
}

void AtomicFile::open_temporary() {
  // Not after the name of the target, which may be as long as the file system allows.
  const std::string stem = (std::filesystem::path(directory_of(target_)) / ".arris-").string() +
                           std::to_string(getpid());
  for (unsigned k = 0; descriptor_ < 0; ++k) {
    const std::string name = stem + "-" + std::to_string(k) + ".tmp";
    descriptor_ = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0)
      temporary_ = name;
    else if (errno != EEXIST)
      fail_with_errno("cannot be created");
  }
}

void AtomicFile::open_special() {
  // Non-blocking, or opening a pipe without a reader would wait for ever.
  descriptor_ = open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) fail_with_errno("cannot be opened");
  const int flags = fcntl(descriptor_, F_GETFL);
  if (flags >= 0) fcntl(descriptor_, F_SETFL, flags & ~O_NONBLOCK);
}

void AtomicFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t wrote = ::write(descriptor_, rest.data(), rest.size());
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) fail_with_errno("cannot be written");
    rest.remove_prefix(static_cast<std::size_t>(wrote));
  }
  buffer_.clear();
}

void AtomicFile::commit() {
  flush();
  if (temporary_.empty()) return;
  if (fsync(descriptor_) != 0) fail_with_errno("cannot be written");
  const int closed = close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) fail_with_errno("cannot be written");
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail_with_errno("cannot be replaced");
  temporary_.clear();
  // The new name outlives a power cut only with its directory. Not every file system can do that.
  const int directory = open(directory_of(target_).c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY);
  if (directory < 0) return;
  fsync(directory);
  close(directory);
}

void AtomicFile::fail_with_errno(const std::string& what) {
  const int error = errno;
  discard();  // a constructor that throws has no destructor
  const char* remedy = error == ENOSPC || error == EDQUOT || error == EFBIG
                           ? "free some space or write elsewhere"
                       : error == ENOENT || error == ENOTDIR ? "create the directory first"
                       : error == EISDIR                     ? "give the path of a file in it"
                                         : "write elsewhere or ask for the permission";
  throw Failure(ErrorCode::unwritable,
                "'" + path_ + "': " + what + ": " + std::generic_category().message(error), remedy);
}

void AtomicFile::discard() noexcept {
  if (descriptor_ >= 0) close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
  descriptor_ = -1;
  temporary_.clear();
}

}  // namespace arris
