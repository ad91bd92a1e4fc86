#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/depth_stencil.hpp"
#include "src/render/drawing/whole_picture.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// A framebuffer of half floats in which linear light is added up before it is converted to display
/// colours. It has as many samples as the context, if the GL has such framebuffers.
class LinearTarget {
  public:
    /// Whether the GL can draw into half floats.
    static bool isPossible(const gl::Capabilities& capabilities);

    explicit LinearTarget(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// Resizes and binds it. Returns whether the GL can draw into it; if not, restores the previous
    /// binding.
    bool bind(int width, int height);

    /// Draws its light as display colours over the whole viewport of that framebuffer.
    void show(gl::Name framebuffer);

    /// The linear light that the display shows as this sRGB colour: the clear value.
    static glm::vec3 lightShownAs(const glm::vec3& color);

    std::size_t bytes() const;

  private:
    bool make(int width, int height);
    bool makeTexture(unsigned internalFormat, unsigned type);
    bool makeSamples();

    gl::Capabilities capabilities_;
    glm::ivec2 size_{0};
    bool refused_ = false; ///< the GL turned out not to support it
    gl::Texture light_;
    gl::Framebuffer framebuffer_;
    gl::SampledBuffers samples_; ///< set if there are several samples
    gl::Framebuffer sampled_;
    std::optional<gl::DepthStencil> depthStencil_; ///< set if there is one sample
    std::optional<WholePicture> picture_;          ///< created on first use
};

} // namespace edgeshade
