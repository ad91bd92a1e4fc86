#pragma once

// Random triangles of every scale and shape, and lights where signs are hardest to determine: on
// face planes, edges and vertices, and a few units in the last place beside them.

#include "preprocess/mesh/weld.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <string_view>

namespace edgeshade::test {

/// SplitMix64: the same numbers with every standard library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
        z = (z ^ z >> 27) * 0x94D049BB133111EBu;
        return z ^ z >> 31;
    }
    /// In [low, high).
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
    }
    /// In 0 .. count - 1.
    int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
    /// 10 to a power in [low, high).
    double magnitude(double low, double high) { return std::pow(10.0, uniform(low, high)); }
    glm::dvec3 inCube() {
        const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
        return {x, y, z};
    }

  private:
    std::uint64_t state_;
};

enum class LightKind {
    pointAnywhere,
    pointOnPlane,
    pointOnEdge,
    pointOnVertex,
    sunAnywhere,
    sunAlongPlane,
    sunAlongEdge
};

constexpr std::size_t lightKindCount = 7;

constexpr std::array<std::string_view, lightKindCount> lightKindNames = {
    "point anywhere",    "point on a face plane",  "point on an edge's line", "point on a vertex",
    "sun from anywhere", "sun along a face plane", "sun along an edge"};

/// Moves every component by 0 to 4 units in the last place, up or down.
inline glm::vec3 nudged(Random& random, glm::vec3 p) {
    for (glm::length_t c = 0; c < 3; ++c) {
        const int steps = random.below(9) - 4;
        const float towards =
            std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(steps));
        for (int i = 0; i < std::abs(steps); ++i)
            p[c] = std::nextafter(p[c], towards);
    }
    return p;
}

using Corners = std::array<glm::vec3, 3>;

/// Three distinct positions in ascending order: scales 1e-6 to 1e6, near the origin or far away;
/// any shape, slivers, needles, and small lattices on which collinear points are common.
inline Corners randomTriangle(Random& random) {
    while (true) {
        const double scale = random.magnitude(-6, 6);
        const glm::dvec3 offset =
            random.below(2) ? random.inCube() * random.magnitude(0, 3) : glm::dvec3(0.0);
        glm::dvec3 a = random.inCube(), b = random.inCube(), c = random.inCube();
        switch (random.below(4)) {
        case 0:
            break;
        case 1:
            c = glm::mix(a, b, random.uniform(-1, 2)) + c * random.magnitude(-8, -2);
            break;
        case 2:
            b = a + b * random.magnitude(-7, -5);
            break;
        default:
            a = round(3.0 * a), b = round(3.0 * b), c = round(3.0 * c);
            break;
        }
        Corners corners = {glm::vec3(scale * (a + offset)), glm::vec3(scale * (b + offset)),
                           glm::vec3(scale * (c + offset))};
        std::sort(corners.begin(), corners.end(), orderedBefore);
        if (corners[0] != corners[1] && corners[1] != corners[2]) return corners;
    }
}

/// A light of the given kind for the triangle.
inline glm::vec4 randomLight(Random& random, const Corners& corners, LightKind kind) {
    const auto first = static_cast<std::size_t>(random.below(3));
    const glm::dvec3 a(corners[first]), b(corners[(first + 1) % 3]), c(corners[(first + 2) % 3]);
    const double size = glm::length(b - a) + glm::length(c - a);
    const auto point = [&](const glm::dvec3& p) {
        return glm::vec4(nudged(random, glm::vec3(p)), 1.0f);
    };
    const auto sun = [&](const glm::dvec3& direction) {
        return glm::vec4(nudged(random, glm::vec3(direction)), 0.0f);
    };
    switch (kind) {
    case LightKind::pointAnywhere:
        return point(a + random.inCube() * size * random.magnitude(-2, 3));
    case LightKind::pointOnPlane: {
        const double s = random.uniform(-3, 3), t = random.uniform(-3, 3);
        return point(a + s * (b - a) + t * (c - a));
    }
    case LightKind::pointOnEdge:
        return point(glm::mix(a, b, random.uniform(-2, 3)));
    case LightKind::pointOnVertex:
        return point(a);
    case LightKind::sunAnywhere:
        return sun(random.inCube());
    case LightKind::sunAlongPlane: {
        const double s = random.uniform(-3, 3), t = random.uniform(-3, 3);
        return sun(s * (b - a) + t * (c - a));
    }
    case LightKind::sunAlongEdge:
        return sun(random.below(2) ? b - a : glm::normalize(b - a));
    }
    return {};
}

} // namespace edgeshade::test
