#pragma once

#include "src/viewer/overlay_pass.hpp"
#include "src/viewer/sun_hours.hpp"

namespace edgeshade::desktop {

/// Progress of the hours of sunlight in words, then their colours once they are shown, as
/// triangles. `here`: number of sun positions that light the surface under the cursor; `x`,
/// `bottom`: the lower left corner; `scale` as in textTriangles().
viewer::OverlayTriangles hoursLegend(const viewer::SunHours& hours, bool shown,
                                     const std::optional<std::uint32_t>& here, float x,
                                     float bottom, float scale);

} // namespace edgeshade::desktop
