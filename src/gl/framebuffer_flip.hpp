#pragma once

#include <optional>
#include <string>

namespace edgeshade::gl {

/// Framebuffers of one's own whose rows lie as those of the default framebuffer do:
/// GL_MESA_framebuffer_flip_y. Rasterisers round along y as rows lie, so that only then both get
/// the same pixels.
class FramebufferFlip {
  public:
    /// Nothing where the GL has none. `lookUp` maps a name to an entry point or null.
    static std::optional<FramebufferFlip> find(const std::string& extensions,
                                               void* (*lookUp)(const char*));

    /// Flips the bound framebuffer. What is drawn and read of it stays; its textures have their
    /// rows from above.
    void flip() const;

  private:
    using SetParameter = void (*)(unsigned, unsigned, int);

    SetParameter set_ = nullptr;
};

} // namespace edgeshade::gl
