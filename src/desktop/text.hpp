#pragma once

#include "src/viewer/overlay_pass.hpp"

#include <string>

namespace edgeshade::desktop {

/// Lines of text on a dark ground, as triangles; `x` and `y`: the ground's upper left corner.
/// `scale`: of stb_easy_font's letters, which are about 7 pixels high. What follows a tab
/// stands in a column of its own; what is not ASCII becomes ?.
viewer::OverlayTriangles textTriangles(const std::string& text, float x, float y, float scale);

/// How high the same text is with its ground.
float textHeight(const std::string& text, float scale);

} // namespace edgeshade::desktop
