#pragma once

#include "src/shadow/geometry/pixel_rectangle.hpp"

#include <optional>

namespace edgeshade::gl {

/// The rectangle of a framebuffer of this size that the scissor lets through.
PixelRectangle scissored(int width, int height);

/// Restricts drawing to a rectangle for its lifetime, then restores the scissor; without a
/// rectangle it does nothing. In browsers it doesn't restore the box of a scissor that was off.
class ScissorScope {
  public:
    explicit ScissorScope(const std::optional<PixelRectangle>& rectangle);
    ~ScissorScope();
    ScissorScope(const ScissorScope&) = delete;
    ScissorScope& operator=(const ScissorScope&) = delete;

  private:
    int box_[4] = {}; ///< in browsers saved only if the scissor was on
    bool restricts_, enabled_ = false;
};

} // namespace edgeshade::gl
