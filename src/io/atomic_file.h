// A file that appears whole or not at all: written beside its target, then renamed over it.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/format_number.h"

namespace arris {

// Every call throws unwritable, with the reason of the system. The destructor removes the temporary
// unless commit() has succeeded, so that neither an error nor a cancelled job leaves one behind. A
// target that is a device or a pipe (/dev/stdout) is written directly.
class AtomicFile {
 public:
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void text(std::string_view text) {
    buffer_.append(text);
    if (buffer_.size() >= buffer_limit_) flush();
  }
  // The shortest digits that read back as the same value.
  template <class Number>
  void number(Number value) {
    NumberBuffer digits;
    text(format_number(value, digits));
  }
  // The bytes of an integer, float or double, little end first.
  template <class T>
  void binary(T value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    text({bytes.data(), bytes.size()});
  }

  // Makes the target the new file, on the disk as well.
  void commit();

 private:
  void open_temporary();
  void open_special();
  void flush();
  [[noreturn]] void fail_with_errno(const std::string& what);
  void discard() noexcept;

  static constexpr std::size_t buffer_limit_ = std::size_t{1} << 20;
  std::string path_;       // as the user gave it
  std::string target_;     // what is renamed over: path_ with its symbolic links resolved
  std::string temporary_;  // empty: the target is written directly
  std::string buffer_;
  int descriptor_ = -1;
};

}  // namespace arris
