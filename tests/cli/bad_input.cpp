#include "tests/cli/bad_input.hpp"

namespace edgeshade::test {

BadInput badBytes(const std::string& name, const std::function<Bytes()>& bytes,
                  const std::vector<std::string>& words) {
    return {name, [bytes](const TempFolder& folder) { return folder.write("bad.glb", bytes()); },
            words};
}

BadInput badText(const std::string& name, const std::string& text,
                 const std::vector<std::string>& words) {
    return {name,
            [text](const TempFolder& folder) {
                return folder.write("bad.gltf", std::string_view(text));
            },
            words};
}

BadInput badScene(const std::string& name, const std::function<void(GltfBuilder&)>& change,
                  const std::vector<std::string>& words) {
    return badBytes(
        name,
        [change] {
            GltfBuilder gltf = soundScene();
            change(gltf);
            return gltf.glb();
        },
        words);
}

BadInput warned(BadInput row) {
    row.warned = true;
    return row;
}

GltfBuilder soundScene() {
    GltfBuilder gltf;
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    gltf.json["samplers"] = Json::array({Json::object()});
    gltf.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    gltf.addMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    gltf.animate(gltf.addShapeNode(box(glm::vec3(1.0f)), {{"material", 0}}));
    return gltf;
}

Json& primitiveOf(GltfBuilder& gltf) {
    return gltf.json["meshes"][0]["primitives"][0];
}

} // namespace edgeshade::test
