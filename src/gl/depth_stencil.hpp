#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"

#include <cstddef>

namespace edgeshade::gl {

/// Depth and an 8-bit stencil for this program's framebuffers. They are packed in one renderbuffer
/// where that is possible (core in ES 3.0 and WebGL 1, an extension in ES 2.0), otherwise in two.
class DepthStencil {
  public:
    /// Throws Error(unavailable) if the GL is out of memory.
    DepthStencil(int width, int height, const Capabilities& capabilities);

    /// Attaches both to the bound framebuffer, whose status says whether the GL can draw into it.
    void attach() const;

    std::size_t bytes() const { return bytes_; }

  private:
    Renderbuffer depth_;   ///< also the stencil, if they are packed
    Renderbuffer stencil_; ///< if they are separate
    std::size_t bytes_ = 0;
};

} // namespace edgeshade::gl
