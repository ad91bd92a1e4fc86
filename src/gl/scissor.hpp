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
    /// `around`: the scissor's present box, where the caller has set it: browsers report it only
    /// after all pending draws.
    explicit ScissorScope(const std::optional<PixelRectangle>& rectangle,
                          const std::optional<PixelRectangle>& around = {});
    ~ScissorScope();
    ScissorScope(const ScissorScope&) = delete;
    ScissorScope& operator=(const ScissorScope&) = delete;

  private:
    PixelRectangle box_; ///< in browsers saved only if the scissor was on
    bool restricts_, enabled_ = false;
};

} // namespace edgeshade::gl
