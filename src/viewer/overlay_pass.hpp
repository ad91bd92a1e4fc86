#pragma once

#include "src/gl/program.hpp"

#include <span>
#include <vector>

namespace edgeshade::viewer {

/// A corner of a flat triangle over the picture: pixels, rows down; sRGB, alpha.
struct OverlayVertex {
    glm::vec2 position;
    std::uint8_t color[4];
};

/// Triangles, three corners each.
using OverlayTriangles = std::vector<OverlayVertex>;

/// Draws flat coloured triangles over the picture: handles, lines, text. Its own alpha is left as
/// it is.
class OverlayPass {
  public:
    OverlayPass();
    void draw(const OverlayTriangles& triangles, int width, int height);

  private:
    gl::Program program_;
};

} // namespace edgeshade::viewer
