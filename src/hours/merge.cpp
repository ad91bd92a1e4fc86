#include "src/hours/merge.hpp"

#include "src/hours/one_run.hpp"

#include <algorithm>

namespace edgeshade::hours {
namespace {

using Json = nlohmann::ordered_json;

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
    const OneRun run(part.path, first.path);
    run.requireSame("parts", a.of, b.of);
    run.requireSame("scene", a.scene, b.scene);
    run.requireSame("settings", a.settings, b.settings);
    run.requireSame("camera", a.camera, b.camera);
    run.requireSame("positions_of_run", a.positionsOfRun, b.positionsOfRun);
    run.requireSame("size", {a.exposure.width, a.exposure.height},
                    {b.exposure.width, b.exposure.height});
    run.requireSame("probes", probePlaces(a), probePlaces(b));
    run.requireSame("materials", a.materials, b.materials);
    run.requireSame("nodes", a.nodes, b.nodes);
    const auto requirePixels = [&](const char* field, const auto& pixels, const auto& firstPixels) {
        run.requireSameArrays(std::string("pixels.") + field, "pixel", pixels, firstPixels);
    };
    requirePixels("surface", a.exposure.surface, b.exposure.surface);
    requirePixels("area", a.exposure.area, b.exposure.area);
    requirePixels("material", a.exposure.material, b.exposure.material);
    requirePixels("node", a.exposure.node, b.exposure.node);
}

} // namespace

Part merged(const std::vector<PartOfFile>& parts) {
    std::vector<NumberedFile> files;
    for (const PartOfFile& part : parts) {
        requireOneRun(part, parts.front());
        files.push_back({part.path, part.part.number});
    }
    std::vector<const PartOfFile*> byNumber;
    for (const std::size_t i : partsInOrder(files, parts.front().part.of))
        byNumber.push_back(&parts[i]);

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
        requireLater(position, whole.positions, from.path, index);
        whole.positions.push_back(position);
        for (std::size_t p = 0; p < whole.probes.size(); ++p)
            whole.probes[p].lit.push_back(from.part.probes[p].lit[index]);
    }
    return whole;
}

} // namespace edgeshade::hours
