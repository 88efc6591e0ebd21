#ifdef ARRIS_HAS_VIEWER

#include "view_options.h"

#include <CLI/CLI.hpp>
#include <string>

#include "text.h"
#include "values.h"

namespace arris::cli {
namespace {

// "640x480"
void set_size(const std::string& text, viewer::View& view) {
  const std::size_t cross = text.find('x');
  const CLI::Validator pixels = whole_number_in(16, 16384, "WIDTHxHEIGHT, each 16 to 16384");
  std::string width = text.substr(0, cross);
  std::string height = cross == std::string::npos ? "" : text.substr(cross + 1);
  if (!pixels(width).empty() || !pixels(height).empty())
    throw CLI::ValidationError("--size",
                               "must be WIDTHxHEIGHT, each a whole number from 16 to "
                               "16384, not " +
                                   quoted(text));
  view.width = std::stoi(width);
  view.height = std::stoi(height);
}

}  // namespace

void add_camera_options(CLI::App& app, viewer::View& view) {
  app.add_option_function<std::string>(
         "--size", [&view](const std::string& text) { set_size(text, view); },
         "Pixels of the picture of each file (640x480)")
      ->type_name("WxH");
  const Choices<viewer::Up> axes = {
      {"x", viewer::Up::x}, {"y", viewer::Up::y}, {"z", viewer::Up::z}};
  add_choice(app, "--up", axes, view.up, "The axis that points up (z)");
  app.add_option("--azimuth", view.azimuth,
                 "Degrees round the model: larger looks from further to the right (30)")
      ->check(number_in(-360, 360, "a number from -360 to 360"));
  app.add_option("--elevation", view.elevation, "Degrees above the horizon (25)")
      ->check(number_in(-90, 90, "a number from -90 to 90"));
  app.add_option("--zoom", view.zoom, "Enlargement; 1 fits the model into the picture")
      ->check(number_in(0.001, 1000, "a number from 0.001 to 1000"));
}

}  // namespace arris::cli

#endif
