#pragma once

#include "preprocess/scene/scene.hpp"

#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numbers>
#include <optional>

namespace edgeshade {

/// The most lights in one frame.
inline constexpr std::size_t mostLights = 1000;

/// Throws Error(usage) for more than mostLights.
void requireFewLights(std::size_t lights);

/// A spot's cone: the rays within an angle around its axis (KHR_lights_punctual). Between the two
/// angles its light falls off with the square of the cosine's position between their cosines.
struct Cone {
    glm::dvec3 axis{0.0, 0.0, -1.0}; ///< direction in which it shines, in the world; of length 1
    double inner = 0.0;              ///< radians, 0 <= inner <= outer: full light within
    double outer = std::numbers::pi / 4.0; ///< radians, 0 < outer <= pi/2: dark from there on

    bool operator==(const Cone&) const = default;
};

/// The shape of a light that is more than a point or one direction, uniformly bright.
struct LightExtent {
    enum class Shape {
        sphere,    ///< around a point light
        rectangle, ///< around a point light in its middle; shines to one side
        disc,      ///< around a directional light, such as the sun
    };
    Shape shape = Shape::sphere;
    double radius = 0.0;  ///< > 0; a sphere's in scene units, a disc's in radians, at most pi / 4
    glm::dvec2 size{0.0}; ///< of a rectangle, > 0: width and height, scene units
    glm::dvec3 direction{0.0, -1.0, 0.0}; ///< that a rectangle faces, of length 1

    bool operator==(const LightExtent&) const = default;
};

/// A light in the world (docs/method.md, Terms): w = 1, a point light at xyz; w = 0, a directional
/// light, with xyz pointing towards it.
struct Light {
    glm::dvec4 position{0.0, 1.0, 0.0, 0.0};
    /// Range of a point light, in scene units, above 0. At distance d within it Lambert's law is
    /// weighted by max(1 - (d / range)^4, 0), the window that KHR_lights_punctual recommends.
    /// Unused for directional lights.
    double range = std::numeric_limits<double>::infinity();
    glm::vec3 color{1.0f}; ///< linear, times intensity; 1: a light's default brightness
    /// `color` is in candela, divided by the squared distance, or for a directional light in lux.
    /// Otherwise it is a share of the total of a picture's lights.
    bool photometric = false;
    std::optional<Cone> cone{};          ///< of a spot; null: it shines in all directions
    std::optional<LightExtent> extent{}; ///< null: its shadows are hard

    bool operator==(const Light&) const = default;
    bool hasRange() const { return position.w != 0.0 && std::isfinite(range); }
    bool isSpot() const { return position.w != 0.0 && cone.has_value(); }
    /// The same light at another position.
    Light at(const glm::dvec4& place) const {
        Light moved = *this;
        moved.position = place;
        return moved;
    }
};

/// A directional light for any scene, high and from the side.
Light defaultLight();

/// The light in an object's space. A directional light's direction is scaled so that its largest
/// component is 1 or -1, as only the direction matters. `worldFromObject` must be invertible.
glm::dvec4 placeInObject(const Light& light, const glm::dmat4& worldFromObject);

/// placeInObject() by the inverse of that matrix.
glm::dvec4 placeByInverse(const Light& light, const glm::dmat4& objectFromWorld);

/// placeInObject(), rounded once.
glm::vec4 lightInObject(const Light& light, const glm::dmat4& worldFromObject);

/// A distance in an object's space that corresponds to at least `range` in the world, in every
/// direction.
double rangeInObject(double range, const glm::dmat4& worldFromObject);

/// The range of a light in an object's space; infinite if it has none.
double rangeInObject(const Light& light, const glm::dmat4& worldFromObject);

} // namespace edgeshade
