#pragma once

#include "tests/support/gltf_builder.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace edgeshade::test {

/// A box in the world, grown by `margin`, for a ray that starts outside it.
struct Block {
    glm::dvec3 low, high;

    bool blocks(const glm::dvec3& from, const glm::dvec3& direction, double margin) const {
        double enter = 0.0, leave = 1e30;
        for (glm::length_t c = 0; c < 3; ++c) {
            const double a = (low[c] - margin - from[c]) / direction[c];
            const double b = (high[c] + margin - from[c]) / direction[c];
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        return enter < leave;
    }
    bool holds(const glm::dvec3& point) const {
        return glm::all(glm::lessThan(low, point)) && glm::all(glm::lessThan(point, high));
    }
};

/// A floor of 16 x 16 at y = 0, named "lawn", and boxes named "block 1" and so on.
inline Bytes blocksOnALawn(const std::vector<Block>& blocks) {
    GltfBuilder gltf;
    gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(8.0f, 0.5f, 8.0f)))},
                  {"name", "lawn"},
                  {"translation", {0, -0.5, 0}}});
    int number = 0;
    for (const Block& block : blocks) {
        const glm::dvec3 center = 0.5 * (block.low + block.high);
        gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(0.5 * (block.high - block.low))))},
                      {"name", "block " + std::to_string(++number)},
                      {"translation", {center.x, center.y, center.z}}});
    }
    return gltf.glb();
}

} // namespace edgeshade::test
