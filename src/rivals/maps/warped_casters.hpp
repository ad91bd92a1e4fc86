#pragma once

#include "src/gl/objects.hpp"
#include "src/rivals/maps/map_warp.hpp"
#include "src/scene/gpu_scene.hpp"

namespace edgeshade {

/// All casters of a scene as a warped map shows them, cut on the CPU (WarpCuts) and uploaded.
class WarpedCasters {
  public:
    struct Vertex {
        glm::vec3 place; ///< WarpedCorner::place
        glm::vec2 texcoord;
        std::uint8_t color[4];
    };
    /// Casters that are drawn alike.
    struct Part {
        std::optional<std::size_t> cutout; ///< the alpha-tested material; null: they have no
                                           ///< cutouts
        gl::Buffer vertices;               ///< Vertex; only `place` if there are no cutouts
        int count = 0;
    };

    WarpedCasters() = default;
    /// `mapFromWorld`: a warped map's, see ShadowMapView. Throws Error(unavailable) if the GL has
    /// no memory for the casters.
    WarpedCasters(const GpuScene& scene, const glm::dmat4& mapFromWorld, const MapWarp& warp);

    const std::vector<Part>& parts() const { return parts_; }
    std::size_t bytes() const;

  private:
    std::vector<Part> parts_;
};

} // namespace edgeshade
