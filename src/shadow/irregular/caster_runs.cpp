#include "src/shadow/irregular/caster_runs.hpp"

#include <algorithm>

namespace edgeshade {

CasterRuns::CasterRuns(std::span<const glm::vec3> positions,
                       std::span<const std::uint32_t> indices) {
    const std::size_t count = indices.size() / 3;
    runs_.reserve((count + length - 1) / length);
    triangles_.reserve(count);
    // Position of each vertex in the last run that contained it.
    std::vector<std::uint32_t> runOf(positions.size(), 0);
    std::vector<std::uint8_t> placeOf(positions.size(), 0);
    for (std::size_t first = 0; first < count; first += length) {
        Run& run = runs_.emplace_back();
        const auto number = static_cast<std::uint32_t>(runs_.size());
        run.firstVertex = static_cast<std::uint32_t>(vertices_.size());
        run.firstTriangle = static_cast<std::uint32_t>(first);
        run.triangleCount = static_cast<std::uint32_t>(std::min(length, count - first));
        for (std::size_t t = first; t < first + run.triangleCount; ++t) {
            Triangle& triangle = triangles_.emplace_back();
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t vertex = indices[3 * t + c];
                if (runOf[vertex] != number) {
                    runOf[vertex] = number;
                    placeOf[vertex] = static_cast<std::uint8_t>(run.vertexCount++);
                    vertices_.push_back(positions[vertex]);
                    run.bounds.add(glm::dvec3(positions[vertex]));
                }
                triangle[c] = placeOf[vertex];
            }
        }
    }
}

} // namespace edgeshade
