// What every reader is given: the bytes of a whole file, its name for messages, and who listens.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "arris/error.h"
#include "base/job.h"

namespace arris {

struct Source {
  std::string_view name;   // as the user gave it
  std::string_view bytes;  // the whole file
  Job& job;
};

// What the user can do about the commonest failures.
inline constexpr const char* remedy_incomplete = "copy or export the file again, it is incomplete";
inline constexpr const char* remedy_malformed = "correct that place or export the file again";

// Throws Failure with the message "'name': where: what"; `where` may be empty.
[[noreturn]] void fail(const Source& source, ErrorCode code, const std::string& where,
                       const std::string& what, const std::string& remedy);
// fail() with ErrorCode::unreadable.
[[noreturn]] void malformed(const Source& source, const std::string& where, const std::string& what,
                            const std::string& remedy = remedy_malformed);

// "line 12".
std::string at_line(std::size_t line);
// Text from a file, in quotes, fit for a message: at most 40 characters, all printable ASCII.
std::string quoted(std::string_view text);

// Context::memory_limit, or the memory of the machine; the largest number if neither is known.
std::uint64_t memory_limit(const Context& context);
// Throws out_of_memory if `count` things of `bytes_each` (> 0) and the file itself exceed the
// limit. `what` is a plural noun.
void require_memory(const Source& source, const std::string& what, std::uint64_t count,
                    std::uint64_t bytes_each);
// Throws unsupported if `count` vertices are more than an Index can name.
void require_indexable(const Source& source, std::uint64_t count);
// Throws unreadable if the file starts like binary data or UTF-16.
void require_text(const Source& source);

}  // namespace arris
