#include "src/cli/explanation.hpp"

#include "src/render/frame/explain.hpp"

#include <sstream>

namespace edgeshade::cli {
namespace {

std::string placeOf(const Light& light) {
    std::ostringstream text;
    text << (light.position.w == 0.0 ? "sun towards " : "at ") << light.position.x << ","
         << light.position.y << "," << light.position.z;
    return text.str();
}

/// All batches with their records, of the whole scene.
std::vector<PlacedShadow> placedShadows(const LoadedScene& loaded) {
    std::vector<PlacedShadow> casters;
    for (std::size_t i = 0; i < loaded.adapted.size(); ++i)
        casters.push_back({i, loaded.adapted[i].get(), loaded.scene.batches[i].worldFromBatch});
    return casters;
}

/// The same of one group.
std::vector<PlacedShadow> placedShadows(const LoadedScene& loaded,
                                        const std::vector<BatchVolumes>& group) {
    std::vector<PlacedShadow> casters = placedShadows(loaded);
    for (std::size_t i = 0; i < casters.size(); ++i)
        casters[i].shadow = group[i].adapted->shadow().get();
    return casters;
}

/// How many records reach the vertex shader.
std::string offered(const std::vector<PlacedShadow>& casters, const Light& light,
                    SilhouetteChoice choice, int mantissaBits) {
    std::size_t pairs = 0, singles = 0, listed = 0;
    for (const PlacedShadow& caster : casters) {
        pairs += caster.shadow->pairs.size();
        singles += caster.shadow->singles.size();
        if (choice == SilhouetteChoice::all) continue;
        Proposal proposal;
        const LightBall ball{lightInObject(light, caster.worldFromBatch), 0.0f};
        propose(*caster.shadow, LightFacings(*caster.shadow), ball, mantissaBits, proposal);
        listed += proposal.size();
    }
    std::ostringstream text;
    if (choice == SilhouetteChoice::all)
        text << "all " << pairs << " records of two triangles and ";
    else
        text << listed << " of " << pairs << " records of two triangles, those that can be "
             << "silhouettes, and ";
    text << singles << " of one triangle";
    return text.str();
}

} // namespace

std::string explanationOf(const LoadedScene& loaded, const FrameView& view,
                          const RenderSettings& settings, const OverflowGroups& groups,
                          const gl::Capabilities& capabilities) {
    if (settings.shadows == ShadowMethod::none) return "no shadows are drawn";
    if (settings.shadows == ShadowMethod::map)
        return "shadow maps: every light draws all casters, a point light up to six times";
    if (volumeLayoutOf(settings.multiplicity) == VolumeLayout::published)
        return "published records: every edge and all caps of every light, z-fail";
    const int bits = capabilities.vertexHighpMantissaBits;
    std::ostringstream text;
    for (std::size_t i = 0; i < (view.mask ? 1 : view.lights.size()); ++i) {
        const Light& light = view.lights[i].light;
        text << "light " << i << ", " << placeOf(light) << ": ";
        const GroupedShadow* grouped = groups.of(view.lights[i], VolumeLayout::adapted);
        const std::size_t count = grouped ? grouped->size() : 1;
        if (grouped)
            text << "casters in " << count
                 << " groups, since more volumes may overlap than a stencil counts\n";
        for (std::size_t g = 0; g < count; ++g) {
            const auto casters =
                grouped ? placedShadows(loaded, (*grouped)[g]) : placedShadows(loaded);
            if (grouped) text << "group " << g << ": ";
            text << offered(casters, light, settings.silhouette, bits) << "\n";
            for (const DepthSlice& slice : view.slices) {
                if (view.slices.size() > 1)
                    text << "depths from " << slice.near << " to " << slice.far << ": ";
                text << explain(planLight(casters, view, slice, light, bits), casters);
            }
        }
    }
    std::string lines = text.str();
    lines.pop_back(); // the last line's end
    return lines;
}

} // namespace edgeshade::cli
