#include "tests/fuzz/read_everything.hpp"

#include "preprocess/animation_reading.hpp"
#include "preprocess/error.hpp"
#include "preprocess/flatten.hpp"
#include "preprocess/pack.hpp"
#include "src/image/image_choice.hpp"

#include <cstdio>
#include <cstdlib>

namespace edgeshade::test {
namespace {

/// No file of this folder can be there, so that external ones are refused.
constexpr const char* path = "/proc/self/nothing/fuzz.glb";

ReadingLimits smallLimits() {
    ReadingLimits limits;
    limits.fileBytes = 1 << 20;
    limits.memoryBytes = 64 << 20;
    limits.triangles = 100'000;
    limits.nodes = 1'000;
    limits.nodeDepth = 50;
    return limits;
}

void requireSentence(const std::string& message) {
    const bool isSentence = message.find("fuzz.glb") != std::string::npos &&
                            message.size() < 2000 && message.ends_with('.') &&
                            !message.ends_with("..");
    if (isSentence) return;
    std::fprintf(stderr, "not a sentence that names the file: %s\n", message.c_str());
    std::abort();
}

/// Runs the part; returns whether it refused nothing.
template <class Part>
bool accepted(Part part) {
    try {
        part();
        return true;
    } catch (const InputError& error) {
        requireSentence(error.what());
        return false;
    }
}

void readShadowData(const GltfDocument& document) {
    const auto header = readShadowHeader(document);
    if (!header) return;
    Scene scene = flattenScene(document, header->settings.weldTolerance);
    readCasters(document, *header, scene);
    readShadows(document, *header, scene);
    buildAdapted(scene, header->settings.castMasked, header->settings.flatTolerance);
}

void readAnimationOf(const GltfDocument& document) {
    Warnings warnings;
    readAnimation(document, warnings);
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
    packBytes(input, Encoding::indexed, settings);
}

} // namespace

bool readEverything(std::span<const std::uint8_t> bytes) {
    std::optional<GltfDocument> document;
    if (!accepted([&] { document = parseGltf(bytes, path, smallLimits()); })) return false;
    bool all = accepted([&] { readShadowData(*document); });
    all &= accepted([&] { readAnimationOf(*document); });
    all &= accepted([&] { readImages(*document); });
    all &= accepted([&] { packAgain(std::move(*document)); });
    return all;
}

bool readImage(std::span<const std::uint8_t> bytes) {
    MemoryBudget memory(smallLimits());
    return accepted([&] { decodeImage(bytes, "'fuzz.glb': images[0]", memory); });
}

} // namespace edgeshade::test
