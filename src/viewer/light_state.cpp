#include "src/viewer/light_state.hpp"

#include "src/shadow/geometry/vectors.hpp"

#include <algorithm>

namespace edgeshade::viewer {
namespace {

using Json = nlohmann::ordered_json;

Light lightFromArray(const Field& field) {
    Light light;
    const bool ranged = field.arraySize() == 5;
    glm::length_t i = 0;
    const auto read = [&](const Field& number) {
        if (i == 4)
            light.range = number.number(0.0, farthestPlace);
        else
            light.position[i] = number.number(-farthestPlace, farthestPlace);
        ++i;
    };
    if (ranged)
        field.forEachItem(read);
    else
        light.position = field.place<4>();
    const glm::dvec4& position = light.position;
    if (position.w != 0.0 && position.w != 1.0)
        field.fail("a light [x, y, z, w] whose w is 0 (a sun) or 1 (a point)");
    if (position == glm::dvec4(0.0)) field.fail("a sun with a direction");
    if (ranged && (position.w == 0.0 || light.range == 0.0))
        field.fail("a point light [x, y, z, 1, range] whose range is above 0");
    return light;
}

double angleFrom(const Field& field) {
    return glm::radians(field.number(0.0, 90.0));
}

glm::dvec3 directionFrom(const Field& field) {
    const glm::dvec3 direction = field.place<3>();
    if (direction == glm::dvec3(0.0)) field.fail("a direction");
    return unitOf(direction);
}

Cone coneFrom(const Field& field) {
    Cone cone;
    field.forEachMember([&](const std::string& key, const Field& value) {
        if (key == "axis") {
            cone.axis = directionFrom(value);
        } else if (key == "inner") {
            cone.inner = angleFrom(value);
        } else if (key == "outer") {
            cone.outer = angleFrom(value);
            if (cone.outer < narrowestAngle) value.fail("at least 0.0001");
        } else {
            return false;
        }
        return true;
    });
    if (cone.inner > cone.outer) field.fail("a cone whose 'inner' is no larger than its 'outer'");
    return cone;
}

glm::dvec2 sizeFrom(const Field& field) {
    const glm::dvec2 size = field.place<2>();
    if (!(size.x >= smallestLength && size.y >= smallestLength))
        field.fail("above 0 in both directions");
    return size;
}

/// Reads a key that describes the light's extent; returns false for any other key.
bool readExtent(const std::string& key, const Field& value, std::optional<LightExtent>& extent) {
    using Shape = LightExtent::Shape;
    LightExtent read = extent.value_or(LightExtent());
    const bool isFacing = key == "facing";
    if (key == "radius") {
        read.shape = Shape::sphere;
        read.radius = value.number(smallestLength, farthestPlace);
    } else if (key == "size") {
        read.shape = Shape::rectangle;
        read.size = sizeFrom(value);
    } else if (isFacing) {
        read.shape = Shape::rectangle;
        read.direction = directionFrom(value);
    } else if (key == "angle") {
        read.shape = Shape::disc;
        read.radius = glm::radians(0.5 * value.number(narrowestAngle, 90.0));
    } else {
        return false;
    }
    if (extent && extent->shape != read.shape)
        value.fail("a field of the same shape as the light's other fields");
    extent = read;
    return true;
}

Light lightFromObject(const Field& field) {
    Light light;
    bool placed = false;
    double intensity = 1.0;
    field.forEachMember([&](const std::string& key, const Field& value) {
        if (key == "position" || key == "direction") {
            if (placed) field.fail("a light with either 'position' or 'direction'");
            placed = true;
            light.position = glm::dvec4(value.place<3>(), key == "position" ? 1.0 : 0.0);
            if (light.position == glm::dvec4(0.0)) value.fail("a direction");
        } else if (key == "color") {
            light.color = glm::vec3(value.place<3>(0.0, brightestLight));
        } else if (key == "intensity") {
            intensity = value.number(0.0, brightestLight);
            light.photometric = true;
        } else if (key == "range") {
            light.range = value.number(smallestLength, farthestPlace);
        } else if (key == "cone") {
            light.cone = coneFrom(value);
        } else {
            return readExtent(key, value, light.extent);
        }
        return true;
    });
    if (!placed) field.fail("a light with a 'position' or a 'direction'");
    light.color *= static_cast<float>(intensity);
    if (light.position.w == 0.0) {
        if (light.cone || std::isfinite(light.range))
            field.fail("a point light, since it has a range or a cone");
    }
    if (!light.extent) return light;
    if ((light.extent->shape == LightExtent::Shape::disc) != (light.position.w == 0.0))
        field.fail("a point light with a 'radius' or a 'size', or a directional one with an "
                   "'angle'");
    if (light.extent->shape == LightExtent::Shape::rectangle && light.extent->size.x == 0.0)
        field.fail("a light with a 'size', since it has a 'facing'");
    return light;
}

} // namespace

Light lightFrom(const Field& field) {
    return field.isObject() ? lightFromObject(field) : lightFromArray(field);
}

namespace {

void addExtent(const LightExtent& extent, Json& json) {
    switch (extent.shape) {
    case LightExtent::Shape::sphere:
        json["radius"] = extent.radius;
        return;
    case LightExtent::Shape::rectangle:
        json["size"] = {extent.size.x, extent.size.y};
        json["facing"] = toJson(extent.direction);
        return;
    case LightExtent::Shape::disc:
        json["angle"] = glm::degrees(2.0 * extent.radius);
    }
}

} // namespace

Json namedJson(const Light& light) {
    Json json;
    json[light.position.w == 0.0 ? "direction" : "position"] = toJson(glm::dvec3(light.position));
    const float largest = std::max({light.color.r, light.color.g, light.color.b});
    const bool split = light.photometric || largest > 1.0f;
    const glm::vec3 color = !split           ? light.color
                            : largest > 0.0f ? light.color / largest
                                             : glm::vec3(1.0f);
    json["color"] = toJson(glm::dvec3(color));
    if (split) json["intensity"] = static_cast<double>(largest);
    if (light.hasRange()) json["range"] = light.range;
    if (light.isSpot())
        json["cone"] = {{"axis", toJson(light.cone->axis)},
                        {"inner", glm::degrees(light.cone->inner)},
                        {"outer", glm::degrees(light.cone->outer)}};
    if (light.extent) addExtent(*light.extent, json);
    return json;
}

Json toJson(const Light& light) {
    if (light.color != glm::vec3(1.0f) || light.photometric || light.isSpot() || light.extent)
        return namedJson(light);
    const glm::dvec4& place = light.position;
    Json json = {place.x, place.y, place.z, place.w};
    if (light.hasRange()) json.push_back(light.range);
    return json;
}

} // namespace edgeshade::viewer
