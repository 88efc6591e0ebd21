// A file brought into memory. Read, not mapped: a file that another program cuts short while arris
// reads it must be an error, not a bus fault.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/job.h"

namespace arris {

class FileReader {
 public:
  // Opens `path`, a regular file that is not empty. Throws unreadable.
  explicit FileReader(const std::string& path);
  ~FileReader();
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;

  // Reads the whole file; the view lives as long as the reader. Throws unreadable, out_of_memory
  // (larger than the memory limit) or cancelled.
  std::string_view load(Job& job);

 private:
  [[noreturn]] void fail_with_errno(const std::string& what) const;

  std::string path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::unique_ptr<char[]> bytes_;
};

// The extension of `path` in lower case with its dot, e.g. ".ply"; empty if there is none.
std::string extension_of(const std::string& path);

}  // namespace arris
