#pragma once

#include "src/render/shadow_map/pcss_light.hpp"
#include "src/render/shadow_map/shadow_map_view.hpp"
#include "src/shadow/lights/light.hpp"

namespace edgeshade {

/// `light`: with an extent, as its shape wants it (LightExtent); `view`: of its centre.
PcssLight pcssLight(const Light& light, const ShadowMapView& view);

} // namespace edgeshade
