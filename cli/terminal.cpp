#include "terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace arris::cli {
namespace {

constexpr int bar_cells = 30;
constexpr int line_width = 72;  // stage, bar, percentage and remaining time at their widest

// The remaining time is a guess from the time so far; before this much it would be noise.
constexpr double least_fraction = 0.02, least_seconds = 1;

int terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

// Whole seconds, as a clock shows them: "0:07 left".
std::string remaining(double seconds) {
  const auto whole = static_cast<long>(std::ceil(std::min(seconds, 359999.0)));
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%ld:%02ld left", whole / 60, whole % 60);
  return buffer.data();
}

}  // namespace

Progress::Style Progress::style_of_stderr() {
  const char* term = std::getenv("TERM");
  const bool dumb = term == nullptr || std::string_view(term) == "dumb";
  return isatty(STDERR_FILENO) && !dumb && terminal_width() >= line_width ? Style::bar
                                                                          : Style::lines;
}

std::function<void(std::string_view, double)> Progress::part(double begin, double end) {
  if (style_ == Style::silent) return nullptr;
  return [this, begin, end](std::string_view stage, double fraction) {
    show(stage, begin + (end - begin) * std::clamp(fraction, 0.0, 1.0));
  };
}

void Progress::show(std::string_view stage, double fraction) {
  const bool new_stage = stage != stage_;
  stage_ = stage;
  if (style_ == Style::bar) {
    draw_bar(fraction);
  } else if (new_stage) {
    std::fprintf(stderr, "%3d %%  %s\n", static_cast<int>(100 * fraction), stage_.c_str());
  }
}

void Progress::draw_bar(double fraction) {
  const auto filled = static_cast<std::size_t>(fraction * bar_cells);
  const std::string bar = std::string(filled, '#') + std::string(bar_cells - filled, '.');
  std::string left;
  if (fraction >= least_fraction && seconds() >= least_seconds)
    left = remaining(seconds() * (1 - fraction) / fraction);
  // \r and "erase to the end of the line": the next drawing covers this one.
  std::fprintf(stderr, "\r%-14.14s [%s] %3d %%  %s\x1b[K", stage_.c_str(), bar.c_str(),
               static_cast<int>(100 * fraction), left.c_str());
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::clear() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
  drawn_ = false;
}

double Progress::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

}  // namespace arris::cli
