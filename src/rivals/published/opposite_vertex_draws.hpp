#pragma once

#include "src/shadow/plan/volume_draw.hpp"

#include <vector>

namespace edgeshade {

/// The opposite-vertex records of a batch.
struct OppositeVertexRecords {
    std::uint32_t sides = 0; ///< number of records
    int maxMultiplicity = 1;
    std::vector<MaterialCasters> groups = {}; ///< ranges of caps
};

/// Appends the draws of one batch: every side and every cap, z-fail. Adjoining groups of opaque
/// casters are drawn together. `index`: the batch's index in the plan; `nearDiscard`: some caster
/// may cross the near plane.
void appendOppositeVertexDraws(const OppositeVertexRecords& published, std::size_t index,
                               bool nearDiscard, const std::vector<Material>& materials,
                               std::vector<VolumeDraw>& draws);

} // namespace edgeshade
