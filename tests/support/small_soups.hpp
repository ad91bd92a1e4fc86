#pragma once

// Random meshes of a few points, so that many triangles share an edge, repeat or degenerate.

#include "tests/support/hard_lights.hpp"
#include "tests/support/tiny_meshes.hpp"

#include <cstdint>
#include <rapidcheck.h>
#include <vector>

namespace edgeshade::test {

constexpr int soupPoints = 8;

/// `count` numbers in [low, high), with rapidcheck's full size from the first case on.
inline std::vector<int> integers(int count, int low, int high) {
    return *rc::gen::resize(rc::kNominalSize,
                            rc::gen::container<std::vector<int>>(static_cast<std::size_t>(count),
                                                                 rc::gen::inRange(low, high)));
}

/// Up to forty triangles over eight points of a small lattice: points coincide, triples are
/// collinear, and lights lie in planes. For use within a rapidcheck property.
inline Soup latticeSoup() {
    const auto coordinates = integers(3 * soupPoints, -2, 3);
    Soup soup;
    for (std::size_t i = 0; i < coordinates.size(); i += 3)
        soup.positions.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    const int triangles = integers(1, 0, 41).front();
    for (const int index : integers(3 * triangles, 0, soupPoints))
        soup.indices.push_back(static_cast<std::uint32_t>(index));
    return soup;
}

/// A point light or a directional light on the same lattice. For use within a rapidcheck property.
inline glm::vec4 latticeLight() {
    const auto p = integers(3, -3, 4);
    return {p[0], p[1], p[2], integers(1, 0, 2).front()};
}

/// `triangles` random triangles over eight points of any scale, with the shapes of
/// randomTriangle().
inline Soup randomSoup(Random& random, int triangles) {
    const Corners corners = randomTriangle(random);
    Soup soup{{corners.begin(), corners.end()}, {}};
    // The other points lie around the triangle, so that rounding doesn't merge them.
    const double size = glm::length(glm::dvec3(corners[2]) - glm::dvec3(corners[0]));
    for (int i = 3; i < soupPoints; ++i)
        soup.positions.emplace_back(glm::dvec3(corners[0]) + size * random.inCube());
    for (int i = 0; i < 3 * triangles; ++i)
        soup.indices.push_back(static_cast<std::uint32_t>(random.below(soupPoints)));
    return soup;
}

} // namespace edgeshade::test
