#pragma once

#include "src/render/accumulation/lit_counter.hpp"

#include <functional>
#include <glm/glm.hpp>
#include <span>

namespace edgeshade {

/// Counts how many directional lights reach the surface that each pixel shows, for up to
/// PictureSum::most directions, each pointing towards its light. `request`: its lights are ignored.
/// BLEND surfaces are left out, as they take no part in shadows. `progress` receives the share
/// done. Throws Error as LitCounter does.
LitCounts countDirections(const LoadedScene& loaded, const FrameRequest& request,
                          std::span<const glm::dvec3> directions, Renderer& renderer,
                          GpuScene& scene, const gl::Capabilities& capabilities,
                          const std::function<void(double)>& progress);

} // namespace edgeshade
