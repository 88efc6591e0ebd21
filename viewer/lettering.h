// Captions in a small stroke font of our own: printable ASCII, anything else as a question mark.
#pragma once

#include <string>

#include "viewer/ink.h"

namespace arris::viewer {

// Capitals are six units high; lines of text need twelve.
double text_width(const std::string& text, double unit);

// Writes from the left end of the base line.
void draw_text(Ink& ink, const std::string& text, Pixel base, double unit, double pen);

}  // namespace arris::viewer
