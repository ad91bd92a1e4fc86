#include "src/scene/fitting_map.hpp"

#include "src/shadow/lights/light_range.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// Texels that a map starts with for each triangle, and the fewest along a tile's edge. Texels with
/// long lists are subdivided, so that few triangles need few texels.
constexpr double texelsEach = 16.0;
constexpr int leastSize = 16;

/// Casting triangles within a light's range.
std::size_t castersWithin(const Light& light, const PlacedCasters& placed) {
    if (!placed.cast) return 0;
    const WeldedMesh& mesh = placed.casters->mesh;
    if (!light.hasRange()) return mesh.triangles.size();
    const glm::dvec3 at(glm::inverse(placed.worldFromBatch) * light.position);
    const double range = rangeInObject(light, placed.worldFromBatch);
    return static_cast<std::size_t>(
        std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& triangle) {
            return !areBeyond({mesh.positions[triangle[0]], mesh.positions[triangle[1]],
                               mesh.positions[triangle[2]]},
                              at, range);
        }));
}

/// Texels along a tile's edge that suit a light's casters: a power of two, at most `most`.
int sizeFor(const Light& light, const std::vector<PlacedCasters>& casters, int most) {
    const auto tiles = tilesFor(light, casters);
    if (!tiles || light.extent) return most;
    double texels = 0.0; // per tile
    for (const PlacedCasters& placed : casters)
        texels += texelsEach * static_cast<double>(castersWithin(light, placed)) /
                  static_cast<double>(tiles->tiles.size());
    int size = std::min(leastSize, most);
    while (size < most && static_cast<double>(size) * size < texels)
        size *= 2;
    return size;
}

} // namespace

FittingMap::FittingMap(const Light& light, std::vector<PlacedCasters> casters,
                       const PrimitiveMapSettings& settings)
    : light_(light), casters_(std::move(casters)), settings_(settings) {
    settings_.size = sizeFor(light_, casters_, settings.size);
    smallest_ = std::max(4, settings_.size / 8);
    settings_.longestWanted = std::min(settings.longestWanted, longestAsked);
}

bool FittingMap::step() {
    if (joined_) return false;
    if (!builder_) {
        builder_ = std::make_unique<PrimitiveMapBuilder>(light_, casters_, settings_);
        nextPart_ = 0;
        joined_ = tooFar_ = builder_->isTooFar();
        if (!joined_) builder_->lookForLongLists();
    } else if (nextPart_ < builder_->partCount()) {
        builder_->buildPart(nextPart_++);
    } else {
        map_ = builder_->join();
        tooLong_ = builder_->tooLong();
        builder_.reset();
        settings_.size /= 2; // in case it was too large
        joined_ = map_ || tooLong_ > 0 || settings_.size < smallest_;
    }
    return true;
}

void FittingMap::buildAllParts() {
    if (!builder_ || nextPart_ > 0 || joined_) return;
    builder_->buildAllParts();
    nextPart_ = builder_->partCount();
}

std::string refusalOf(const MapOutcome& outcome) {
    if (outcome.tooFar) return "the light is too far from its casters for a primitive map";
    if (outcome.tooLong > 0)
        return "a list in its primitive map would have " + std::to_string(outcome.tooLong) +
               " triangles, more than a shader loop can test";
    if (!outcome.built)
        return "a primitive map would take more than " + std::to_string(outcome.mostBytes) +
               " bytes, or minutes to build";
    return {};
}

} // namespace edgeshade
