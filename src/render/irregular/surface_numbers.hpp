#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/color_target.hpp"
#include "src/gl/depth_stencil.hpp"
#include "src/gl/program.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/irregular/seen_triangles.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <map>
#include <optional>

namespace edgeshade {

/// Which triangle each pixel shows, as the GL's own rasteriser has it: surfaces are drawn once
/// more, in the colours of their numbers, with a depth buffer of their own, and read back.
class SurfaceNumbers {
  public:
    static constexpr std::size_t mostTriangles = (std::size_t{1} << 24) - 1;

    explicit SurfaceNumbers(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// What a slice shows in `area`. Leaves the framebuffer, its scissor and its depth range as
    /// they were; colour and depth are written, depths LESS are taken, blending, culling and the
    /// stencil's test are off, dithering is on. Throws Error(unavailable) where the GL can't draw
    /// so, or there are more than mostTriangles. The scene's batches must stay as they are while
    /// `seen` is asked.
    void find(const GpuScene& scene, const FrameView& view, const DepthSlice& slice,
              const PixelRectangle& area, SeenTriangles& seen);

    std::size_t bytes() const; ///< on the GPU

  private:
    struct Variant {
        bool alphaTest = false, sliced = false;

        auto operator<=>(const Variant&) const = default;
    };
    /// The triangles of a geometry, each with its own vertices; as long as batches have it.
    struct Kept {
        CopyOnWrite<Geometry> geometry; ///< it is shared, so that nobody edits it in place
        std::shared_ptr<const int> scene;
        std::vector<std::uint8_t> casts; ///< by triangle
        gl::Buffer vertices;
        bool used = true;
    };

    void fit(int width, int height);
    Kept& keptOf(const GpuScene& scene, const GpuBatch& batch);
    void drawBatch(const GpuScene& scene, const GpuBatch& batch, const FrameView& view,
                   const DepthSlice& slice, const Kept& kept, std::uint32_t first);
    const gl::Program& program(const Variant& variant);
    void read(const PixelRectangle& area, std::vector<std::uint32_t>& numbers);

    gl::Capabilities capabilities_;
    gl::ColorTarget target_;
    std::optional<gl::DepthStencil> depth_;
    glm::ivec2 size_{0};
    bool flipped_ = false; ///< as the default framebuffer's rows lie
    std::map<const Geometry*, Kept> kept_;
    std::map<Variant, gl::Program> programs_;
    std::vector<std::uint8_t> pixels_; ///< as they were read
};

} // namespace edgeshade
