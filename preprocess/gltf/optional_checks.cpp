#include "preprocess/gltf/optional_checks.hpp"

#include "preprocess/gltf/json_field.hpp"

#include <cmath>

namespace edgeshade {
namespace {

constexpr const char* lightsExtension = "KHR_lights_punctual";

/// A finite number that `accepts` says yes to.
template <class Accepts>
void checkNumber(const JsonField& number, const std::string& wanted, Accepts accepts) {
    const double value = number.number();
    if (!std::isfinite(value) || !accepts(value))
        number.fail(" is " + number.value().dump() + ", but must be " + wanted);
}

void checkPositive(const JsonField& number) {
    checkNumber(number, "positive", [](double value) { return value > 0.0; });
}

void checkNotNegative(const JsonField& number) {
    checkNumber(number, "0 or more", [](double value) { return value >= 0.0; });
}

void checkNotZero(const JsonField& number) {
    checkNumber(number, "other than 0", [](double value) { return value != 0.0; });
}

void checkAnimationSampler(const JsonField& sampler, std::size_t accessorCount) {
    sampler.member("input").indexInto(accessorCount, "accessors");
    sampler.member("output").indexInto(accessorCount, "accessors");
    sampler.ifPresent("interpolation", [](const JsonField& interpolation) {
        interpolation.oneOf({"STEP", "LINEAR", "CUBICSPLINE"});
    });
}

/// Extensions may move things that are no nodes, and nodes in ways of their own.
void checkAnimationTarget(const JsonField& target, std::size_t nodeCount) {
    target.ifPresent("path", [](const JsonField& path) { path.text(); });
    const auto node = target.find("node");
    if (!node) return;
    node->indexInto(nodeCount, "nodes");
    const JsonField path = target.member("path");
    if (!target.find("extensions")) path.oneOf({"translation", "rotation", "scale", "weights"});
}

void checkAnimation(const JsonField& animation, std::size_t nodeCount, std::size_t accessorCount) {
    const std::size_t samplerCount = animation.countOf("samplers");
    animation.ifPresent("samplers", [&](const JsonField& samplers) {
        samplers.forEachItem(
            [&](const JsonField& sampler) { checkAnimationSampler(sampler, accessorCount); });
    });
    animation.ifPresent("channels", [&](const JsonField& channels) {
        channels.forEachItem([&](const JsonField& channel) {
            channel.member("sampler").indexInto(samplerCount, "samplers");
            channel.ifPresent("target", [&](const JsonField& target) {
                checkAnimationTarget(target, nodeCount);
            });
        });
    });
}

void checkCamera(const JsonField& camera) {
    const std::string type = camera.member("type").oneOf({"perspective", "orthographic"});
    const JsonField lens = camera.member(type.c_str());
    if (type == "perspective") {
        checkPositive(lens.member("yfov"));
        checkPositive(lens.member("znear"));
        lens.ifPresent("zfar", checkPositive);
        lens.ifPresent("aspectRatio", checkPositive);
    } else {
        checkNotZero(lens.member("xmag"));
        checkNotZero(lens.member("ymag"));
        checkNotNegative(lens.member("znear"));
        checkPositive(lens.member("zfar"));
    }
}

void checkLight(const JsonField& light) {
    const std::string type = light.member("type").oneOf({"directional", "point", "spot"});
    light.ifPresent("color", [](const JsonField& color) { color.numbers(3); });
    light.ifPresent("intensity", checkNotNegative);
    light.ifPresent("range", checkPositive);
    if (type != "spot") return;
    const JsonField spot = light.member("spot");
    spot.ifPresent("innerConeAngle", checkNotNegative);
    spot.ifPresent("outerConeAngle", checkPositive);
}

/// Calls check(JsonField) for every item of the member, if it is there. Items that it refuses, and
/// a member that is no array, get a warning; `broken` is told the items' indices.
template <class Check, class Broken>
void checkItems(const JsonField& parent, const char* key, const char* thing, Warnings& warnings,
                Check check, Broken broken) {
    const auto section = parent.find(key);
    if (!section) return;
    const std::string leftOut = std::string("the ") + thing;
    if (!readOrWarn(warnings, leftOut + "s are left out", [&] { section->requireArray(); })) return;
    std::size_t index = 0;
    section->forEachItem([&](const JsonField& item) {
        if (!readOrWarn(warnings, leftOut + " is left out", [&] { check(item); })) broken(index);
        ++index;
    });
}

/// What nodes refer to.
void checkNode(const JsonField& node, std::size_t cameraCount, std::size_t lightCount,
               Warnings& warnings) {
    readOrWarn(warnings, "the camera is left out", [&] {
        node.ifPresent("camera",
                       [&](const JsonField& camera) { camera.indexInto(cameraCount, "cameras"); });
    });
    node.ifExtension(lightsExtension, [&](const JsonField& reference) {
        readOrWarn(warnings, "the light is left out",
                   [&] { reference.member("light").indexInto(lightCount, "lights"); });
    });
}

} // namespace

BrokenParts findBrokenParts(const nlohmann::ordered_json& json, const std::filesystem::path& path,
                            Warnings& warnings) {
    const JsonField root(path, json);
    const std::size_t nodeCount = root.countOf("nodes"), accessorCount = root.countOf("accessors"),
                      cameraCount = root.countOf("cameras");
    const auto ignore = [](std::size_t) {};
    BrokenParts broken;
    checkItems(
        root, "animations", "animation", warnings,
        [&](const JsonField& animation) { checkAnimation(animation, nodeCount, accessorCount); },
        [&](std::size_t index) { broken.animations.insert(index); });
    checkItems(root, "cameras", "camera", warnings, checkCamera, ignore);
    std::size_t lightCount = 0;
    root.ifExtension(lightsExtension, [&](const JsonField& lights) {
        if (!readOrWarn(warnings, "the lights are left out", [&] { lights.requireObject(); }))
            return;
        lightCount = lights.countOf("lights");
        checkItems(lights, "lights", "light", warnings, checkLight, ignore);
    });
    root.ifPresent("nodes", [&](const JsonField& nodes) {
        nodes.forEachItem(
            [&](const JsonField& node) { checkNode(node, cameraCount, lightCount, warnings); });
    });
    return broken;
}

} // namespace edgeshade
