#pragma once

// The closed chain of deforming meshes: over the vertices of the rest pose's records, wherever a
// pose puts them.

#include "preprocess/scene/posing.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/plane_pair_chain.hpp"

namespace edgeshade::test {

/// Number of edges at which sides don't fit caps. `shadow` has RecordVertices.
inline std::size_t openEdgesOfPose(const PlanePairShadow& shadow, const PlanePairSigns& signs) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sums;
    const RecordVertices& vertices = *shadow.vertices;
    for (std::size_t i = 0; i < shadow.pairs.size(); ++i)
        sums[{vertices.pairs[i][0], vertices.pairs[i][1]}] += signs.pairs[i];
    for (std::size_t i = 0; i < shadow.singles.size(); ++i)
        sums[{vertices.singles[i][0], vertices.singles[i][1]}] += signs.singles[i];
    for (std::size_t i = 0; i < shadow.caps.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t a = vertices.caps[i][c], b = vertices.caps[i][(c + 1) % 3];
            if (a < b)
                sums[{a, b}] -= signs.caps[i];
            else
                sums[{b, a}] += signs.caps[i];
        }
    return static_cast<std::size_t>(
        std::count_if(sums.begin(), sums.end(), [](const auto& sum) { return sum.second != 0; }));
}

/// A random shape of a batch: at `wildness` 0 as animations may produce it, at 1 torn, flattened to
/// planes and points, and turned over.
inline BatchShape randomShape(const Batch& batch, Random& random, double wildness) {
    BatchShape shape = batch.shape;
    for (glm::dmat4& matrix : shape.batchFromMesh) {
        for (glm::length_t c = 0; c < 3; ++c)
            matrix[c] += glm::dvec4((0.1 + 3.0 * wildness) * random.inCube(), 0.0);
        matrix[3] += glm::dvec4(random.magnitude(-2, 4.0 * wildness - 1) * random.inCube(), 0.0);
        if (random.uniform(0, 1) < 0.3 * wildness) matrix[random.below(3)] = glm::dvec4(0.0);
        if (random.uniform(0, 1) < 0.2 * wildness) matrix[0] = matrix[1] = matrix[2];
    }
    for (auto& weights : shape.weights)
        for (double& weight : weights)
            weight = random.uniform(-1 - 8 * wildness, 1 + 8 * wildness);
    // Half of the target that turns it inside out: everything is one point.
    if (wildness > 0.0 && random.below(8) == 0)
        for (auto& weights : shape.weights)
            for (std::size_t w = 0; w < weights.size(); ++w)
                weights[w] = w + 1 == weights.size() ? 0.5 : 0.0;
    return shape;
}

} // namespace edgeshade::test
