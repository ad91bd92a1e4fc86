#pragma once

#include "src/render/shadow_map/pcss_light.hpp"
#include "src/render/shadow_map/shadow_map_view.hpp"
#include "src/shadow/lights/light.hpp"

namespace edgeshade {

/// `light`: must have an extent that suits its kind (LightExtent); `view`: of its centre.
PcssLight pcssLight(const Light& light, const ShadowMapView& view);

} // namespace edgeshade
