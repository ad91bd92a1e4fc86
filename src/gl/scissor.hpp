#pragma once

#include "src/shadow/geometry/pixel_rectangle.hpp"

namespace edgeshade::gl {

/// The rectangle of a framebuffer of this size that the scissor lets through.
PixelRectangle scissored(int width, int height);

/// Restricts drawing to a rectangle for its lifetime, then restores the scissor. In browsers it
/// doesn't restore the box of a scissor that was off.
class ScissorScope {
  public:
    explicit ScissorScope(const PixelRectangle& rectangle);
    ~ScissorScope();
    ScissorScope(const ScissorScope&) = delete;
    ScissorScope& operator=(const ScissorScope&) = delete;

  private:
    int box_[4] = {}; ///< in browsers saved only if the scissor was on
    bool enabled_;
};

} // namespace edgeshade::gl
