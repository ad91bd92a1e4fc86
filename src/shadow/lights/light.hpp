#pragma once

#include "preprocess/scene/scene.hpp"

#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numbers>
#include <optional>

namespace edgeshade {

/// Lights that one frame can have.
inline constexpr std::size_t mostLights = 1000;

/// Throws Error(usage) for more than those.
void requireFewLights(std::size_t lights);

/// What a spot light lights: the rays within an angle around its axis (KHR_lights_punctual).
/// Between the two angles its light falls off by the square of how far the cosine is between
/// theirs.
struct Cone {
    glm::dvec3 axis{0.0, 0.0, -1.0};       ///< where it shines, in the world; of length 1
    double inner = 0.0;                    ///< radians, 0 <= inner <= outer: all of it within
    double outer = std::numbers::pi / 4.0; ///< radians, 0 < outer <= pi/2: nothing from there on

    bool operator==(const Cone&) const = default;
};

/// The shape that a light shines from, where it is more than a point or one direction. All of it
/// shines alike.
struct LightExtent {
    enum class Shape {
        sphere,    ///< around a point light
        rectangle, ///< in the middle of which a point light stands; it shines to one side
        disc,      ///< around a directional light, as the sun's
    };
    Shape shape = Shape::sphere;
    double radius = 0.0;  ///< > 0; of a sphere, scene units; of a disc, radians, at most pi / 4
    glm::dvec2 size{0.0}; ///< of a rectangle, > 0: width and height, scene units
    glm::dvec3 direction{0.0, -1.0, 0.0}; ///< of a rectangle: what it faces, of length 1

    bool operator==(const LightExtent&) const = default;
};

/// A light in the world (docs/method.md, Terms): w = 1, a point light at xyz; w = 0, a directional
/// light, xyz pointing towards it.
struct Light {
    glm::dvec4 position{0.0, 1.0, 0.0, 0.0};
    /// Scene units, above 0: a point light gets no farther. Within d of it Lambert's law is weighed
    /// by max(1 - (d / range)^4, 0), the window that KHR_lights_punctual recommends. Directional
    /// lights have none.
    double range = std::numeric_limits<double>::infinity();
    glm::vec3 color{1.0f}; ///< linear, times intensity; 1: as bright as a light is by itself
    /// `color` is in candela, of which a point light leaves the square of the distance's share, or
    /// in lux of a directional light; else it is a share of what a picture's lights have together.
    bool photometric = false;
    std::optional<Cone> cone{}; ///< of a point light that is a spot; nothing: it shines everywhere
    std::optional<LightExtent> extent{}; ///< nothing: its shadows are hard

    bool operator==(const Light&) const = default;
    bool hasRange() const { return position.w != 0.0 && std::isfinite(range); }
    bool isSpot() const { return position.w != 0.0 && cone.has_value(); }
    /// The same light elsewhere.
    Light at(const glm::dvec4& place) const {
        Light moved = *this;
        moved.position = place;
        return moved;
    }
};

/// A directional light that suits any scene, high and from the side.
Light defaultLight();

/// Where the light is in an object's space; a directional light's direction scaled so that its
/// largest component is 1 or -1, as only the direction counts. `worldFromObject` must be
/// invertible.
glm::dvec4 placeInObject(const Light& light, const glm::dmat4& worldFromObject);

/// The same, rounded once.
glm::vec4 lightInObject(const Light& light, const glm::dmat4& worldFromObject);

/// A distance in an object's space that is nowhere less than `range` in the world.
double rangeInObject(double range, const glm::dmat4& worldFromObject);

/// That of a light; infinite where it has no range.
double rangeInObject(const Light& light, const glm::dmat4& worldFromObject);

} // namespace edgeshade
