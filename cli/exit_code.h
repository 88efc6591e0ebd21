// Exit codes and error messages of the command.
#pragma once

#include "arris/error.h"

namespace arris::cli {

inline constexpr int exit_interrupted = 130;  // stopped by a signal, as shells number SIGINT

// The list of exit codes, for the help texts.
extern const char* const exit_codes_help;

// Prints "arris: MESSAGE" and "  remedy: REMEDY" to standard error and returns the exit code: the
// number of the ErrorCode, or exit_interrupted if a signal stopped the work.
int report_error(const Error& error);

}  // namespace arris::cli
