#pragma once

#include "src/gl/depth_stencil.hpp"
#include "src/render/accumulation/picture_sum.hpp"
#include "src/render/frame/frame.hpp"
#include "src/scene/load.hpp"

#include <optional>
#include <span>
#include <vector>

namespace edgeshade {

/// How many of some lights reach what each pixel shows. Pixels in rows, top to bottom.
struct LitCounts {
    int width = 0;
    int height = 0;
    std::uint32_t lights = 0;           ///< that were asked for
    std::uint32_t pictures = 0;         ///< that they were drawn in
    std::vector<std::uint16_t> lit;     ///< 0..lights
    std::vector<std::uint16_t> surface; ///< 0..pictures: in how many of them a surface is there
};

/// Adds up exact lit masks (docs/method.md, C41), those of a light's points or any
/// others. Changes the viewport and the state of drawing; where the GL can't draw into a texture
/// with depth and stencil (ES 2.0 doesn't guarantee it), also the picture that is bound, which must
/// have 8 bits a channel, alpha, and one sample a pixel.
class LitCounter {
  public:
    /// Lights that one picture's volumes are planned for at once, so that their plans stay small.
    static std::size_t lightsAtOnce(const GpuScene& scene);

    explicit LitCounter(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// Nothing yet, for pictures of this size. Throws Error(unavailable) if the GL can't.
    void begin(int width, int height);

    /// Adds the masks of all lights of a view of that size, which sums masks (pointsView()), and
    /// has at most mostSummed. Groups of casters that lights need are uploaded; those of `others`
    /// stay. Throws Error(usage) where more than PictureSum::most would be added up.
    void add(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
             std::span<const FrameLight> others = {}, StageClock* clock = nullptr);

    /// Adds some of the points that one of the view's lights has: by its primitive map where it has
    /// one for all of it, else mask by mask.
    void addPoints(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded,
                   const FrameView& view, std::size_t light, std::size_t first, std::size_t count,
                   std::span<const FrameLight> others = {}, StageClock* clock = nullptr);

    std::uint32_t lights() const { return lights_; } ///< so far
    /// How many of them reach each pixel, as a share, until the next call.
    VisibilityLookup visibility();
    LitCounts read() const;
    /// What was counted, as PictureSum has it: in its first channel how many lights reach a pixel,
    /// in alpha in how many pictures a surface is there.
    const PictureSum& sum() const { return sum_; }
    std::size_t bytes() const;

  private:
    gl::Capabilities capabilities_;
    gl::ColorTarget masks_;                        ///< of one call
    std::optional<gl::DepthStencil> depthStencil_; ///< none: masks are drawn elsewhere and copied
    PictureSum sum_;
    std::uint32_t lights_ = 0, pictures_ = 0;
};

} // namespace edgeshade
