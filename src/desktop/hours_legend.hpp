#pragma once

#include "src/viewer/overlay_pass.hpp"
#include "src/viewer/sun_hours.hpp"

namespace edgeshade::desktop {

/// How far hours of sun are counted, in words; once they are shown their colours, and `here`: of
/// how many positions the sun sees what is under the cursor. As triangles; `x`, `bottom`: the lower
/// left corner; `scale` as of textTriangles().
viewer::OverlayTriangles hoursLegend(const viewer::SunHours& hours, bool shown,
                                     const std::optional<std::uint32_t>& here, float x,
                                     float bottom, float scale);

} // namespace edgeshade::desktop
