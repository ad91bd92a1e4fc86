#include "src/viewer/silhouettes.hpp"

#include "shaders_es2/record_layout.glsl"

namespace edgeshade::viewer {
namespace {

/// side(A, B, C) of the method, section 1.
int sideOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec4& light) {
    const glm::dvec3 towards = glm::dvec3(light) - a * light.w;
    const double volume = glm::dot(glm::cross(c - a, towards), b - a);
    return (volume > 0.0) - (volume < 0.0);
}

/// What one opposite vertex adds to the multiplicity of the edge a < b.
int multiplicityOf(const glm::dvec3& a, const glm::dvec3& b, const glm::vec4& opposite,
                   const glm::dvec4& light) {
    const glm::dvec3 o(opposite);
    if (opposite.w == static_cast<float>(ORDER_OPPOSITE_FIRST)) return sideOf(o, a, b, light);
    if (opposite.w == static_cast<float>(ORDER_OPPOSITE_LAST)) return sideOf(a, b, o, light);
    if (opposite.w == static_cast<float>(ORDER_OPPOSITE_BETWEEN)) return -sideOf(a, o, b, light);
    return 0;
}

void count(const SidesData& sides, const glm::dvec4& light, EdgeCounts& counts) {
    const std::size_t vectors = sides.vectorsPerRecord();
    counts.records += sides.recordCount();
    for (std::size_t r = 0; r < sides.recordCount();) {
        // The records of one edge follow each other, and their multiplicities add up.
        const glm::vec4* first = &sides.records[r * vectors];
        int multiplicity = 0;
        for (; r < sides.recordCount(); ++r) {
            const glm::vec4* record = &sides.records[r * vectors];
            if (record[0] != first[0] || record[1] != first[1]) break;
            for (std::size_t i = 2; i < vectors; ++i)
                multiplicity += multiplicityOf(record[0], record[1], record[i], light);
        }
        ++counts.edges;
        counts.silhouettes += multiplicity != 0;
    }
}

} // namespace

EdgeCounts countEdges(const LoadedScene& loaded, const Light& light) {
    EdgeCounts counts;
    for (std::size_t i = 0; i < loaded.shadows.size(); ++i)
        count(loaded.shadows[i].sides,
              glm::inverse(loaded.scene.batches[i].worldFromBatch) * light.position, counts);
    return counts;
}

} // namespace edgeshade::viewer
