#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/depth_stencil.hpp"
#include "src/render/drawing/whole_picture.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// A framebuffer that light is added up in, in half floats, before the display's colours are made
/// of all of it. With the samples a pixel of the context where the GL has such framebuffers.
class LinearTarget {
  public:
    /// Whether the GL can draw into half floats.
    static bool isPossible(const gl::Capabilities& capabilities);

    explicit LinearTarget(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// Makes it that large, and binds it. Returns whether the GL draws into it; else what was bound
    /// is bound again.
    bool bind(int width, int height);

    /// Draws the display's colours of it over the whole viewport of that framebuffer.
    void show(gl::Name framebuffer);

    /// What is cleared to for the display to show this colour, sRGB.
    static glm::vec3 lightShownAs(const glm::vec3& color);

    std::size_t bytes() const;

  private:
    bool make(int width, int height);
    bool makeTexture(unsigned internalFormat, unsigned type);
    bool makeSamples();

    gl::Capabilities capabilities_;
    glm::ivec2 size_{0};
    bool refused_ = false; ///< the GL can't after all
    gl::Texture light_;
    gl::Framebuffer framebuffer_;
    gl::SampledBuffers samples_; ///< where there are samples
    gl::Framebuffer sampled_;
    std::optional<gl::DepthStencil> depthStencil_; ///< where there are none
    std::optional<WholePicture> picture_;          ///< once it was drawn into
};

} // namespace edgeshade
