#include "src/render/volumes/volume_renderer.hpp"

namespace edgeshade {

const glm::vec4& VolumeTints::of(const VolumeDraw& draw) const {
    if (draw.shape != VolumeDraw::Shape::sides) return caps;
    if (draw.times == Times::twice) return twice;
    return draw.zFail ? behind : before;
}

} // namespace edgeshade
