#include "src/rivals/synthetic/synthetic_mesh.hpp"

#include "shaders_es2/record_layout.glsl"

namespace edgeshade::bench {
namespace {

/// The height of opposite vertex `index` above the plane z = 0 of edge and light.
float heightOf(int index, int count, Silhouette silhouette) {
    if (silhouette == Silhouette::all) return 1.0f;
    const int inRecord = index % LARGEST_RECORD_MULTIPLICITY;
    const bool last = index + 1 == count || inRecord + 1 == LARGEST_RECORD_MULTIPLICITY;
    if (inRecord % 2 == 1) return 1.0f;
    return last ? 0.0f : -1.0f;
}

} // namespace

SyntheticMesh syntheticMesh(std::size_t edgeCount, int oppositeCount, Silhouette silhouette) {
    SyntheticMesh mesh;
    const auto count = static_cast<std::uint32_t>(oppositeCount);
    for (std::size_t e = 0; e < edgeCount; ++e) {
        // x ascends, to keep the vertices in order. All coordinates are exact in floats up to 2^21
        // edges.
        const float x = 8.0f * static_cast<float>(e);
        const auto a = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.edges.edges.push_back(
            {a, a + 1, static_cast<std::uint32_t>(mesh.edges.opposites.size()), count});
        mesh.positions.emplace_back(x + 3.0f, 1.0f, 0.0f);
        mesh.positions.emplace_back(x + 4.0f, 2.0f, 0.0f);
        for (int i = 0; i < oppositeCount; ++i) {
            // The two vertices of a pair differ only in their side.
            const int place =
                silhouette == Silhouette::all ? i : i - (i % LARGEST_RECORD_MULTIPLICITY) % 2;
            mesh.positions.emplace_back(x + 5.0f + 0.25f * static_cast<float>(place), 1.5f,
                                        heightOf(i, oppositeCount, silhouette));
            mesh.edges.opposites.push_back({a + 2 + static_cast<std::uint32_t>(i), 0});
        }
    }
    return mesh;
}

} // namespace edgeshade::bench
