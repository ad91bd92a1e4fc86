#include "src/rivals/brute_force/triangle_draws.hpp"

#include "shaders_es2/record_layout.glsl"
#include "src/rivals/published/cap_ranges.hpp"

namespace edgeshade {
namespace {

/// Vertices that a triangle runs for its sides of one multiplicity.
int sideVerticesOf(const TriangleCount& count) {
    return (count.directional ? SECOND_SIDE_VERTEX : BACK_CAP_VERTEX) - FIRST_SIDE_VERTEX;
}

/// Vertices that a triangle runs for its caps.
int capVerticesOf(const TriangleCount& count) {
    if (!count.zFail) return 0;
    return count.directional ? verticesPerCap : 2 * verticesPerCap;
}

} // namespace

void appendTriangleDraws(const std::vector<MaterialCasters>& groups, std::size_t index,
                         const TriangleCount& count, const std::vector<Material>& materials,
                         std::vector<VolumeDraw>& draws) {
    for (const CapRange& range : capRanges(groups, materials)) {
        VolumeDraw draw;
        draw.batch = index;
        draw.records = VolumeDraw::Records::triangles;
        draw.range = {range.first, range.count};
        draw.zFail = count.zFail;
        if (!count.zFail) {
            draw.shape = VolumeDraw::Shape::nearCaps;
            draw.verticesPerRecord = verticesPerCap;
            draws.push_back(draw);
        }
        draw.shape = VolumeDraw::Shape::triangleVolumes;
        draw.verticesPerRecord = sideVerticesOf(count) + capVerticesOf(count);
        draw.nearDiscard = count.zFail && count.nearDiscard;
        if (count.zFail && range.alphaTested) {
            draw.alphaTested = range.alphaTested;
            draw.verticesPerRecord += verticesPerCap; // front caps in the cutouts
        }
        draws.push_back(draw);
        draw.shape = VolumeDraw::Shape::negativeSides;
        draw.verticesPerRecord = sideVerticesOf(count);
        draws.push_back(draw);
        if (count.zFail || !range.alphaTested) continue;
        draw.shape = VolumeDraw::Shape::caps;
        draw.verticesPerRecord = verticesPerCap;
        draw.alphaTested = range.alphaTested;
        draw.cutoutsAlone = true;
        draws.push_back(draw);
    }
}

} // namespace edgeshade
