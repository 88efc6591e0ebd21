#include "arris/error.h"
#include "arris/version.h"

namespace arris {

const char* name(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::usage:
      return "usage";
    case ErrorCode::unreadable:
      return "unreadable";
    case ErrorCode::unsupported:
      return "unsupported";
    case ErrorCode::bad_points:
      return "bad_points";
    case ErrorCode::degenerate:
      return "degenerate";
    case ErrorCode::no_surface:
      return "no_surface";
    case ErrorCode::certificate:
      return "certificate";
    case ErrorCode::out_of_memory:
      return "out_of_memory";
    case ErrorCode::unwritable:
      return "unwritable";
    case ErrorCode::cancelled:
      return "cancelled";
    case ErrorCode::internal:
      return "internal";
  }
  return "internal";
}

const char* version() noexcept {
  return ARRIS_VERSION;
}

}  // namespace arris
