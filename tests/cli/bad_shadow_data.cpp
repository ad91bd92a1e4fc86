// Packed files with tampered shadow data: reading refuses them. (`pack` rebuilds the data, and
// `info` reports on the geometry.)
#include "tests/cli/bad_input.hpp"
#include "tests/support/packing.hpp"

namespace edgeshade::test {
namespace {

BadInput tampered(const std::string& name, Encoding encoding,
                  const std::function<void(GlbParts&, Json& extension)>& change,
                  const std::vector<std::string>& words) {
    BadInput row = badBytes(
        name,
        [=] {
            GlbParts parts(packed(soundScene().glb(), encoding));
            change(parts, parts.json["extensions"][shadowExtensionName]);
            return parts.glb();
        },
        words);
    row.words.push_back(shadowExtensionName);
    row.verbs = {"render"};
    return row;
}

std::uint8_t& firstByte(GlbParts& parts, const Json& accessor) {
    return parts.binary[parts.offsetOf(accessor.get<int>())];
}

} // namespace

std::vector<BadInput> badShadowData() {
    std::vector<BadInput> rows = {
        tampered("ShadowsOfOtherPositions", Encoding::indexed,
                 [](GlbParts& parts, Json&) { firstByte(parts, 0) ^= 1; },
                 {"positionsHash", "changed after packing"}),
        tampered("ShadowEdgeOutOfRange", Encoding::indexed,
                 [](GlbParts& parts, Json& extension) {
                     firstByte(parts, extension["batches"][0]["edgeVertices"]) = 0xFF;
                 },
                 {"batches[0].edgeVertices", "does not decode"}),
        tampered("SimplifiedCastersMissing", Encoding::none,
                 [](GlbParts&, Json& extension) { extension["casterError"] = 0.5; },
                 {"batches[0].simplifiedTriangles", "missing"}),
        tampered("ShadowRecordOfUnknownOrder", Encoding::expanded,
                 [](GlbParts& parts, Json& extension) {
                     const float order = 7.0f;
                     std::memcpy(&firstByte(parts, extension["batches"][0]["sides"]) + 44, &order,
                                 sizeof order);
                 },
                 {"batches[0].sides", "7"}),
        tampered("ShadowAccessorOutOfRange", Encoding::expanded,
                 [](GlbParts&, Json& extension) { extension["batches"][0]["caps"] = 999; },
                 {"batches[0].caps", "999"}),
        tampered("ShadowsOfAnotherVersion", Encoding::none,
                 [](GlbParts&, Json& extension) { extension["version"] = 3; }, {".version is 3"}),
        tampered("ShadowBatchMissing", Encoding::indexed,
                 [](GlbParts&, Json& extension) { extension["batches"].clear(); },
                 {".batches has 0"}),
        tampered("ShadowBatchesGone", Encoding::indexed,
                 [](GlbParts&, Json& extension) { extension.erase("batches"); }, {"batches"}),
        tampered(
            "ShadowAccessorIsText", Encoding::indexed,
            [](GlbParts&, Json& extension) { extension["batches"][0]["oppositeCounts"] = "all"; },
            {"oppositeCounts"}),
        tampered("ShadowExtensionIsANumber", Encoding::none,
                 [](GlbParts&, Json& extension) { extension = 7; }, {}),
    };
    // For an extension that can't be interpreted, every verb refuses.
    for (std::size_t i = rows.size() - 3; i < rows.size(); ++i)
        rows[i].verbs = {"info", "pack", "render"};
    return rows;
}

} // namespace edgeshade::test
