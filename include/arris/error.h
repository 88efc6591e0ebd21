// Typed errors, and Result<T>: either a value or an Error. Nothing here throws.
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace arris {

// What went wrong, for programs. The numbers are stable; the command uses them as exit codes.
enum class ErrorCode {
  usage = 2,          // an option out of range or contradictory
  unreadable = 3,     // a file is missing, unreadable, truncated or malformed
  unsupported = 4,    // a file type or property that arris does not read or write
  bad_points = 5,     // non-finite coordinates, or no points at all
  degenerate = 6,     // too few distinct points, or all in one plane: no volume
  no_surface = 7,     // the data do not bound a solid: the cut left nothing inside
  certificate = 8,    // the mesh failed a check; what and where is in the message
  out_of_memory = 9,  // the forecast or an allocation exceeds the memory limit
  unwritable = 10,    // the output could not be written or renamed; nothing was left behind
  cancelled = 11,     // the caller asked to stop
  internal = 12,      // a promise inside arris broke; please report it
};

// A failure. `message` is one sentence that names the file, line, point or option; `remedy` says
// what the user can do about it. Both are plain UTF-8 without a final full stop or newline.
struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;
  std::string remedy;
};

// The stable, lower-case name of a code, e.g. "bad_points".
const char* name(ErrorCode code) noexcept;

// Either a T or an Error. Dereferencing a failed Result is undefined, as with std::optional.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}
  Result(Error error) : error_(std::move(error)) {}

  explicit operator bool() const noexcept { return value_.has_value(); }
  T& operator*() noexcept { return *value_; }
  const T& operator*() const noexcept { return *value_; }
  T* operator->() noexcept { return &*value_; }
  const T* operator->() const noexcept { return &*value_; }
  const Error& error() const noexcept { return error_; }

 private:
  std::optional<T> value_;
  Error error_;
};

// A Result without a value: success, or an Error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)), ok_(false) {}

  explicit operator bool() const noexcept { return ok_; }
  const Error& error() const noexcept { return error_; }

 private:
  Error error_;
  bool ok_ = true;
};

}  // namespace arris
