#include "src/engine/light_lookups.hpp"

#include "preprocess/base/error.hpp"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

namespace edgeshade {
namespace {

LightLookup toldOf(const BuiltLookup& built, const gl::FloatTable& table) {
    const PackedPrimitiveMap& map = built.map;
    LightLookup told;
    told.texture = table.texture();
    std::copy_n(glm::value_ptr(table.size()), 3, told.tableSize.begin());
    std::transform(map.begins.begin(), map.begins.end(), told.begins.begin(),
                   [](std::size_t begin) { return static_cast<float>(begin); });
    told.size = static_cast<float>(map.size);
    told.kind = static_cast<float>(map.kind);
    told.places = {static_cast<float>(map.places), static_cast<float>(map.sixteens)};
    std::copy_n(glm::value_ptr(map.mapFromWorld), 16, told.mapFromWorld.begin());
    told.bytes = table.bytes();
    told.longestList = map.longestList;
    return told;
}

} // namespace

std::string LightLookups::obstacle() const {
    return gl::hasWideTables(capabilities_) ? "" : "the GL can't sample float textures exactly";
}

LightLookups::Id LightLookups::add(const LookupWork& work) {
    LookupWork::Data& data = *work.data();
    if (!data.done) throw InputError("A light's map was added before its work was done.");
    if (std::exchange(data.taken, true)) throw InputError("A light's map was added twice.");
    Kept kept{data.task.light,
              data.task.receivers,
              std::move(data.held),
              std::move(data.built.map.texels),
              {},
              0,
              {}};
    kept.told.why = data.built.why;
    if (kept.told.why.empty()) {
        try {
            kept.table = gl::FloatTable(data.built.map.count, capabilities_);
            kept.told = toldOf(data.built, kept.table);
            kept.told.uploaded = kept.texels.empty(); // without texels here, whoever holds them
                                                      // uploads them
        } catch (const Error&) {
            kept.told.why = "the GL has no memory for a table of " +
                            std::to_string(data.built.map.count) + " texels";
        }
    }
    kept.told.buildMs = data.built.milliseconds;
    kept_.emplace(next_, std::move(kept));
    return next_++;
}

bool LightLookups::upload(Id id, std::size_t mostBytes) {
    Kept& kept = at(id);
    if (!kept.told.why.empty() || kept.told.uploaded) return true;
    const std::vector<glm::vec4>& texels = kept.texels;
    const auto columns = static_cast<std::size_t>(kept.table.size().x);
    const std::size_t rows = std::max<std::size_t>(1, mostBytes / (columns * sizeof(glm::vec4)));
    const std::size_t left = texels.size() - kept.uploaded;
    const std::size_t count = left / columns < rows ? left : rows * columns;
    kept.table.fill(kept.uploaded, std::span(texels).subspan(kept.uploaded, count));
    kept.uploaded += count;
    kept.told.uploaded = kept.uploaded == texels.size();
    if (kept.told.uploaded) kept.texels = {};
    return kept.told.uploaded;
}

void LightLookups::remove(Id id) {
    at(id);
    kept_.erase(id);
}

bool LightLookups::isOf(Id id, const Light& light) const {
    return at(id).light.position == light.position && at(id).light.extent == light.extent;
}

bool LightLookups::reaches(Id id, const Box& receivers) const {
    const Kept& kept = at(id);
    if (!kept.light.extent || kept.light.position.w != 0.0) return true;
    return receivers.empty() ||
           (kept.receivers.holds(receivers.low) && kept.receivers.holds(receivers.high));
}

std::size_t LightLookups::bytes() const {
    std::size_t total = 0;
    for (const auto& [id, kept] : kept_)
        total += kept.table.bytes();
    return total;
}

const LightLookups::Kept& LightLookups::at(Id id) const {
    const auto found = kept_.find(id);
    if (found == kept_.end()) throw InputError("There is no lookup " + std::to_string(id) + ".");
    return found->second;
}

std::array<float, 16> mapFromView(const LightLookup& lookup, const Matrix16& viewFromWorld) {
    const glm::mat4 map(glm::make_mat4(lookup.mapFromWorld.data()) *
                        glm::inverse(glm::make_mat4(viewFromWorld.data())));
    std::array<float, 16> numbers{};
    std::copy_n(glm::value_ptr(map), numbers.size(), numbers.begin());
    return numbers;
}

} // namespace edgeshade
