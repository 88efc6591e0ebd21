#include "io/source.h"

#include <limits>

#include "arris/types.h"
#include "base/failure.h"

namespace arris {

void fail(const Source& source, ErrorCode code, const std::string& where, const std::string& what,
          const std::string& remedy) {
  std::string message(1, '\'');
  message.append(source.name).append("': ");
  if (!where.empty()) message += where + ": ";
  throw Failure(code, message + what, remedy);
}

void malformed(const Source& source, const std::string& where, const std::string& what,
               const std::string& remedy) {
  fail(source, ErrorCode::unreadable, where, what, remedy);
}

std::string at_line(std::size_t line) {
  return "line " + std::to_string(line);
}

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string out(1, '\'');
  for (const char c : text.substr(0, longest)) out += c >= ' ' && c <= '~' ? c : '?';
  if (text.size() > longest) out += "...";
  out += '\'';
  return out;
}

std::uint64_t memory_limit(const Context& context) {
  const std::uint64_t limit = context.memory_limit ? context.memory_limit : machine_memory();
  return limit ? limit : std::numeric_limits<std::uint64_t>::max();
}

void require_memory(const Source& source, const std::string& what, std::uint64_t count,
                    std::uint64_t bytes_each) {
  const std::uint64_t limit = memory_limit(source.job.context());
  const std::uint64_t file = source.bytes.size();
  if (file <= limit && count <= (limit - file) / bytes_each) return;
  fail(source, ErrorCode::out_of_memory, "",
       std::to_string(count) + " " + what + " need more than the memory limit of " +
           std::to_string(limit) + " bytes",
       "use a smaller file, or raise the memory limit");
}

void require_indexable(const Source& source, std::uint64_t count) {
  if (count < no_index) return;
  fail(source, ErrorCode::unsupported, "",
       std::to_string(count) + " vertices are more than the " + std::to_string(no_index - 1) +
           " that arris can number",
       "split the file or thin it out");
}

void require_text(const Source& source) {
  constexpr std::size_t sample = 4096;  // enough: real text has no NUL, binary data has soon
  const std::string_view head = source.bytes.substr(0, sample);
  const bool utf16 = head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF");
  if (!utf16 && head.find('\0') == head.npos) return;
  malformed(source, "", utf16 ? "is UTF-16 text" : "is binary data, not text",
            utf16 ? "save it as UTF-8 or plain ASCII"
                  : "give it the extension of its real format, or export it as text");
}

}  // namespace arris
