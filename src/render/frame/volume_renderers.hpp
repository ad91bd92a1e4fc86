#pragma once

#include "src/gl/capabilities.hpp"
#include "src/render/volumes/render_settings.hpp"
#include "src/render/volumes/volume_renderer.hpp"

#include <memory>

namespace edgeshade {

/// Creates the renderer of shadow volumes for these settings; null if shadows are not volumes.
/// `tints`: for debug views. Throws Error(unavailable) if the layout needs instancing and there is
/// none.
std::unique_ptr<VolumeRenderer> makeVolumeRenderer(const RenderSettings& settings,
                                                   const gl::Capabilities& capabilities,
                                                   std::optional<VolumeTints> tints = {});

} // namespace edgeshade
