#pragma once

#include "src/gl/depth_stencil.hpp"
#include "src/render/accumulation/picture_sum.hpp"
#include "src/render/frame/frame.hpp"
#include "src/scene/load.hpp"

#include <optional>
#include <span>
#include <vector>

namespace edgeshade {

/// The number of lights that reach each pixel's surface. Pixels in rows, top to bottom.
struct LitCounts {
    int width = 0;
    int height = 0;
    std::uint32_t lights = 0;           ///< number of lights counted
    std::uint32_t pictures = 0;         ///< number of pictures that were drawn for them
    std::vector<std::uint16_t> lit;     ///< 0..lights
    std::vector<std::uint16_t> surface; ///< 0..pictures: in how many pictures the pixel shows a
                                        ///< surface
};

/// Adds up exact lit masks (docs/method.md, C41), of a light's points or of any lights. Changes the
/// viewport and the drawing state. If the GL can't draw into a texture with depth and stencil,
/// which ES 2.0 doesn't guarantee, it also changes the bound picture, which must have 8 bits a
/// channel, alpha, and one sample a pixel.
class LitCounter {
  public:
    /// Number of lights to plan volumes for at once in one picture, so that their plans stay small.
    static std::size_t lightsAtOnce(const GpuScene& scene);

    explicit LitCounter(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// Starts from nothing, for pictures of this size. `part`: the views' FrameView::part; the
    /// other pixels are undefined. Throws Error(unavailable) if the GL can't.
    void begin(int width, int height, const std::optional<PixelRectangle>& part = {});

    /// Adds the masks of all lights of a view. The view must have the size passed to begin(), sum
    /// masks (pointsView()), and have at most mostSummed lights. Uploads the groups of casters that
    /// the lights need, and keeps those of `others`. Throws Error(usage) if the sum would exceed
    /// PictureSum::most.
    void add(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
             std::span<const FrameLight> others = {}, StageClock* clock = nullptr);

    /// Makes what add() of the same takes before it draws, see Renderer::planAhead().
    static bool planAhead(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded,
                          const FrameView& view, std::span<const FrameLight> others);

    /// Adds some points of one of the view's lights: by a primitive map of the whole light if it
    /// has one, otherwise mask by mask.
    void addPoints(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded,
                   const FrameView& view, std::size_t light, std::size_t first, std::size_t count,
                   std::span<const FrameLight> others = {}, StageClock* clock = nullptr);

    void beginPrograms() { sum_.beginPrograms(); }
    void forEachProgram(const gl::ProgramVisitor& visit) const { sum_.forEachProgram(visit); }

    /// Depth and stencil of its masks, from begin() on; null: the GL can't draw into textures with
    /// both.
    const gl::DepthStencil* depthStencil() const {
        return depthStencil_ ? &*depthStencil_ : nullptr;
    }
    std::uint32_t lights() const { return lights_; } ///< lights so far
    /// The share of the lights that reach each pixel. Valid until the next call.
    VisibilityLookup visibility();
    LitCounts read() const;
    /// The counts as a PictureSum: the first channel holds the number of lights that reach a pixel,
    /// alpha the number of pictures in which it shows a surface.
    const PictureSum& sum() const { return sum_; }
    std::size_t bytes() const;

  private:
    gl::Capabilities capabilities_;
    gl::ColorTarget masks_;                        ///< the masks of one call
    std::optional<gl::DepthStencil> depthStencil_; ///< null: masks are drawn elsewhere and copied
    PictureSum sum_;
    std::uint32_t lights_ = 0, pictures_ = 0;
};

} // namespace edgeshade
