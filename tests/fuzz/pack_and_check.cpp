#include "tests/fuzz/pack_and_check.hpp"

#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/gltf/image_type.hpp"
#include "preprocess/packing/pack.hpp"
#include "preprocess/packing/packed_file.hpp"
#include "preprocess/reading/flatten.hpp"
#include "tests/fuzz/gltf_structure.hpp"
#include "tests/fuzz/refusal.hpp"
#include "tests/support/packing.hpp"

#include <cstdio>
#include <cstdlib>
#include <limits>

namespace edgeshade::test {
namespace {

/// Packed files may be larger than their sources.
ReadingLimits limitsOfPacked() {
    ReadingLimits limits = smallLimits();
    limits.fileBytes = limits.memoryBytes = std::numeric_limits<std::uint64_t>::max();
    return limits;
}

[[noreturn]] void fail(const std::string& what) {
    std::fprintf(stderr, "the packed file: %s\n", what.c_str());
    std::abort();
}

void require(bool holds, const char* what) {
    if (!holds) fail(what);
}

template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// One of several choices, determined by the bytes.
std::size_t chosen(std::span<const std::uint8_t> bytes) {
    std::size_t sum = 0;
    for (const std::uint8_t byte : bytes)
        sum = 31 * sum + byte;
    return sum;
}

CasterSettings settingsFor(const GltfDocument& document, std::size_t choice) {
    if (const auto header = readShadowHeader(document)) return header->settings;
    CasterSettings settings;
    if (choice % 4 == 0) settings = {0.01, true, 0.1, 5.0};
    return settings;
}

/// Unlike packBytes(), it doesn't read its result.
Bytes packedOf(const PackInput& input, Encoding encoding, const CasterSettings& settings) {
    Warnings warnings;
    Bytes bytes =
        packedGlb(input.document, input.scene, input.topology, encoding, settings, warnings);
    for (const std::string& warning : warnings.sentences())
        requireSentence(warning);
    return bytes;
}

void requireSameGeometry(const Geometry& a, const Geometry& b) {
    require(sameBits(a.positions, b.positions), "has other positions");
    require(sameBits(a.indices, b.indices), "has other triangles");
    require(sameBits(a.normals, b.normals) && sameBits(a.texcoords, b.texcoords) &&
                sameBits(a.colors, b.colors),
            "has other attributes");
    require(sameBits(a.groups, b.groups), "has other groups");
}

void requireSameScene(const Scene& packed, const Scene& source) {
    require(packed.batches.size() == source.batches.size(), "has other batches");
    for (std::size_t i = 0; i < source.batches.size(); ++i) {
        const Batch& a = packed.batches[i];
        const Batch& b = source.batches[i];
        require(a.node == b.node && a.worldFromBatch == b.worldFromBatch &&
                    a.nodeFromBatch == b.nodeFromBatch,
                "has a batch elsewhere");
        requireSameGeometry(*a.geometry, *b.geometry);
    }
    require(firstOfGeometry(packed.batches) == firstOfGeometry(source.batches),
            "shares its meshes otherwise");
}

void requireSameShadows(const Shadows& read, const Topologies& topology, int maxMultiplicity) {
    require(read.size() == topology.size(), "has other shadow data");
    for (std::size_t i = 0; i < read.size(); ++i) {
        const BatchShadow built = buildShadow(*topology[i], maxMultiplicity);
        require(sameBits(read[i]->sides.records, built.sides.records), "has other sides");
        require(sameBits(read[i]->caps.records, built.caps.records), "has other caps");
    }
}

void requireSamePictures(const GltfDocument& packed, const GltfDocument& source) {
    if (!source.json.contains("images")) return;
    for (int i = 0; i < static_cast<int>(source.json["images"].size()); ++i) {
        Bytes bytes; // some images can't be decoded
        if (!accepted([&] { bytes = encodedImageBytes(source, i); })) continue;
        require(encodedImageBytes(packed, i) == bytes, "has other pictures");
        const auto& image = packed.json["images"][static_cast<std::size_t>(i)];
        require(imageTypeOf(bytes).empty() || !image.contains("uri"), "has a picture elsewhere");
    }
}

void requireSoundStructure(const Bytes& packed, const GltfDocument& source) {
    const std::set<std::string> before = structuralFaults(source.json);
    for (const std::string& fault : structuralFaults(packed))
        if (!before.contains(fault)) fail(fault);
}

void check(const Bytes& bytes, const PackInput& source, Encoding encoding,
           const CasterSettings& settings) {
    requireSoundStructure(bytes, source.document);
    GltfDocument packed = parseGltf(bytes, fuzzedPath, limitsOfPacked());
    const auto header = readShadowHeader(packed);
    require(header && header->encoding == encoding && header->settings == settings,
            "has other settings");
    Scene scene = flattenScene(packed, settings.weldTolerance, {}, settings.instances);
    requireSameScene(scene, source.scene);
    requireSamePictures(packed, source.document);
    readCasters(packed, *header, scene);
    requireSameShadows(readShadows(packed, *header, scene), source.topology,
                       header->maxMultiplicity);
    const PackInput again = readForPacking(std::move(packed), settings, true);
    require(packedOf(again, encoding, settings) == bytes, "packs to other bytes");
}

} // namespace

bool packAndCheck(std::span<const std::uint8_t> bytes) {
    const std::size_t choice = chosen(bytes);
    const Encoding encoding = everyEncoding[choice % std::size(everyEncoding)];
    PackInput source;
    CasterSettings settings;
    Bytes packed;
    const bool isPacked = accepted([&] {
        GltfDocument document = parseGltf(bytes, fuzzedPath, smallLimits());
        settings = settingsFor(document, choice / std::size(everyEncoding));
        source = readForPacking(std::move(document), settings, true);
        packed = packedOf(source, encoding, settings);
    });
    if (!isPacked) return false;
    try {
        check(packed, source, encoding, settings);
    } catch (const InputError& error) {
        fail(std::string("is refused: ") + error.what());
    }
    return true;
}

} // namespace edgeshade::test
