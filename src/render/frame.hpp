#pragma once

#include "src/gl/capabilities.hpp"
#include "src/render/caps_pass.hpp"
#include "src/render/shadow_map_pass.hpp"
#include "src/render/sides_pass.hpp"
#include "src/render/surface_pass.hpp"
#include "src/scene/camera.hpp"

#include <optional>

namespace edgeshade {

enum class ShadowMethod { volumes, map, none };

/// How frames are drawn; fixed for a renderer.
struct RenderSettings {
    ShadowMethod shadows = ShadowMethod::volumes;
    MultiplicityMethod multiplicity = MultiplicityMethod::referenceEdge;
    SidesLayout layout = SidesLayout::instanced;
    ShadowMapSettings map; ///< where shadows are maps
    float ambient = 0.35f; ///< 0..1; the lights share the rest
    bool mask = false;     ///< the lit mask of the first light instead of a picture
    glm::vec3 background{0.86f, 0.89f, 0.92f};
};

/// What one frame shows.
struct FrameView {
    Camera camera;
    int width = 1;
    int height = 1;
    double near = 0.1;
    std::vector<double> nearestDepths; ///< of each batch, nearestVisibleDepth()
    std::vector<Light> lights;         ///< at least one
    Box bounds{}; ///< of the scene, worldBounds(); shadow maps are fitted to it
};

/// Draws frames by the three passes of the method (section 3): ambient light and depth; for each
/// light the shadow volumes into the stencil; then the lit surfaces, added. Or with shadow maps, or
/// with none, in place of volumes.
///
/// Counts depth-fail crossings in an 8-bit wrapping stencil: more than 255 volumes around one
/// visible point would be miscounted. Draws into the current framebuffer, which needs a stencil.
class Renderer {
  public:
    /// Throws Error(unavailable) if the layout needs instancing and there is none, or the GL's
    /// largest texture is smaller than a shadow map.
    Renderer(const RenderSettings& settings, const gl::Capabilities& capabilities);

    void draw(const GpuScene& scene, const FrameView& view);

    /// Memory of the shadow maps that were drawn so far.
    std::size_t mapBytes() const { return maps_ ? maps_->bytes() : 0; }

  private:
    void drawDepthAndAmbient(const GpuScene& scene, const FrameView& view);
    void drawVolumes(const GpuScene& scene, const FrameView& view, const Light& light);
    ShadowMapLookup drawMap(const GpuScene& scene, const FrameView& view, const Light& light);
    void drawLit(const GpuScene& scene, const FrameView& view, const Light& light,
                 const ShadowMapLookup* map);
    void drawBlended(const GpuScene& scene, const FrameView& view);

    RenderSettings settings_;
    SurfacePass surfaces_;
    SidesPass sides_;
    CapsPass caps_;
    std::optional<ShadowMapPass> maps_; ///< where shadows are maps
};

/// The layout that suits the context: instanced where it can, else not.
SidesLayout bestLayout(const gl::Capabilities& capabilities);

} // namespace edgeshade
