#pragma once

#include "src/render/accumulation/lit_counter.hpp"

#include <functional>
#include <glm/glm.hpp>
#include <span>

namespace edgeshade {

/// How many of some directional lights reach what each pixel shows, for any number of directions
/// up to PictureSum::most, towards the light each. `request`: its lights are not asked. BLEND
/// surfaces, which take no part in shadows, are left out. `progress` gets the share done. Throws
/// Error as LitCounter does.
LitCounts countDirections(const LoadedScene& loaded, const FrameRequest& request,
                          std::span<const glm::dvec3> directions, Renderer& renderer,
                          GpuScene& scene, const gl::Capabilities& capabilities,
                          const std::function<void(double)>& progress);

} // namespace edgeshade
