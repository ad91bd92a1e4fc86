#pragma once

#include "src/gl/program.hpp"

#include <span>
#include <vector>

namespace edgeshade::viewer {

/// A corner of a flat triangle over the picture: position in pixels, y down; colour in sRGB and
/// alpha.
struct OverlayVertex {
    glm::vec2 position;
    std::uint8_t color[4];
};

/// Triangles, three corners each.
using OverlayTriangles = std::vector<OverlayVertex>;

/// Draws flat coloured triangles over the picture: handles, lines, text. Leaves the picture's own
/// alpha unchanged.
class OverlayPass {
  public:
    OverlayPass();
    void draw(const OverlayTriangles& triangles, int width, int height);

  private:
    gl::Program program_;
};

} // namespace edgeshade::viewer
