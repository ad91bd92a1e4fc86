// Broken cameras, lights and names: a scene is drawn without them.
#include "tests/cli/bad_input.hpp"

namespace edgeshade::test {
namespace {

BadInput withCamera(const std::string& name, const Json& camera,
                    const std::vector<std::string>& words) {
    return warned(badScene(
        name, [=](GltfBuilder& gltf) { gltf.json["cameras"] = Json::array({camera}); }, words));
}

BadInput withLight(const std::string& name, const Json& light,
                   const std::vector<std::string>& words) {
    return warned(badScene(
        name,
        [=](GltfBuilder& gltf) {
            gltf.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({light});
        },
        words));
}

Json perspective(const Json& yfov, const Json& znear) {
    return {{"type", "perspective"}, {"perspective", {{"yfov", yfov}, {"znear", znear}}}};
}

} // namespace

std::vector<BadInput> badOptionalParts() {
    const std::string light = "extensions.KHR_lights_punctual.lights[0]";
    return {
        warned(badScene("CamerasAreANumber", [](GltfBuilder& gltf) { gltf.json["cameras"] = 7; },
                        {"cameras is 7", "an array", "the cameras are left out"})),
        withCamera("CameraIsText", "wide",
                   {"cameras[0] is \"wide\"", "an object", "the camera is left out"}),
        withCamera("CameraOfNoType", Json::object(), {"cameras[0].type is missing"}),
        withCamera("CameraOfUnknownType", {{"type", "fisheye"}},
                   {"cameras[0].type is 'fisheye'", "perspective, orthographic"}),
        withCamera("CameraWithoutPerspective", {{"type", "perspective"}},
                   {"cameras[0].perspective is missing"}),
        withCamera("CameraThatSeesNothing", perspective(0.0, 0.1),
                   {"cameras[0].perspective.yfov is 0.0", "positive"}),
        withCamera("CameraThatSeesAllAround", perspective(3.2, 0.1),
                   {"cameras[0].perspective.yfov is 3.2", "below pi"}),
        withCamera("CameraWithATextForItsNearPlane", perspective(1.0, "near"),
                   {"cameras[0].perspective.znear is \"near\"", "a number"}),
        withCamera("CameraOfNoWidth",
                   {{"type", "orthographic"},
                    {"orthographic", {{"xmag", 0}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}}}},
                   {"cameras[0].orthographic.xmag is 0", "other than 0"}),
        warned(badScene("NodeOfNoCamera",
                        [](GltfBuilder& gltf) { gltf.json["nodes"][0]["camera"] = 3; },
                        {"nodes[0].camera is 3", "0 cameras", "the camera is left out"})),
        warned(badScene("LightsAreText",
                        [](GltfBuilder& gltf) {
                            gltf.json["extensions"]["KHR_lights_punctual"]["lights"] = "sun";
                        },
                        {"KHR_lights_punctual.lights is \"sun\"", "an array"})),
        withLight("LightOfNoType", {{"intensity", 1}}, {light + ".type is missing"}),
        withLight("LightOfUnknownType", {{"type", "area"}},
                  {light + ".type is 'area'", "the light is left out"}),
        withLight("LightOfTwoColours", {{"type", "point"}, {"color", {1, 1}}},
                  {light + ".color has 2 numbers, not 3"}),
        withLight("LightOfNegativeRange", {{"type", "point"}, {"range", -2.5}},
                  {light + ".range is -2.5", "positive"}),
        withLight("LightOfNoRange", {{"type", "point"}, {"range", 0}},
                  {light + ".range is 0", "read as no limit"}),
        withLight("SunOfNoRange", {{"type", "directional"}, {"range", 0.0}},
                  {light + ".range is 0", "no range"}),
        withLight("LightOfNegativeColour", {{"type", "point"}, {"color", {1, -1, 0}}},
                  {light + ".color[1] is -1", "from 0.0 to"}),
        withLight("LightOfNegativeIntensity", {{"type", "point"}, {"intensity", -1}},
                  {light + ".intensity is -1", "0 or more"}),
        withLight("LightTooBrightForFloats", {{"type", "point"}, {"intensity", 1e300}},
                  {light + ".intensity is 1e+300", "brighter"}),
        withLight("LightOfTooSmallARange", {{"type", "point"}, {"range", 1e-300}},
                  {light + ".range is 1e-300", "at least"}),
        withLight("SpotOfMoreThanARightAngle",
                  {{"type", "spot"}, {"spot", {{"outerConeAngle", 1.6}}}},
                  {light + ".spot.outerConeAngle is 1.6", "pi / 2"}),
        withLight("SpotOfNoAngle", {{"type", "spot"}, {"spot", {{"outerConeAngle", 0.0}}}},
                  {light + ".spot.outerConeAngle is 0.0", "positive"}),
        withLight("SpotWhoseInnerConeIsTheOuter",
                  {{"type", "spot"}, {"spot", {{"innerConeAngle", 1.0}}}},
                  {light + ".spot.innerConeAngle is larger", "outerConeAngle"}),
        withLight("SpotWithoutCone", {{"type", "spot"}}, {light + ".spot is missing"}),
        warned(badScene("NodeOfNoLight",
                        [](GltfBuilder& gltf) {
                            gltf.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 1;
                        },
                        {"nodes[0].extensions.KHR_lights_punctual.light is 1", "0 lights"})),
        warned(badScene("NodeNameIsANumber",
                        [](GltfBuilder& gltf) { gltf.json["nodes"][0]["name"] = 7; },
                        {"nodes[0].name is 7", "text", "the name is left out"})),
        warned(badScene("MaterialNameIsAnArray",
                        [](GltfBuilder& gltf) { gltf.json["materials"][0]["name"] = {"red"}; },
                        {"materials[0].name is an array", "text"})),
    };
}

} // namespace edgeshade::test
