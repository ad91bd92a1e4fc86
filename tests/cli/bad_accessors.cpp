// Accessors, and their use in primitives.
#include "tests/cli/bad_input.hpp"

#include <limits>

namespace edgeshade::test {
namespace {

/// The sound scene with one key of an accessor changed.
BadInput withAccessor(const std::string& name, int accessor, const std::string& key,
                      const Json& value, const std::vector<std::string>& words) {
    return badScene(
        name, [=](GltfBuilder& gltf) { gltf.json["accessors"][accessor][key] = value; }, words);
}

/// The sound scene with an attribute of its primitive replaced by a new accessor.
template <class T>
BadInput withAttribute(const std::string& name, const std::string& attribute,
                       const std::vector<T>& values, int components) {
    return badScene(name,
                    [=](GltfBuilder& gltf) {
                        primitiveOf(gltf)["attributes"][attribute] =
                            gltf.addArray(values, components);
                    },
                    {attribute});
}

/// The sound scene with the first coordinate replaced.
BadInput withCoordinate(const std::string& name, float value, const std::string& word) {
    return badScene(
        name, [value](GltfBuilder& gltf) { std::memcpy(gltf.binary.data(), &value, sizeof value); },
        {"POSITION", word, "element 0"});
}

/// The sound scene with a changed `sparse` member on its positions.
BadInput withSparse(const std::string& name, const Json& change,
                    const std::vector<std::string>& words) {
    return badScene(
        name,
        [change](GltfBuilder& gltf) {
            const int indices = gltf.addView(bytesOf(std::vector<std::uint16_t>{1, 2}));
            const int values = gltf.addView(Bytes(24));
            Json& sparse = gltf.json["accessors"][0]["sparse"];
            sparse = {{"count", 2},
                      {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                      {"values", {{"bufferView", values}}}};
            sparse.merge_patch(change);
        },
        words);
}

std::vector<BadInput> accessorRows() {
    return {
        withAccessor("AccessorOfNoView", 0, "bufferView", 99, {"99"}),
        withAccessor("AccessorOfANegativeView", 0, "bufferView", -3, {}),
        withAccessor("AccessorPastItsView", 0, "count", 1000, {"accessors[0]", "1000"}),
        withAccessor("AccessorOffsetPastItsView", 0, "byteOffset", 1000000, {"accessors[0]"}),
        withAccessor("AccessorOfNegativeOffset", 0, "byteOffset", -12, {"accessors[0]"}),
        withAccessor("AccessorOfNegativeCount", 0, "count", -24, {"accessors[0]"}),
        withAccessor("AccessorCountIsText", 0, "count", "24", {"count"}),
        withAccessor("AccessorCountIsMissing", 0, "count", nullptr, {"count"}),
        withAccessor("AccessorOfHugeCount", 0, "count", 1000000000, {"1000000000"}),
        withAccessor("AccessorCountThatOverflows32Bits", 0, "count", 4294967320, {}),
        withAccessor("AccessorCountThatOverflowsItsBytes", 0, "count", 1537228672809129302, {}),
        withAccessor("AccessorCountPast64Bits", 0, "count", 1e30, {}),
        withAccessor("AccessorOfUnknownType", 0, "type", "VEC9", {"type"}),
        withAccessor("AccessorTypeIsANumber", 0, "type", 3, {"type"}),
        withAccessor("AccessorTypeIsMissing", 0, "type", nullptr, {"type"}),
        withAccessor("AccessorOfUnknownComponentType", 0, "componentType", 5555, {"componentType"}),
        withAccessor("AccessorOfDoubles", 0, "componentType", 5130, {"componentType"}),
        withAccessor("AccessorNormalizedIsText", 0, "normalized", "yes",
                     {"accessors[0].normalized", "yes"}),
        withAccessor("PositionsOfTwoComponents", 0, "type", "VEC2", {"POSITION", "2 components"}),
        withAccessor("PositionsThatAreScalars", 0, "type", "SCALAR", {"POSITION"}),
        withAccessor("IndicesThatAreFloats", 3, "componentType", 5126, {"indices", "5126"}),
        withAccessor("IndicesThatAreSigned", 3, "componentType", 5122, {"indices", "5122"}),
        withAccessor("IndicesThatAreVectors", 3, "type", "VEC2", {"indices"}),
        badScene("HugeCountWithoutData",
                 [](GltfBuilder& gltf) {
                     gltf.json["accessors"][0].erase("bufferView");
                     gltf.json["accessors"][0]["count"] = 1000000000;
                 },
                 {"1000000000"}),
    };
}

std::vector<BadInput> primitiveRows() {
    return {
        badScene("PositionOfNoAccessor",
                 [](GltfBuilder& gltf) { primitiveOf(gltf)["attributes"]["POSITION"] = 99; },
                 {"POSITION", "99"}),
        badScene("PositionOfANegativeAccessor",
                 [](GltfBuilder& gltf) { primitiveOf(gltf)["attributes"]["POSITION"] = -1; },
                 {"POSITION"}),
        badScene("IndicesOfNoAccessor",
                 [](GltfBuilder& gltf) { primitiveOf(gltf)["indices"] = 99; }, {"indices", "99"}),
        badScene("IndexOutOfRange",
                 [](GltfBuilder& gltf) {
                     primitiveOf(gltf)["indices"] = gltf.addIndices<std::uint32_t>({0, 1, 24});
                 },
                 {"indices", "24"}),
        badScene(
            "LargestIndex",
            [](GltfBuilder& gltf) {
                primitiveOf(gltf)["indices"] = gltf.addIndices<std::uint32_t>({0, 1, 0xFFFFFFFF});
            },
            {"indices", "4294967295"}),
        withCoordinate("PositionThatIsNaN", std::numeric_limits<float>::quiet_NaN(), "NaN"),
        withCoordinate("PositionThatIsInfinite", -std::numeric_limits<float>::infinity(),
                       "infinite"),
        withAttribute("NormalsThatAreNaN", "NORMAL",
                      std::vector<float>(72, std::numeric_limits<float>::quiet_NaN()), 3),
        withAttribute("TexcoordsThatAreInfinite", "TEXCOORD_0",
                      std::vector<float>(48, std::numeric_limits<float>::infinity()), 2),
        withAttribute("TooFewNormals", "NORMAL", std::vector<float>(9), 3),
        withAttribute("NormalsOfTwoComponents", "NORMAL", std::vector<float>(48), 2),
        withAttribute("TooManyTexcoords", "TEXCOORD_0", std::vector<float>(60), 2),
        withAttribute("TexcoordsThatAreScalars", "TEXCOORD_0", std::vector<float>(24), 1),
        withAttribute("TooFewColors", "COLOR_0", std::vector<float>(9), 3),
        withAttribute("ColorsThatAreMatrices", "COLOR_0", std::vector<float>(24 * 16), 16),
        badScene("MorphTargetOfAnotherSize",
                 [](GltfBuilder& gltf) {
                     primitiveOf(gltf)["targets"] = {
                         {{"POSITION", gltf.addVectors(std::vector<glm::vec3>(5))}}};
                     gltf.json["meshes"][0]["weights"] = {1.0};
                 },
                 {"targets[0].POSITION"}),
        badScene("MorphTargetOfNoAccessor",
                 [](GltfBuilder& gltf) {
                     primitiveOf(gltf)["targets"] = {{{"POSITION", 99}}};
                     gltf.json["meshes"][0]["weights"] = {1.0};
                 },
                 {"targets[0].POSITION", "99"}),
        badScene("MorphTargetsAreANumber",
                 [](GltfBuilder& gltf) { primitiveOf(gltf)["targets"] = {7}; }, {}),
    };
}

std::vector<BadInput> sparseRows() {
    return {
        withSparse("SparseIndexOutOfRange", {{"count", 1}, {"indices", {{"componentType", 5125}}}},
                   {"accessors[0]", "sparse.indices", "131073"}),
        withSparse("SparseCountTooLarge", {{"count", 1000}}, {"sparse"}),
        withSparse("SparseCountNegative", {{"count", -1}}, {"sparse"}),
        withSparse("SparseCountPastItsView", {{"count", 20}}, {"sparse"}),
        withSparse("SparseIndicesOfNoView", {{"indices", {{"bufferView", 99}}}}, {"99"}),
        withSparse("SparseValuesOfNoView", {{"values", {{"bufferView", 99}}}}, {"99"}),
        withSparse("SparseIndicesThatAreFloats", {{"indices", {{"componentType", 5126}}}},
                   {"sparse.indices.componentType", "5126"}),
        withSparse("SparseValuesOfNegativeOffset", {{"values", {{"byteOffset", -12}}}}, {"sparse"}),
        withSparse("SparseWithoutIndices", {{"indices", nullptr}}, {"indices"}),
        withSparse("SparseWithoutValues", {{"values", nullptr}}, {"values"}),
    };
}

} // namespace

std::vector<BadInput> badAccessors() {
    std::vector<BadInput> rows;
    for (const auto& part : {accessorRows, primitiveRows, sparseRows})
        for (BadInput& row : part())
            rows.push_back(std::move(row));
    return rows;
}

} // namespace edgeshade::test
