#pragma once

// The shaders' output as a chain of oriented triangles over symbolic vertices: vertex i of the
// mesh, or its point at infinity (docs/method.md, The closed chain). Positions only determine the
// signs, so that rounding affects nothing else.

#include "preprocess/volumes/published/caps_data.hpp"
#include "preprocess/volumes/published/sides_data.hpp"
#include "tests/support/record_multiplicity.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade::test {

/// A vertex of the chain: 2 i for vertex i, 2 i + 1 for its point at infinity.
using ChainVertex = std::size_t;

/// Sums up the boundary of oriented triangles.
class Chain {
  public:
    explicit Chain(std::size_t meshVertices)
        : side_(2 * meshVertices), directed_(side_ * side_, 0) {}

    void addTriangle(ChainVertex p, ChainVertex q, ChainVertex r) {
        ++triangles_;
        addEdge(p, q);
        addEdge(q, r);
        addEdge(r, p);
    }

    /// Whether every directed edge is cancelled by an equal number of its reverse.
    bool isCycle() const {
        return std::all_of(directed_.begin(), directed_.end(), [](int sum) { return sum == 0; });
    }

    std::size_t triangleCount() const { return triangles_; }

  private:
    void addEdge(ChainVertex from, ChainVertex to) {
        ++directed_[from * side_ + to];
        --directed_[to * side_ + from];
    }

    std::size_t side_;
    std::size_t triangles_ = 0;
    std::vector<int> directed_; ///< a matrix; antisymmetric
};

inline std::size_t indexOf(std::span<const glm::vec3> sortedPositions, const glm::vec4& p) {
    const auto found = std::lower_bound(sortedPositions.begin(), sortedPositions.end(),
                                        glm::vec3(p), orderedBefore);
    return static_cast<std::size_t>(found - sortedPositions.begin());
}

/// The main() of sides.vert, not instanced; empty for an unused vertex.
template <class Method>
std::optional<ChainVertex> sideVertex(std::span<const glm::vec3> positions,
                                      std::span<const glm::vec4> record, const glm::vec4& light) {
    const float multiplicity = recordMultiplicity<Method>(record, light);
    const float v = record[0].w;
    const float side = record[1].w;
    const float id =
        multiplicity > 0.0f ? (v > 2.5f ? v - 2.0f : 2.0f - v) : (v > 2.5f ? 6.0f - v : v);
    const glm::vec4& end = id == 0.0f || id == 2.0f ? record[0] : record[1];
    if (!(side < std::abs(multiplicity))) return std::nullopt;
    return 2 * indexOf(positions, end) + (id > 1.5f ? 1 : 0);
}

/// The main() of caps.vert, not instanced.
template <class Method>
std::optional<ChainVertex> capVertex(std::span<const glm::vec3> positions,
                                     std::span<const glm::vec4> record, const glm::vec4& light) {
    const float facing = capSign<Method>(record, light);
    const float v = record[0].w;
    const bool front = v < 2.5f;
    const float vertex = front ? v : 5.0f - v;
    const bool isA = vertex == (facing < 0.0f ? 1.0f : 0.0f);
    const bool isC = vertex == 2.0f;
    const glm::vec4& p = isA ? record[0] : (isC ? record[2] : record[1]);
    if (facing == 0.0f) return std::nullopt;
    return 2 * indexOf(positions, p) + (front ? 0 : 1);
}

/// Runs `vertexShader` over an array of records, one per vertex, and adds the triangles that
/// remain.
template <class VertexShader>
void emit(Chain& chain, std::span<const glm::vec4> vertices, std::size_t vectorsPerVertex,
          VertexShader vertexShader) {
    const std::size_t stride = 3 * vectorsPerVertex;
    for (std::size_t first = 0; first < vertices.size(); first += stride) {
        const auto corner = [&](std::size_t c) {
            return vertexShader(vertices.subspan(first + c * vectorsPerVertex, vectorsPerVertex));
        };
        const auto p = corner(0), q = corner(1), r = corner(2);
        if (p && q && r) chain.addTriangle(*p, *q, *r);
    }
}

/// All sides and caps of a mesh: `sides` and `caps` in their non-instanced form, as the packer
/// expands them.
template <class Method>
Chain emittedChain(std::span<const glm::vec3> positions, std::span<const glm::vec4> sides,
                   std::size_t vectorsPerSideVertex, std::span<const glm::vec4> caps,
                   const glm::vec4& light) {
    Chain chain(positions.size());
    emit(chain, sides, vectorsPerSideVertex, [&](std::span<const glm::vec4> record) {
        return sideVertex<Method>(positions, record, light);
    });
    emit(chain, caps, CapsData::vectorsPerRecord, [&](std::span<const glm::vec4> record) {
        return capVertex<Method>(positions, record, light);
    });
    return chain;
}

} // namespace edgeshade::test
