#include "src/hours/merge.hpp"

#include "preprocess/base/error.hpp"

#include <algorithm>

namespace edgeshade::hours {
namespace {

using Json = nlohmann::ordered_json;

/// Throws, as a part's value differs from the first part's.
[[noreturn]] void failDiffering(const PartOfFile& part, const PartOfFile& first,
                                const std::string& field, const std::string& value,
                                const std::string& firstValue) {
    throw InputError("'" + part.path + "': " + field + " is " + value + ", but in '" + first.path +
                     "' it is " + firstValue + "; these are not parts of one run.");
}

void requireSame(const PartOfFile& part, const PartOfFile& first, const std::string& field,
                 const Json& value, const Json& firstValue) {
    if (value == firstValue) return;
    if (value.is_object() && firstValue.is_object()) {
        for (const auto& [key, inner] : firstValue.items())
            requireSame(part, first, field + "." + key, value.value(key, Json()), inner);
        for (const auto& [key, inner] : value.items())
            requireSame(part, first, field + "." + key, inner, firstValue.value(key, Json()));
    }
    failDiffering(part, first, field, value.dump(), firstValue.dump());
}

template <class T>
void requireSamePixels(const PartOfFile& part, const PartOfFile& first, const char* field,
                       const std::vector<T>& pixels, const std::vector<T>& firstPixels) {
    const auto [here, there] = std::ranges::mismatch(pixels, firstPixels);
    if (here == pixels.end()) return;
    failDiffering(part, first,
                  std::string("pixels.") + field + " of pixel " +
                      std::to_string(here - pixels.begin()),
                  std::to_string(*here), std::to_string(*there));
}

Json probePlaces(const Part& part) {
    Json places = Json::array();
    for (const Probe& probe : part.probes) {
        places.push_back({probe.point.x, probe.point.y, probe.point.z});
        if (probe.normal)
            places.back().push_back({probe.normal->x, probe.normal->y, probe.normal->z});
    }
    return places;
}

void requireOneRun(const PartOfFile& part, const PartOfFile& first) {
    const Part& a = part.part;
    const Part& b = first.part;
    requireSame(part, first, "parts", a.of, b.of);
    requireSame(part, first, "scene", a.scene, b.scene);
    requireSame(part, first, "settings", a.settings, b.settings);
    requireSame(part, first, "camera", a.camera, b.camera);
    requireSame(part, first, "positions_of_run", a.positionsOfRun, b.positionsOfRun);
    requireSame(part, first, "size", {a.exposure.width, a.exposure.height},
                {b.exposure.width, b.exposure.height});
    requireSame(part, first, "probes", probePlaces(a), probePlaces(b));
    requireSame(part, first, "materials", a.materials, b.materials);
    requireSame(part, first, "nodes", a.nodes, b.nodes);
    requireSamePixels(part, first, "surface", a.exposure.surface, b.exposure.surface);
    requireSamePixels(part, first, "area", a.exposure.area, b.exposure.area);
    requireSamePixels(part, first, "material", a.exposure.material, b.exposure.material);
    requireSamePixels(part, first, "node", a.exposure.node, b.exposure.node);
}

/// The files in the order of their part numbers.
std::vector<const PartOfFile*> inOrder(const std::vector<PartOfFile>& parts) {
    std::vector<const PartOfFile*> byNumber(parts.front().part.of, nullptr);
    for (const PartOfFile& part : parts) {
        const PartOfFile*& place = byNumber[part.part.number - 1];
        if (place)
            throw InputError("'" + part.path + "': part is " + std::to_string(part.part.number) +
                             ", but '" + place->path + "' already has that number.");
        place = &part;
    }
    const auto missing = std::ranges::find(byNumber, nullptr);
    if (missing != byNumber.end())
        throw InputError("'" + parts.front().path + "': parts is " +
                         std::to_string(byNumber.size()) + ", but part " +
                         std::to_string(missing - byNumber.begin() + 1) + " is missing.");
    return byNumber;
}

} // namespace

Part merged(const std::vector<PartOfFile>& parts) {
    for (const PartOfFile& part : parts)
        requireOneRun(part, parts.front());
    const std::vector<const PartOfFile*> byNumber = inOrder(parts);

    Part whole = byNumber.front()->part;
    whole.number = whole.of = 1;
    for (std::size_t n = 1; n < byNumber.size(); ++n)
        std::ranges::transform(
            whole.exposure.lit, byNumber[n]->part.exposure.lit, whole.exposure.lit.begin(),
            [](std::uint16_t a, std::uint16_t b) { return static_cast<std::uint16_t>(a + b); });
    whole.positions.clear();
    for (Probe& probe : whole.probes)
        probe.lit.clear();
    for (std::size_t i = 0; i < whole.positionsOfRun; ++i) {
        const PartOfFile& from = *byNumber[i % byNumber.size()];
        const std::size_t index = i / byNumber.size();
        const Position& position = from.part.positions[index];
        if (!whole.positions.empty() && position.time <= whole.positions.back().time)
            throw InputError("'" + from.path + "': positions[" + std::to_string(index) +
                             "].time is not later than the position before it in the run.");
        whole.positions.push_back(position);
        for (std::size_t p = 0; p < whole.probes.size(); ++p)
            whole.probes[p].lit.push_back(from.part.probes[p].lit[index]);
    }
    return whole;
}

} // namespace edgeshade::hours
