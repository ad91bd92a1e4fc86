#include "tests/fuzz/read_everything.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/packing/pack.hpp"
#include "preprocess/reading/animation_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "src/image/decode.hpp"
#include "src/image/image_choice.hpp"
#include "tests/fuzz/refusal.hpp"

#include <optional>

namespace edgeshade::test {
namespace {

void readShadowData(const GltfDocument& document) {
    const auto header = readShadowHeader(document);
    if (!header) return;
    Scene scene =
        flattenScene(document, header->settings.weldTolerance, {}, header->settings.instances);
    readCasters(document, *header, scene);
    readShadows(document, *header, scene);
    buildPlanePairs(scene, header->settings.castMasked, header->settings.flatTolerance);
}

/// Reads every animation, and poses deforming batches in a few poses.
void readAnimationsOf(const GltfDocument& document) {
    Warnings warnings;
    readAnimation(document, warnings);
    Scene scene = flattenScene(document, 0.0);
    auto shadows = buildPlanePairs(scene, true);
    for (const AnimationTitle& title : animationTitles(document)) {
        const auto animation = readAnimation(document, warnings, title.index);
        if (!animation) continue;
        for (const double share : {0.0, 0.4, 1.0}) {
            const std::vector<Placed> placed =
                place(scene, poseAt(*animation, scene, share * animation->duration));
            for (std::size_t b = 0; b < placed.size(); ++b)
                if (placed[b].reshaped)
                    shadows[b] = std::make_shared<const PlanePairShadow>(
                        posedPlanePairs(*shadows[b], scene.batches[b]));
        }
    }
}

void readImages(const GltfDocument& document) {
    Scene scene = flattenScene(document, 0.0);
    scene.warnings = {};
    decodeImages(document, scene);
    for (const std::string& warning : scene.warnings.sentences())
        requireSentence(warning);
}

void packAgain(GltfDocument document) {
    const auto header = readShadowHeader(document);
    const CasterSettings settings = header ? header->settings : CasterSettings();
    PackInput input = readForPacking(std::move(document), settings, true);
    packBytes(input, Encoding::indexed);
}

} // namespace

bool readEverything(std::span<const std::uint8_t> bytes) {
    std::optional<GltfDocument> document;
    if (!accepted([&] { document = parseGltf(bytes, fuzzedPath, smallLimits()); })) return false;
    bool all = accepted([&] { readShadowData(*document); });
    all &= accepted([&] { readAnimationsOf(*document); });
    all &= accepted([&] { readImages(*document); });
    all &= accepted([&] { packAgain(std::move(*document)); });
    return all;
}

bool readImage(std::span<const std::uint8_t> bytes) {
    MemoryBudget memory(smallLimits());
    return accepted([&] { decodeImage(bytes, "'fuzz.glb': images[0]", memory); });
}

} // namespace edgeshade::test
