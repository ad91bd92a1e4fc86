#include "tests/support/generated_meshes.hpp"

#include "tests/support/hard_lights.hpp"

#include <cmath>
#include <stdexcept>

namespace edgeshade::test {
namespace {

void addQuad(Soup& soup, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    soup.indices.insert(soup.indices.end(), {a, b, c, a, c, d});
}

/// Cube root, rounded up; std::cbrt() differs between platforms.
std::size_t cubeRoot(std::size_t number) {
    std::size_t root = 0;
    while (root * root * root < number)
        ++root;
    return root;
}

} // namespace

Soup hillyGrid(std::size_t triangles) {
    const auto side =
        static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 2.0)) + 1;
    Random random(1);
    Soup soup;
    for (std::uint32_t z = 0; z < side; ++z)
        for (std::uint32_t x = 0; x < side; ++x)
            soup.positions.emplace_back(x, random.uniform(0.0, 2.0), z);
    for (std::uint32_t z = 0; z + 1 < side; ++z)
        for (std::uint32_t x = 0; x + 1 < side; ++x)
            addQuad(soup, z * side + x, (z + 1) * side + x, (z + 1) * side + x + 1,
                    z * side + x + 1);
    return soup;
}

Soup manyBoxes(std::size_t triangles) {
    Random random(2);
    const std::size_t boxes = triangles / 12 + 1;
    const double room = 2.0 * static_cast<double>(cubeRoot(boxes));
    Soup soup;
    for (std::size_t i = 0; i < boxes; ++i) {
        const glm::vec3 low(room * random.inCube());
        const glm::vec3 size(glm::dvec3(1.1) + random.inCube());
        for (glm::length_t axis = 0; axis < 3; ++axis)
            for (const bool high : {false, true}) {
                const auto first = static_cast<std::uint32_t>(soup.positions.size());
                for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
                    glm::vec3 corner = low;
                    corner[axis] += high ? size[axis] : 0.0f;
                    corner[(axis + 1) % 3] += u ? size[(axis + 1) % 3] : 0.0f;
                    corner[(axis + 2) % 3] += v ? size[(axis + 2) % 3] : 0.0f;
                    soup.positions.push_back(corner);
                }
                if (high)
                    addQuad(soup, first, first + 1, first + 2, first + 3);
                else
                    addQuad(soup, first, first + 3, first + 2, first + 1);
            }
    }
    return soup;
}

Soup tangle(std::size_t triangles) {
    Random random(3);
    const auto points = static_cast<int>(triangles / 4 + 4);
    const auto lattice = static_cast<int>(cubeRoot(static_cast<std::size_t>(2 * points)));
    Soup soup;
    for (int i = 0; i < points; ++i) {
        const int x = random.below(lattice), y = random.below(lattice), z = random.below(lattice);
        soup.positions.emplace_back(x, y - lattice / 2, z % 5 == 0 ? -0.0f : static_cast<float>(z));
    }
    for (std::size_t t = 0; t < triangles; ++t) {
        const int first = random.below(points);
        for (int c = 0; c < 3; ++c) // close to each other in the list, so that they share edges
            soup.indices.push_back(static_cast<std::uint32_t>((first + random.below(6)) % points));
        if (t % 97 == 0) // a hub
            soup.indices.back() = 0;
    }
    return soup;
}

Soup generatedMesh(const std::string& kind, std::size_t triangles) {
    if (kind == "grid") return hillyGrid(triangles);
    if (kind == "boxes") return manyBoxes(triangles);
    if (kind == "tangle") return tangle(triangles);
    throw std::invalid_argument("There is no mesh '" + kind + "'; there are grid, boxes, tangle.");
}

} // namespace edgeshade::test
