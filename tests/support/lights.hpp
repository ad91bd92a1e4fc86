#pragma once

#include "preprocess/mesh/weld.hpp"

#include <cmath>
#include <random>
#include <vector>

namespace edgeshade::test {

/// Lights with difficult signs, in the mesh's space: around and inside its bounds, directional
/// lights, and exactly on vertices, edges and faces, the latter nudged by up to four units in the
/// last place. The same seed gives the same lights.
inline std::vector<glm::vec4> hardLights(const WeldedMesh& mesh, std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    glm::vec3 low = mesh.positions.front(), high = low;
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const auto pick = [&](std::size_t size) {
        return std::uniform_int_distribution<std::size_t>(0, size - 1)(random);
    };
    const auto nudged = [&](glm::vec3 p) {
        for (glm::length_t c = 0; c < 3; ++c)
            for (auto steps = static_cast<int>(pick(5)); steps > 0; --steps)
                p[c] = std::nextafter(p[c], c % 2 == 0 ? 1e30f : -1e30f);
        return p;
    };
    std::vector<glm::vec4> lights;
    while (lights.size() < count) {
        const Triangle& triangle = mesh.triangles[pick(mesh.triangles.size())];
        const glm::vec3 a = mesh.positions[triangle[0]], b = mesh.positions[triangle[1]],
                        c = mesh.positions[triangle[2]];
        const float u = unit(random), v = unit(random), t = unit(random);
        switch (lights.size() % 6) {
        case 0:
            lights.emplace_back(low + glm::vec3(u, v, t) * (high - low), 1.0f);
            break;
        case 1:
            lights.emplace_back(low + (5.0f * glm::vec3(u, v, t) - 2.0f) * (high - low), 1.0f);
            break;
        case 2:
            lights.emplace_back(glm::vec3(u, v, t) - 0.5f, 0.0f);
            break;
        case 3:
            lights.emplace_back(nudged(a), 1.0f);
            break;
        case 4:
            lights.emplace_back(nudged(a + u * (b - a)), 1.0f);
            break;
        default:
            lights.emplace_back(nudged(a + 3.0f * u * (b - a) - v * (c - a)), 1.0f);
            break;
        }
    }
    return lights;
}

} // namespace edgeshade::test
