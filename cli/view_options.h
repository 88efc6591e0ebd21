// The options of every command that draws a picture: its size and where one looks from.
#pragma once

#include "viewer/render.h"

namespace CLI {
class App;
}

namespace arris::cli {

// Declares --size, --up, --azimuth, --elevation and --zoom.
void add_camera_options(CLI::App& app, viewer::View& view);

}  // namespace arris::cli
