#include "preprocess/volumes/published/sides_data.hpp"

#include "shaders_es2/record_layout.glsl"

#include <algorithm>

namespace edgeshade {
namespace {

/// Position of the opposite vertex relative to its edge's vertices.
float orderOf(const Edge& edge, std::uint32_t opposite) {
    if (opposite < edge.a) return static_cast<float>(ORDER_OPPOSITE_FIRST);
    if (opposite < edge.b) return static_cast<float>(ORDER_OPPOSITE_BETWEEN);
    return static_cast<float>(ORDER_OPPOSITE_LAST);
}

} // namespace

int recordMultiplicityFor(std::uint32_t largestOppositeCount) {
    return static_cast<int>(std::clamp(largestOppositeCount, 1u,
                                       static_cast<std::uint32_t>(LARGEST_RECORD_MULTIPLICITY)));
}

std::size_t recordCountFor(const EdgeList& edges, int maxMultiplicity) {
    const auto capacity = static_cast<std::size_t>(maxMultiplicity);
    std::size_t count = 0;
    for (const Edge& edge : edges.edges)
        count += (edge.oppositeCount + capacity - 1) / capacity;
    return count;
}

SidesData buildSides(std::span<const glm::vec3> positions, const EdgeList& edges,
                     int maxMultiplicity) {
    SidesData sides;
    sides.maxMultiplicity = maxMultiplicity;
    sides.records.reserve(recordCountFor(edges, maxMultiplicity) * sides.vectorsPerRecord());
    const auto capacity = static_cast<std::size_t>(maxMultiplicity);
    for (const Edge& edge : edges.edges) {
        const auto opposites = edges.oppositesOf(edge);
        for (std::size_t first = 0; first < opposites.size(); first += capacity) {
            sides.records.emplace_back(positions[edge.a], 0.0f);
            sides.records.emplace_back(positions[edge.b], 0.0f);
            for (std::size_t i = first; i < first + capacity; ++i) {
                if (i < opposites.size())
                    sides.records.emplace_back(positions[opposites[i].vertex],
                                               orderOf(edge, opposites[i].vertex));
                else
                    sides.records.emplace_back(0.0f, 0.0f, 0.0f, static_cast<float>(ORDER_ABSENT));
            }
        }
    }
    return sides;
}

std::vector<glm::vec4> expandSides(const SidesData& sides, std::size_t first, std::size_t count) {
    const std::size_t vectors = sides.vectorsPerRecord();
    const int vertices = sides.maxMultiplicity * VERTICES_PER_SIDE;
    std::vector<glm::vec4> expanded;
    expanded.reserve(count * vectors * static_cast<std::size_t>(vertices));
    for (std::size_t record = first; record < first + count; ++record) {
        const auto* source = sides.records.data() + record * vectors;
        for (int vertex = 0; vertex < vertices; ++vertex) {
            const std::size_t start = expanded.size();
            expanded.insert(expanded.end(), source, source + vectors);
            expanded[start].w = static_cast<float>(vertex % VERTICES_PER_SIDE);
            expanded[start + 1].w = static_cast<float>(vertex / VERTICES_PER_SIDE);
        }
    }
    return expanded;
}

} // namespace edgeshade
