#include "src/cli/contender.hpp"

namespace edgeshade::cli {

lab::Contender contenderOf(const std::string& name, const DrawSettings& settings) {
    lab::Contender contender;
    contender.name = name;
    contender.settings = settings.render;
    contender.depthSlices = settings.depthSlices;
    contender.tuneMapBias = settings.render.shadows == ShadowMethod::map && !settings.hasMapBias();
    // The best there is, where nothing was asked for: the studio falls back by itself.
    contender.settings.layout =
        settings.instancing == InstancingChoice::off         ? SidesLayout::notInstanced
        : settings.instancing == InstancingChoice::multiDraw ? SidesLayout::multiDraw
                                                             : SidesLayout::instanced;
    return contender;
}

} // namespace edgeshade::cli
