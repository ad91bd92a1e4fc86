#pragma once

#include "src/gl/program.hpp"
#include "src/render/shadow_map/shadow_map_view.hpp"
#include "src/rivals/maps/visible_places.hpp"
#include "src/rivals/maps/warp_table.hpp"
#include "src/rivals/maps/warped_casters.hpp"

#include <optional>

namespace edgeshade {

/// Warps a sun's map for the places that the frame shows.
class MapWarper {
  public:
    MapWarper(WarpGrid grid, const gl::Capabilities& capabilities)
        : grid_(grid), places_(capabilities) {}

    /// Finds the visible places. Throws Error(unavailable) if the GL can't draw their picture.
    void look(const FrameView& view, const std::function<void(const FrameView&)>& drawNearness) {
        visible_ = places_.find(view, drawNearness);
    }

    /// Fits the warp to the view of a map whose xy are 0..1 across all casters. `margin`:
    /// MapWarp::margin.
    void fit(ShadowMapView& view, double margin);

    /// Cuts all casters along the fitted warp, and uploads casters and warp.
    const WarpedCasters& cut(const GpuScene& scene, const ShadowMapView& view);

    /// Sets the uniforms of shaders_es2/rivals/maps/warp.glsl; takes one texture unit.
    void set(const gl::Program& program, int unit) const;

    std::size_t bytes() const { return places_.bytes() + warpBytes(); }
    /// Bytes of the warp and of the cut casters.
    std::size_t warpBytes() const { return table_ ? WarpTable::bytes() + casters_.bytes() : 0; }

  private:
    WarpGrid grid_;
    VisiblePlaces places_;
    std::vector<glm::dvec3> visible_; ///< in the world
    MapWarp warp_;
    std::size_t revision_ = 0; ///< of the warp
    std::optional<WarpTable> table_;
    WarpedCasters casters_;
};

} // namespace edgeshade
