// KHR_draco_mesh_compression and EXT_meshopt_compression.
#include "tests/cli/bad_input.hpp"
#include "tests/support/draco_encoding.hpp"
#include "tests/support/meshopt_encoding.hpp"

namespace edgeshade::test {
namespace {

/// A scene compressed by Draco, with its primitive changed.
BadInput
withDraco(const std::string& name,
          const std::function<void(GltfBuilder&, Json& primitive, Json& extension)>& change,
          const std::vector<std::string>& words) {
    return badBytes(
        name,
        [change] {
            GltfBuilder gltf;
            gltf.useExtension(dracoExtension);
            Json primitive = dracoPrimitive(gltf, box(glm::vec3(1.0f)));
            change(gltf, primitive, primitive["extensions"][dracoExtension]);
            gltf.addNode({{"mesh", gltf.addMesh(primitive)}});
            return gltf.glb();
        },
        words);
}

/// The same with the stream replaced.
BadInput withStream(const std::string& name, const std::function<Bytes(Bytes)>& change) {
    return withDraco(name,
                     [change](GltfBuilder& gltf, Json&, Json& extension) {
                         extension["bufferView"] =
                             gltf.addView(change(dracoEncoded(box(glm::vec3(1.0f)))));
                     },
                     {dracoExtension});
}

/// A scene compressed by meshopt, with one key of the first view's extension changed.
BadInput withMeshopt(const std::string& name, const std::string& key, const Json& value,
                     const std::vector<std::string>& words) {
    return badBytes(
        name,
        [=] {
            GltfBuilder gltf = meshoptScene(box(glm::vec3(1.0f)));
            Json& view = gltf.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
            view[key] = value;
            if (value.is_null()) view.erase(key);
            return gltf.glb();
        },
        words);
}

} // namespace

std::vector<BadInput> badCompression() {
    return {
        withStream("DracoGarbage", [](const Bytes&) { return Bytes(200, 0x5A); }),
        withStream("DracoWithoutBytes", [](const Bytes&) { return Bytes(); }),
        withStream("DracoCutOff",
                   [](Bytes stream) {
                       stream.resize(stream.size() / 2);
                       return stream;
                   }),
        withStream("DracoHeaderAlone",
                   [](Bytes stream) {
                       stream.resize(12);
                       return stream;
                   }),
        withDraco("DracoWithoutView",
                  [](GltfBuilder&, Json&, Json& extension) { extension.erase("bufferView"); },
                  {dracoExtension, "bufferView"}),
        withDraco("DracoOfNoView",
                  [](GltfBuilder&, Json&, Json& extension) { extension["bufferView"] = 99; },
                  {"99"}),
        withDraco("DracoWithoutAttributes",
                  [](GltfBuilder&, Json&, Json& extension) { extension.erase("attributes"); },
                  {dracoExtension, "attributes"}),
        withDraco(
            "DracoAttributeThatIsNotThere",
            [](GltfBuilder&, Json&, Json& extension) { extension["attributes"]["NORMAL"] = 99; },
            {"attributes.NORMAL", "99"}),
        withDraco(
            "DracoAttributeIsText",
            [](GltfBuilder&, Json&, Json& extension) { extension["attributes"]["NORMAL"] = "one"; },
            {"NORMAL"}),
        withDraco("DracoAttributeOfAnotherKind",
                  [](GltfBuilder&, Json&, Json& extension) {
                      extension["attributes"]["POSITION"] = 2; // texture coordinates
                  },
                  {"POSITION"}),
        withDraco("DracoLines", [](GltfBuilder&, Json& primitive, Json&) { primitive["mode"] = 6; },
                  {dracoExtension, "mode"}),
        withDraco("DracoExtensionIsANumber",
                  [](GltfBuilder&, Json&, Json& extension) { extension = 7; }, {dracoExtension}),
        withMeshopt("MeshoptUnknownMode", "mode", "ZIP", {"bufferViews[0]", "mode", "ZIP"}),
        withMeshopt("MeshoptModeIsMissing", "mode", nullptr, {"mode"}),
        withMeshopt("MeshoptWrongMode", "mode", "TRIANGLES", {"bufferViews[0]"}),
        withMeshopt("MeshoptStrideOfZero", "byteStride", 0, {"bufferViews[0]", "byteStride", "0"}),
        withMeshopt("MeshoptStrideNoMultipleOf4", "byteStride", 13, {"byteStride", "13"}),
        withMeshopt("MeshoptStrideTooLarge", "byteStride", 512, {"byteStride", "512"}),
        withMeshopt("MeshoptStrideNegative", "byteStride", -12, {"byteStride"}),
        withMeshopt("MeshoptHugeCount", "count", 150000000, {"bufferViews[0]"}),
        withMeshopt("MeshoptCountThatOverflows", "count", 1537228672809129302, {"count"}),
        withMeshopt("MeshoptCountNegative", "count", -24, {"count"}),
        withMeshopt("MeshoptCountTooLarge", "count", 1000, {"bufferViews[0]"}),
        withMeshopt("MeshoptCountTooSmall", "count", 10, {"bufferViews[0]"}),
        withMeshopt("MeshoptUnknownFilter", "filter", "SHARPEN", {"filter", "SHARPEN"}),
        withMeshopt("MeshoptFilterOfAnotherStride", "filter", "OCTAHEDRAL", {"filter"}),
        withMeshopt("MeshoptOfNoBuffer", "buffer", 99, {"bufferViews[0]", "99"}),
        withMeshopt("MeshoptOfItsFallback", "buffer", 1, {"bufferViews[0]"}),
        withMeshopt("MeshoptPastItsBuffer", "byteLength", 1000000, {"bufferViews[0]"}),
        withMeshopt("MeshoptCutOff", "byteLength", 20, {"bufferViews[0]"}),
        withMeshopt("MeshoptNegativeOffset", "byteOffset", -1, {"bufferViews[0]"}),
        withMeshopt("MeshoptCountIsText", "count", "24", {}),
        badBytes("MeshoptGarbage",
                 [] {
                     GltfBuilder gltf = meshoptScene(box(glm::vec3(1.0f)));
                     std::fill_n(gltf.binary.begin(), 60, std::uint8_t{0x5A});
                     return gltf.glb();
                 },
                 {"bufferViews[0]"}),
        badBytes("MeshoptCountThatNoBytesHold",
                 [] {
                     GltfBuilder gltf = meshoptScene(box(glm::vec3(1.0f)));
                     Json& view = gltf.json["bufferViews"][0];
                     view["byteLength"] = 1800000000;
                     view["extensions"]["EXT_meshopt_compression"]["count"] = 150000000;
                     gltf.json["buffers"][1]["byteLength"] = 2000000000;
                     return gltf.glb();
                 },
                 {"bufferViews[0]", "count", "150000000"}),
        badBytes("MeshoptTrianglesNotBy3",
                 [] {
                     GltfBuilder gltf = meshoptScene(box(glm::vec3(1.0f)));
                     gltf.json["bufferViews"][2]["extensions"]["EXT_meshopt_compression"]["count"] =
                         35;
                     return gltf.glb();
                 },
                 {"bufferViews[2]", "35"}),
    };
}

} // namespace edgeshade::test
