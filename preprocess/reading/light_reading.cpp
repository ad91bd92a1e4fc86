#include "preprocess/reading/light_reading.hpp"

#include "preprocess/gltf/optional_items.hpp"
#include "preprocess/reading/node_parts.hpp"
#include "preprocess/scene/extremes.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

namespace edgeshade {
namespace {

constexpr const char* lightsExtension = "KHR_lights_punctual";
constexpr double rightAngle = std::numbers::pi / 2.0;

SceneLight::Kind kindOf(const JsonField& light) {
    const std::string type = light.member("type").oneOf({"directional", "point", "spot"});
    if (type == "directional") return SceneLight::Kind::directional;
    return type == "spot" ? SceneLight::Kind::spot : SceneLight::Kind::point;
}

glm::dvec3 colorOf(const JsonField& field) {
    field.numbers(3);
    glm::dvec3 color;
    for (glm::length_t i = 0; i < 3; ++i)
        color[i] = numberIn(field.item(static_cast<std::size_t>(i)), 0.0, brightestLight);
    return color;
}

/// Reads the cone's angles; rounding to float may have put a right angle slightly higher.
void readCone(const JsonField& spot, SceneLight& light) {
    light.outerCone = std::numbers::pi / 4.0;
    spot.ifPresent("innerConeAngle",
                   [&](const JsonField& inner) { light.innerCone = inner.notNegative(); });
    spot.ifPresent("outerConeAngle", [&](const JsonField& outer) {
        light.outerCone = outer.positive();
        if (light.outerCone < narrowestAngle || light.outerCone > rightAngle + 1e-6)
            outer.fail(" is " + outer.value().dump() + ", but must be from 1e-6 to pi / 2");
        light.outerCone = std::min(light.outerCone, rightAngle);
    });
    if (light.innerCone > light.outerCone + 1e-6)
        spot.fail(".innerConeAngle is larger than its outerConeAngle");
    light.innerCone = std::min(light.innerCone, light.outerCone);
}

/// Where a point light's or spot's light ends (KHR_lights_punctual); null: nowhere. Older exporters
/// write 0 for that.
std::optional<double> rangeOf(const JsonField& range, SceneLight::Kind kind, Warnings& warnings) {
    const bool isZero = range.value().is_number() && range.number() == 0.0;
    if (kind == SceneLight::Kind::directional) {
        if (isZero)
            warnings.add(range.where() + " is 0, but directional lights have no range; it is "
                                         "ignored.");
        return std::nullopt;
    }
    if (isZero) {
        warnings.add(range.where() + " is 0, but must be positive; it is read as no limit.");
        return std::nullopt;
    }
    const double value = range.positive();
    if (value < smallestLength)
        range.fail(" is " + range.value().dump() + ", but must be at least 1e-12");
    return value <= farthestPlace ? std::optional(value) : std::nullopt;
}

/// Reads everything but the position.
SceneLight lampOf(const JsonField& light, Warnings& warnings) {
    SceneLight read;
    read.kind = kindOf(light);
    read.name = nameOf(light);
    light.ifPresent("color", [&](const JsonField& color) { read.color = colorOf(color); });
    light.ifPresent("intensity", [&](const JsonField& intensity) {
        read.intensity = intensity.notNegative();
        const glm::dvec3 product = read.intensity * read.color;
        if (!(std::max({product.r, product.g, product.b}) <= brightestLight))
            intensity.fail(" is " + intensity.value().dump() + ", which is brighter than 1e12");
    });
    light.ifPresent("range", [&](const JsonField& range) {
        if (const auto ends = rangeOf(range, read.kind, warnings)) read.range = *ends;
    });
    if (read.kind == SceneLight::Kind::spot) readCone(light.member("spot"), read);
    return read;
}

void place(SceneLight& light, const JsonField& reference, const glm::dmat4& worldFromNode,
           const glm::dmat4& unflattened) {
    light.position = placeOf(reference, worldFromNode);
    if (light.kind == SceneLight::Kind::point) return;
    const auto forward = forwardOf(worldFromNode, unflattened);
    if (!forward) reference.fail(" is placed by a node whose transform is degenerate");
    light.direction = *forward;
}

} // namespace

std::vector<SceneLight> readLights(const GltfDocument& document, const NodeWalk& walk,
                                   Warnings& warnings) {
    const JsonField root(document.path, document.json);
    std::vector<std::optional<SceneLight>> lamps;
    root.ifExtension(lightsExtension, [&](const JsonField& extension) {
        if (!readOrWarn(warnings, "the lights are left out", [&] { extension.requireObject(); }))
            return;
        lamps = soundItems(extension, "lights", "light", warnings,
                           [&](const JsonField& light) { return lampOf(light, warnings); });
    });
    std::vector<SceneLight> lights;
    forEachNode(document, walk, "light", warnings, [&](const JsonField& node, const auto* placed) {
        node.ifExtension(lightsExtension, [&](const JsonField& extension) {
            const JsonField reference = extension.member("light");
            const int index = reference.indexInto(lamps.size(), "lights");
            const auto& lamp = lamps[static_cast<std::size_t>(index)];
            if (!placed || !placed->visible || !lamp) return;
            SceneLight light = *lamp;
            light.nodeName = nameOf(node);
            light.place = placed->place;
            place(light, reference, walk.worldFromNode[placed->node],
                  walk.unflattened[placed->node]);
            lights.push_back(light);
        });
    });
    return lights;
}

} // namespace edgeshade
