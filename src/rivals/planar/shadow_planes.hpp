#pragma once

#include "src/gl/objects.hpp"
#include "src/rivals/planar/largest_planes.hpp"

namespace edgeshade {

struct LoadedScene;

/// Triangles in a plane, from one chunk of a batch.
struct PlaneReceivers {
    std::size_t batch = 0;
    std::size_t chunk = 0; ///< SurfaceChunk::place
    gl::Buffer indices;    ///< 16-bit, into the chunk's vertices
    int indexCount = 0;
};

/// A plane onto which shadows are projected.
struct ShadowPlane {
    glm::dvec4 plane{0.0};  ///< see SurfacePlane
    double tolerance = 0.0; ///< see SurfacePlane
    Box bounds;             ///< of its triangles, in the world
    std::vector<PlaneReceivers> receivers;
};

/// A scene's largest planes on the GPU. No animation moves them.
class ShadowPlanes {
  public:
    ShadowPlanes() = default;
    /// Finds and uploads the `count` largest planes.
    ShadowPlanes(const LoadedScene& loaded, std::size_t count);

    const std::vector<ShadowPlane>& all() const { return planes_; }
    double share() const { return share_; }     ///< share of all surfaces' area
    double buildMs() const { return buildMs_; } ///< on the CPU
    std::size_t bytes() const;

  private:
    std::vector<ShadowPlane> planes_;
    double share_ = 0.0, buildMs_ = 0.0;
};

} // namespace edgeshade
