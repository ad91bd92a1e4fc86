#pragma once

#include <optional>
#include <string>

namespace edgeshade::gl {

/// Flips this program's framebuffers so that their rows run like those of the default framebuffer:
/// GL_MESA_framebuffer_flip_y. Rasterisers round along y in the direction of rows, so that only
/// then do both get the same pixels.
class FramebufferFlip {
  public:
    /// Null if the GL lacks the extension. `lookUp` maps a name to an entry point or null.
    static std::optional<FramebufferFlip> find(const std::string& extensions,
                                               void* (*lookUp)(const char*));

    /// Flips the bound framebuffer. Drawing and reading work as before; its textures have their
    /// first row at the top.
    void flip() const;

  private:
    using SetParameter = void (*)(unsigned, unsigned, int);

    SetParameter set_ = nullptr;
};

} // namespace edgeshade::gl
