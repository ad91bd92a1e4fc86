#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/color_target.hpp"
#include "src/gl/depth_stencil.hpp"
#include "src/gl/program_variants.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/irregular/seen_triangles.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <map>
#include <optional>

namespace edgeshade {

/// Finds the triangle that each pixel shows, as the GL's own rasteriser decides it: draws surfaces
/// again in the colours of their numbers, with a depth buffer of its own, and reads them back.
class SurfaceNumbers {
  public:
    static constexpr std::size_t mostTriangles = (std::size_t{1} << 24) - 1;

    explicit SurfaceNumbers(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// Finds the triangles that a slice shows in `area`. Leaves the framebuffer, its scissor and
    /// its depth range as they were; afterwards colour and depth are written, the depth function is
    /// LESS, blending, culling and the stencil test are off, dithering is on. Throws
    /// Error(unavailable) if the GL can't draw this way, or there are more than mostTriangles. The
    /// scene's batches must stay as they are while `seen` is in use.
    void find(const GpuScene& scene, const FrameView& view, const DepthSlice& slice,
              const PixelRectangle& area, SeenTriangles& seen);

    std::size_t bytes() const; ///< on the GPU

  private:
    struct Variant {
        bool alphaTest = false, sliced = false;

        auto operator<=>(const Variant&) const = default;
    };
    /// The triangles of a geometry, each with its own vertices, kept as long as any batch has it.
    struct Kept {
        CopyOnWrite<Geometry> geometry; ///< shared, so that nobody edits it in place
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
    bool flipped_ = false; ///< rows are in the default framebuffer's order
    std::map<const Geometry*, Kept> kept_;
    gl::ProgramVariants<Variant> programs_;
    std::vector<std::uint8_t> pixels_; ///< as read back
};

} // namespace edgeshade
