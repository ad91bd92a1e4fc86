#include "src/cli/explanation.hpp"

#include "src/shadow/plan/explain.hpp"

namespace edgeshade::cli {

std::string explanationOf(const Renderer& renderer, const FrameView& view) {
    switch (renderer.settings().shadows) {
    case ShadowMethod::none:
        return "no shadows are drawn";
    case ShadowMethod::map:
        return "shadow maps: every light draws all casters, a point light up to six times";
    case ShadowMethod::volumes:
    case ShadowMethod::primitiveMap:
        break;
    }
    if (renderer.volumes()->layout() == VolumeLayout::oppositeVertices)
        return "opposite-vertex records: every edge and all caps of every light, z-fail";
    return explain(renderer.plan(), view);
}

} // namespace edgeshade::cli
