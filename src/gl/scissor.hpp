#pragma once

#include "src/shadow/geometry/pixel_rectangle.hpp"

namespace edgeshade::gl {

/// What the scissor lets through of a framebuffer of this size.
PixelRectangle scissored(int width, int height);

/// Draws within a rectangle alone, for as long as it lives; then the scissor is as before, but in
/// browsers for its box where it is off.
class ScissorScope {
  public:
    explicit ScissorScope(const PixelRectangle& rectangle);
    ~ScissorScope();
    ScissorScope(const ScissorScope&) = delete;
    ScissorScope& operator=(const ScissorScope&) = delete;

  private:
    int box_[4] = {}; ///< in browsers where it was on
    bool enabled_;
};

} // namespace edgeshade::gl
