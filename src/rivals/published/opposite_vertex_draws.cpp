#include "src/rivals/published/opposite_vertex_draws.hpp"

#include "shaders_es2/record_layout.glsl"
#include "src/rivals/published/cap_ranges.hpp"

namespace edgeshade {

void appendOppositeVertexDraws(const OppositeVertexRecords& published, std::size_t index,
                               bool nearDiscard, const std::vector<Material>& materials,
                               std::vector<VolumeDraw>& draws) {
    VolumeDraw like;
    like.batch = index;
    like.zFail = true;
    if (published.sides > 0) {
        VolumeDraw& draw = draws.emplace_back(like);
        draw.records = VolumeDraw::Records::oppositeVertexSides;
        draw.range = {0, published.sides};
        draw.verticesPerRecord = published.maxMultiplicity * VERTICES_PER_SIDE;
    }
    like.shape = VolumeDraw::Shape::caps;
    like.records = VolumeDraw::Records::oppositeVertexCaps;
    like.verticesPerRecord = VERTICES_PER_CAP_PAIR;
    like.nearDiscard = nearDiscard;
    for (const CapRange& range : capRanges(published.groups, materials)) {
        VolumeDraw& draw = draws.emplace_back(like);
        draw.range = {range.first, range.count};
        draw.alphaTested = range.alphaTested;
        if (range.alphaTested) draw.verticesPerRecord = 2 * VERTICES_PER_CAP_PAIR;
    }
}

} // namespace edgeshade
