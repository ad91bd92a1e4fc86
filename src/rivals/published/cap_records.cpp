#include "src/rivals/published/cap_records.hpp"

#include "src/render/drawing/attributes.hpp"

#include <algorithm>

namespace edgeshade {

void drawCapRecords(const ShadowBuffers& shadow, const RecordRange& caps,
                    const CapVertices& vertices, bool alphaTested) {
    const bool copied = vertices.instancing == nullptr;
    const std::size_t copies = copied ? static_cast<std::size_t>(vertices.perRecord) : 1;
    const std::size_t recordBytes = CapsData::vectorsPerRecord * sizeof(glm::vec4) * copies;
    const std::size_t cornerBytes = 3 * sizeof(glm::vec4) * copies;
    for (const RecordChunk& chunk : shadow.caps) {
        const std::size_t first = std::max<std::size_t>(chunk.firstRecord, caps.first);
        const std::size_t end =
            std::min<std::size_t>(chunk.firstRecord + chunk.recordCount, caps.end());
        if (first >= end) continue;
        AttributeBinding binding(vertices.instancing);
        if (!copied)
            binding.add(vertices.corners, 2, GL_FLOAT, false, sizeof(glm::vec2),
                        static_cast<std::size_t>(vertices.first) * sizeof(glm::vec2), false);
        binding.addRecords(chunk.buffer, CapsData::vectorsPerRecord,
                           (first - chunk.firstRecord) * recordBytes, !copied);
        if (alphaTested) binding.addRecords(shadow.alphaCorners, 3, first * cornerBytes, !copied);
        const auto count = static_cast<int>(end - first);
        if (copied)
            glDrawArrays(GL_TRIANGLES, 0, count * vertices.perRecord);
        else
            vertices.instancing->drawTriangles(vertices.count, count);
    }
}

} // namespace edgeshade
