#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"

#include <cstddef>

namespace edgeshade::gl {

/// Depth and an 8-bit stencil for framebuffers of one's own: packed in one renderbuffer, which is
/// core in ES 3.0 and WebGL 1 and an extension in ES 2.0, else in two.
class DepthStencil {
  public:
    /// Throws Error(unavailable) if the GL is out of memory.
    DepthStencil(int width, int height, const Capabilities& capabilities);

    /// Attaches both to the bound framebuffer, whose status says whether the GL can draw so.
    void attach() const;

    std::size_t bytes() const { return bytes_; }

  private:
    Renderbuffer depth_;   ///< with the stencil where they are packed
    Renderbuffer stencil_; ///< where they are apart
    std::size_t bytes_ = 0;
};

} // namespace edgeshade::gl
