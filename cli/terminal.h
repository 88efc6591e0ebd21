// Progress on standard error: one line redrawn on a terminal, a line per stage elsewhere.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace arris::cli {

// The progress of a command that makes several library calls, one after the other.
class Progress {
 public:
  enum class Style { silent, lines, bar };

  explicit Progress(Style style) : style_(style), start_(Clock::now()) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // A bar if standard error is a terminal that can redraw a line, else lines.
  static Style style_of_stderr();

  // The callback for a library call that is the part [begin, end] of the whole command. It refers
  // to this object.
  std::function<void(std::string_view, double)> part(double begin, double end);

  // Takes the bar off the screen, so that other text can be printed.
  void clear();

  double seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  void show(std::string_view stage, double fraction);
  void draw_bar(double fraction);

  Style style_;
  Clock::time_point start_;
  std::string stage_;
  bool drawn_ = false;
};

}  // namespace arris::cli
