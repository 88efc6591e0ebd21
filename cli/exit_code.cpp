#include "exit_code.h"

#include <cstdio>

#include "signals.h"

namespace arris::cli {

const char* const exit_codes_help =
    "Exit codes:\n"
    "    0  success\n"
    "    2  usage: an option is unknown, out of range or contradictory\n"
    "    3  unreadable: a file is missing, unreadable, truncated or malformed\n"
    "    4  unsupported: a file type or property that arris does not read or write\n"
    "    5  bad_points: non-finite coordinates, or no points at all\n"
    "    6  degenerate: too few distinct points, or all in one plane\n"
    "    7  no_surface: the points do not bound a solid\n"
    "    8  certificate: the mesh fails a check\n"
    "    9  out_of_memory: the work needs more than the memory limit\n"
    "   10  unwritable: an output cannot be written\n"
    "   11  cancelled\n"
    "   12  internal: a fault in arris itself, please report it\n"
    "  130  interrupted by Ctrl-C or another signal\n";

int report_error(const Error& error) {
  std::fprintf(stderr, "arris: %s\n", error.message.c_str());
  if (!error.remedy.empty()) std::fprintf(stderr, "  remedy: %s\n", error.remedy.c_str());
  if (error.code == ErrorCode::cancelled && interrupted()) return exit_interrupted;
  return static_cast<int>(error.code);
}

}  // namespace arris::cli
