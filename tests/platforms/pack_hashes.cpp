// pack_hashes [FILE...]: packs scenes drawn in code, then the files, in every possible way, and
// prints a line "HASH BYTES WAY SCENE" for each. Built for every platform: the lines must be the
// same. The scenes use no mathematical function except roots, which are exact everywhere.
#include "preprocess/base/error.hpp"
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/packing/pack.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/hard_lights.hpp"

#include <cstdio>
#include <iostream>

namespace edgeshade::test {
namespace {

struct Way {
    const char* name;
    Encoding encoding;
    CasterSettings settings;
};

/// Lengths are shares of the scene's diagonal.
std::vector<Way> waysFor(double diagonal) {
    CasterSettings welded, chosen, flat, simplified, masked;
    chosen.autoWeld = true;
    welded.weldTolerance = 1e-4 * diagonal;
    flat.flatTolerance = 2.0;
    simplified.casterError = 1e-3 * diagonal;
    masked.castMasked = true;
    return {{"none", Encoding::none, {}},
            {"indexed", Encoding::indexed, {}},
            {"expanded", Encoding::expanded, {}},
            {"cast-masked", Encoding::expanded, masked},
            {"weld-tolerance", Encoding::indexed, welded},
            {"weld-tolerance auto", Encoding::indexed, chosen},
            {"flat-tolerance", Encoding::none, flat},
            {"caster-error", Encoding::indexed, simplified}};
}

/// FNV-1a, 64 bits.
std::uint64_t hashOf(const Bytes& bytes) {
    std::uint64_t hash = 0xCBF29CE484222325u;
    for (const std::uint8_t byte : bytes)
        hash = (hash ^ byte) * 0x100000001B3u;
    return hash;
}

/// Hills of random height, with normals.
Shape hills(std::uint32_t side, std::uint64_t seed) {
    Random random(seed);
    Shape shape;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            shape.positions.emplace_back(x / 7.0, random.uniform(0, 0.4), y / 11.0);
            shape.normals.emplace_back(glm::normalize(glm::dvec3(random.inCube())));
        }
    for (std::uint32_t y = 0; y + 1 < side; ++y)
        for (std::uint32_t x = 0; x + 1 < side; ++x) {
            const std::uint32_t p = y * side + x;
            shape.indices.insert(shape.indices.end(), {p, p + side, p + 1});
            shape.indices.insert(shape.indices.end(), {p + 1, p + side, p + side + 1});
        }
    return shape;
}

/// Static and animated nodes with every kind of transform, MASK and BLEND surfaces, survey
/// coordinates.
GltfBuilder variedScene() {
    GltfBuilder gltf;
    gltf.addMaterial({{"alphaMode", "MASK"}});
    gltf.addMaterial({{"alphaMode", "BLEND"}});
    gltf.addShapeNode(box(glm::vec3(1.0f, 2.0f, 3.0f)));
    gltf.addShapeNode(hills(20, 7), {{"material", 0}});
    gltf.addShapeNode(tetrahedron(), {{"material", 1}});
    const int hillsMesh = gltf.addShape(hills(60, 8));
    gltf.addNode({{"mesh", hillsMesh},
                  {"translation", {431234.125, 5412345.25, 0.3}},
                  {"rotation", {0.18257418, 0.36514837, 0.5477226, 0.73029673}},
                  {"scale", {1.25, -0.7, 3.3}}});
    gltf.addNode({{"mesh", hillsMesh}, {"rotation", {0.5, 0.5, 0.5, 0.5}}});
    const int animatedNode = gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(0.5f)))},
                                           {"translation", {1e5, 3, 0.25}},
                                           {"rotation", {0.1, 0.2, 0.3, 0.92736185}}});
    gltf.animate(animatedNode);
    return gltf;
}

void print(const std::string& name, const Bytes& asset, const std::filesystem::path& path) {
    const double diagonal =
        readForPacking(parseGltf(asset, path), CasterSettings(), false).report.diagonal;
    for (const Way& way : waysFor(diagonal)) {
        PackInput input = readForPacking(parseGltf(asset, path), way.settings, false);
        const Bytes packed = packBytes(input, way.encoding);
        char hash[17];
        std::snprintf(hash, sizeof hash, "%016llx",
                      static_cast<unsigned long long>(hashOf(packed)));
        std::cout << hash << ' ' << packed.size() << ' ' << way.name << ' ' << name << '\n';
    }
    std::cout << std::flush;
}

void printAll(std::span<char*> files) {
    GltfBuilder plain;
    plain.addShapeNode(hills(90, 9));
    print("hills", plain.glb(), "hills.glb");
    print("varied", variedScene().glb(), "varied.glb");
    for (const char* file : files)
        print(std::filesystem::path(file).filename().string(), readFile(file), file);
}

} // namespace
} // namespace edgeshade::test

int main(int argc, char** argv) {
    try {
        edgeshade::test::printAll(std::span(argv + 1, static_cast<std::size_t>(argc - 1)));
    } catch (const edgeshade::Error& error) {
        std::cerr << "pack_hashes: " << error.what() << '\n';
        return static_cast<int>(error.status());
    }
}
