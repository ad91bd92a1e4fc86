#pragma once

#include <optional>
#include <string>

namespace edgeshade::gl {

/// Fragments with several colours, each for a buffer of its own: GL_EXT_draw_buffers.
class DrawBuffers {
  public:
    /// Nothing where the GL has none, or but one buffer. `lookUp` maps a name to an entry point or
    /// null.
    static std::optional<DrawBuffers> find(const std::string& extensions,
                                           void* (*lookUp)(const char*));

    /// Attaches a texture as the bound framebuffer's second colour, and has both drawn.
    void attachSecond(unsigned texture) const;

  private:
    using Draw = void (*)(int, const unsigned*);

    Draw draw_ = nullptr;
};

} // namespace edgeshade::gl
