#pragma once

#include "src/gl/objects.hpp"

namespace edgeshade::gl {

/// A texture of 8-bit RGBA texels to draw into, sampled without filtering, and its framebuffer.
/// Depth and stencil may be attached to the framebuffer.
struct ColorTarget {
    Texture texture;
    Framebuffer framebuffer;

    ColorTarget() = default;
    /// Leaves the framebuffer bound, and no texture. Throws Error(unavailable) if the GL is out of
    /// memory. The framebuffer's status says whether the GL can draw into it.
    ColorTarget(int width, int height);
};

} // namespace edgeshade::gl
