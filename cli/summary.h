// What the commands print about a result.
#pragma once

#include <string>
#include <vector>

#include "arris/check.h"
#include "arris/report.h"

namespace arris::cli {

void print_warnings(const std::vector<std::string>& warnings);  // to standard error

// A few lines: size of the mesh, certificate, time.
void print_summary(const std::string& path, const Report& report, double seconds);

// Counts, energies and the stages with time and memory, a line each.
void print_details(const Report& report);

// The certificate, a line per promise.
void print_certificate(const std::string& path, const Certificate& certificate);

// One JSON object, two-space indent, keys in a fixed order; counts as the fields of Certificate.
void print_certificate_json(const Certificate& certificate);

}  // namespace arris::cli
