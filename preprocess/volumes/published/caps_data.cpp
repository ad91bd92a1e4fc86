#include "preprocess/volumes/published/caps_data.hpp"

#include <algorithm>

namespace edgeshade {

Triangle sortedTriangle(Triangle triangle) {
    std::sort(triangle.begin(), triangle.end());
    return triangle;
}

CapsData buildCaps(const WeldedMesh& mesh) {
    CapsData caps;
    caps.records.reserve(mesh.triangles.size() * CapsData::vectorsPerRecord);
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : sortedTriangle(triangle))
            caps.records.emplace_back(mesh.positions[vertex], 0.0f);
    return caps;
}

std::vector<glm::vec4> expandCaps(const CapsData& caps, std::size_t first, std::size_t count,
                                  int vertices) {
    std::vector<glm::vec4> expanded;
    expanded.reserve(count * CapsData::vectorsPerRecord * static_cast<std::size_t>(vertices));
    for (std::size_t record = first; record < first + count; ++record) {
        const auto* source = caps.records.data() + record * CapsData::vectorsPerRecord;
        for (int vertex = 0; vertex < vertices; ++vertex) {
            expanded.insert(expanded.end(), source, source + CapsData::vectorsPerRecord);
            expanded[expanded.size() - CapsData::vectorsPerRecord].w = static_cast<float>(vertex);
        }
    }
    return expanded;
}

} // namespace edgeshade
