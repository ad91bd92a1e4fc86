#include "src/scene/fitting_map.hpp"

#include <algorithm>

namespace edgeshade {

FittingMap::FittingMap(const Light& light, std::vector<PlacedCasters> casters,
                       const PrimitiveMapSettings& settings)
    : light_(light), casters_(std::move(casters)), settings_(settings),
      smallest_(std::max(4, settings.size / 8)) {}

bool FittingMap::step() {
    if (joined_) return false;
    if (!builder_) {
        builder_ = std::make_unique<PrimitiveMapBuilder>(light_, casters_, settings_);
        nextPart_ = 0;
        joined_ = tooFar_ = builder_->isTooFar();
    } else if (nextPart_ < builder_->partCount()) {
        builder_->buildPart(nextPart_++);
    } else {
        map_ = builder_->join();
        builder_.reset();
        settings_.size /= 2; // should it have been too large
        joined_ = map_ || settings_.size < smallest_;
    }
    return true;
}

void FittingMap::buildAllParts() {
    if (!builder_ || nextPart_ > 0 || joined_) return;
    builder_->buildAllParts();
    nextPart_ = builder_->partCount();
}

std::string refusalOf(const std::optional<PrimitiveMap>& map, bool tooFar, std::size_t mostBytes) {
    if (tooFar) return "the light is too far from its casters for a primitive map";
    if (!map)
        return "a primitive map would take more than " + std::to_string(mostBytes) +
               " bytes, or minutes";
    if (map->longestList > longestAsked)
        return "a list of its primitive map has " + std::to_string(map->longestList) +
               " triangles, more than a shader's loops go through";
    return {};
}

} // namespace edgeshade
