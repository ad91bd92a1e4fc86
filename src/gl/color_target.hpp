#pragma once

#include "src/gl/objects.hpp"

namespace edgeshade::gl {

/// A texture of 8-bit RGBA texels that is drawn into, read texel by texel, and the framebuffer for
/// that, to which depth and stencil may be attached.
struct ColorTarget {
    Texture texture;
    Framebuffer framebuffer;

    ColorTarget() = default;
    /// Leaves the framebuffer bound, and no texture. Throws Error(unavailable) if the GL is out of
    /// memory; whether it can draw so, the framebuffer's status says.
    ColorTarget(int width, int height);
};

} // namespace edgeshade::gl
