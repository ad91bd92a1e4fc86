#include "src/render/volumes/volume_renderer.hpp"

namespace edgeshade {

const glm::vec4& VolumeTints::of(const VolumeDraw& draw) const {
    if (draw.shape != VolumeDraw::Shape::sides) return caps;
    if (draw.times == Times::twice) return twice;
    return draw.zFail ? behind : before;
}

std::vector<std::string> tintDefines(const std::optional<VolumeTints>& tints) {
    if (!tints) return {};
    return {"UNIFORM_TINT", "TINT u_tint"};
}

void setVolume(const gl::Program& program, const VolumeDraw& draw, const DrawnBatch& batch,
               const std::optional<VolumeTints>& tints) {
    program.set("u_light", batch.plan.light);
    program.set("u_reach", batch.plan.reach);
    program.set("u_clipFromObject", batch.clipFromObject);
    if (tints) program.set("u_tint", tints->of(draw));
}

} // namespace edgeshade
