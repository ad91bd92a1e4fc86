// Files that exceed limits.
#include "tests/cli/bad_input.hpp"

namespace edgeshade::test {
namespace {

/// The sound scene after `change`, read with `options`.
BadInput limited(const std::string& name, const std::vector<std::string>& options,
                 const std::function<void(GltfBuilder&)>& change,
                 const std::vector<std::string>& words) {
    BadInput row = badScene(name, change, words);
    row.options = options;
    return row;
}

void asItIs(GltfBuilder&) {}

void withChild(GltfBuilder& gltf) {
    const int child = gltf.addNode({{"mesh", 0}}, false);
    gltf.json["nodes"][0]["children"] = Json::array({child});
}

/// Text of a glTF whose extras have `count` members.
std::string withMembers(int count) {
    std::string text = R"({"asset":{"version":"2.0"},"extras":{"first":0)";
    for (int i = 0; i < count; ++i)
        text += ",\"" + std::to_string(i) + "\":0";
    return text + "}}";
}

} // namespace

std::vector<BadInput> badLimits() {
    return {
        limited("FileTooLarge", {"--max-file", "100"}, asItIs, {"limit for a file is 100"}),
        limited("TooMuchMemory", {"--max-memory", "2K"}, asItIs, {"bytes of memory", "2048"}),
        limited("TooManyTriangles", {"--max-triangles", "11"}, asItIs,
                {"nodes[0]", "12 triangles", "11"}),
        limited("TooManyTrianglesOfOneMesh", {"--max-triangles", "23"}, withChild,
                {"nodes[1]", "24 triangles", "23"}),
        limited("TooManyNodes", {"--max-nodes", "1"}, withChild, {"nodes", "2", "limit", "1"}),
        limited("NodesTooDeep", {"--max-node-depth", "1"}, withChild,
                {"nodes[1]", "level 2", "limit is 1"}),
        {"ExternalFileTooLarge",
         [](const TempFolder& folder) {
             folder.write("scene.bin", Bytes(200'000));
             return folder.write("bad.gltf", std::string_view(soundScene().gltf("scene.bin")));
         },
         {"scene.bin", "200000", "100000"},
         {"info", "pack", "render"},
         {"--max-file", "100000"}},
        badText("ObjectOfTooManyMembers", withMembers(200'000), {"JSON object", "1000"}),
        limited("RepeatedBeyondMemory", {"--max-memory", "200M"},
                [](GltfBuilder& gltf) {
                    const int zeros =
                        gltf.addAccessor(-1, componentTypeOf<float>, 1'000'000, "VEC3");
                    Json primitive = {{"attributes", {{"POSITION", zeros}}}};
                    gltf.json["meshes"][0]["primitives"] = std::vector<Json>(300, primitive);
                },
                {"meshes[0].primitives[", "bytes of memory"}),
    };
}

} // namespace edgeshade::test
