#pragma once

#include "src/viewer/overlay_pass.hpp"

#include <string>

namespace edgeshade::desktop {

/// Lines of text on a dark background, as triangles; `x` and `y`: the background's upper left
/// corner. `scale`: of stb_easy_font's letters, which are about 7 pixels high. Text after a tab
/// goes into a second column; non-ASCII characters become ?.
viewer::OverlayTriangles textTriangles(const std::string& text, float x, float y, float scale);

/// Height of the same text with its background.
float textHeight(const std::string& text, float scale);

} // namespace edgeshade::desktop
