// Nodes, scenes, skins and materials.
#include "tests/cli/bad_input.hpp"

namespace edgeshade::test {
namespace {

/// The sound scene with one key of its node changed.
BadInput withNode(const std::string& name, const std::string& key, const Json& value,
                  const std::vector<std::string>& words) {
    return badScene(
        name, [=](GltfBuilder& gltf) { gltf.json["nodes"][0][key] = value; }, words);
}

/// The sound scene, skinned by its own node, after `change`.
BadInput withSkin(const std::string& name, const std::function<void(GltfBuilder&)>& change,
                  const std::vector<std::string>& words) {
    return badScene(
        name,
        [change](GltfBuilder& gltf) {
            std::vector<float> bind(16, 0.0f);
            bind[0] = bind[5] = bind[10] = bind[15] = 1.0f;
            gltf.json["skins"] = {
                {{"joints", Json::array({0})}, {"inverseBindMatrices", gltf.addArray(bind, 16)}}};
            gltf.json["nodes"][0]["skin"] = 0;
            primitiveOf(gltf)["attributes"]["JOINTS_0"] =
                gltf.addArray(std::vector<std::uint8_t>(96, 0), 4);
            primitiveOf(gltf)["attributes"]["WEIGHTS_0"] =
                gltf.addArray(std::vector<float>(96, 0.25f), 4);
            change(gltf);
        },
        words);
}

} // namespace

std::vector<BadInput> badNodes() {
    return {
        withNode("NodeIsItsOwnChild", "children", Json::array({0}), {"nodes[0]", "twice"}),
        withNode("ChildOutOfRange", "children", Json::array({99}), {"nodes[99]"}),
        withNode("ChildNegative", "children", Json::array({-1}), {"nodes[-1]"}),
        withNode("TranslationOfTwoNumbers", "translation", {1, 2}, {"nodes[0].translation", "2"}),
        withNode("MeshPast32Bits", "mesh", 4294967296, {"nodes[0].mesh", "4294967296"}),
        withNode("MeshOutOfRange", "mesh", 99, {"nodes[0].mesh", "99"}),
        withNode("SkinOutOfRange", "skin", 99, {"skin", "99"}),
        badScene("ScaleOutOfTheRangeOfFloats",
                 [](GltfBuilder& gltf) {
                     gltf.json.erase("animations"); // meshes that move keep their floats
                     gltf.json["nodes"][0]["scale"] = {1e60, 1e60, 1e60};
                 },
                 {"nodes[0]"}),
        badText("TranslationPastDoubles",
                R"({"asset":{"version":"2.0"},"nodes":[{"translation":[1e999,0,0]}]})", {"1e999"}),
        badScene("NodeCycle",
                 [](GltfBuilder& gltf) {
                     gltf.json["nodes"][0]["children"] = Json::array({1});
                     gltf.addNode({{"children", Json::array({0})}}, false);
                 },
                 {"nodes[0]", "twice"}),
        badScene("NodeCycleWithoutScenes",
                 [](GltfBuilder& gltf) {
                     gltf.json["nodes"][0]["children"] = Json::array({1});
                     gltf.addNode({{"children", Json::array({0})}}, false);
                     gltf.json.erase("scenes");
                     gltf.json.erase("scene");
                 },
                 {"nodes["}),
        badScene("NodeReachedTwice",
                 [](GltfBuilder& gltf) {
                     gltf.addNode({{"children", Json::array({0})}});
                 },
                 {"nodes[0]", "twice"}),
        badScene("RootNamedTwice",
                 [](GltfBuilder& gltf) {
                     gltf.json["scenes"][0]["nodes"] = {0, 0};
                 },
                 {"nodes[0]", "twice"}),
        badScene("RootOutOfRange",
                 [](GltfBuilder& gltf) { gltf.json["scenes"][0]["nodes"] = Json::array({99}); },
                 {"nodes[99]"}),
        badScene("SceneOutOfRange", [](GltfBuilder& gltf) { gltf.json["scene"] = 99; },
                 {"scene", "99"}),
        badScene("TransformsWhoseProductIsInfinite",
                 [](GltfBuilder& gltf) {
                     gltf.json["nodes"][0]["scale"] = {1e200, 1e200, 1e200};
                     gltf.json["scenes"][0]["nodes"].clear();
                     gltf.addNode({{"children", Json::array({0})}, {"scale", {1e200, 1, 1}}});
                 },
                 {"nodes[0]", "finite"}),
        warned(badScene(
            "InstancesOfNoAttributes",
            [](GltfBuilder& gltf) {
                gltf.useExtension("EXT_mesh_gpu_instancing");
                gltf.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] =
                    Json::object();
            },
            {"nodes[0].extensions.EXT_mesh_gpu_instancing.attributes is empty", "drawn once"})),
        warned(badScene("InstancesWithoutAttributes",
                        [](GltfBuilder& gltf) {
                            gltf.useExtension("EXT_mesh_gpu_instancing");
                            gltf.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] =
                                Json::object();
                        },
                        {"nodes[0].extensions.EXT_mesh_gpu_instancing", "drawn once"})),
        badScene("InstancesAreANumber",
                 [](GltfBuilder& gltf) {
                     gltf.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = 7;
                 },
                 {"nodes[0].extensions.EXT_mesh_gpu_instancing", "an object"}),
        badScene("MaterialOutOfRange",
                 [](GltfBuilder& gltf) { primitiveOf(gltf)["material"] = 99; }, {"material", "99"}),
        badScene("UnknownAlphaMode",
                 [](GltfBuilder& gltf) { gltf.json["materials"][0]["alphaMode"] = "SOLID"; },
                 {"materials[0].alphaMode", "SOLID"}),
        badScene("TextureTransformPastFloats",
                 [](GltfBuilder& gltf) {
                     gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]
                              ["extensions"]["KHR_texture_transform"]["scale"] = {1e300, 1.0};
                 },
                 {"materials[0]", "floats"}),
        withSkin("JointOutOfRange",
                 [](GltfBuilder& gltf) { gltf.json["skins"][0]["joints"] = Json::array({99}); },
                 {"skins[0].joints[0]", "99"}),
        withSkin("JointNegative",
                 [](GltfBuilder& gltf) { gltf.json["skins"][0]["joints"] = Json::array({-1}); },
                 {"skins[0].joints[0]"}),
        withSkin("VertexOfNoJoint",
                 [](GltfBuilder& gltf) {
                     primitiveOf(gltf)["attributes"]["JOINTS_0"] =
                         gltf.addArray(std::vector<std::uint8_t>(96, 7), 4);
                 },
                 {"JOINTS_0", "7"}),
        withSkin("TooFewJoints",
                 [](GltfBuilder& gltf) {
                     primitiveOf(gltf)["attributes"]["JOINTS_0"] =
                         gltf.addArray(std::vector<std::uint8_t>(8, 0), 4);
                 },
                 {"JOINTS_0"}),
        withSkin("TooFewInverseBindMatrices",
                 [](GltfBuilder& gltf) {
                     gltf.json["skins"][0]["joints"] = {0, 0, 0};
                 },
                 {"skins[0].inverseBindMatrices"}),
        withSkin("InverseBindMatricesOfNoAccessor",
                 [](GltfBuilder& gltf) { gltf.json["skins"][0]["inverseBindMatrices"] = 99; },
                 {"skins[0].inverseBindMatrices", "99"}),
    };
}

} // namespace edgeshade::test
