#pragma once

#include "src/shadow/plan/volume_draw.hpp"

#include <vector>

namespace edgeshade {

/// How the volumes of a batch's triangles are counted.
struct TriangleCount {
    bool zFail = true; ///< behind surfaces; else before them, from what lies before the near plane
    bool directional = false; ///< the light is: sides end in one point, and there are no back caps
    bool nearDiscard = false; ///< with z-fail: some caster may cross the near plane
};

/// Appends the draws of one batch: with z-fail every triangle's whole volume, with z-pass what of
/// the triangles lies before the near plane (ZP+), then their sides, then front caps in cutouts.
/// Sides of multiplicity 1 and of -1 are drawn one after the other.
/// `index`: of the batch in the plan; `groups`: ranges of its triangles.
void appendTriangleDraws(const std::vector<MaterialCasters>& groups, std::size_t index,
                         const TriangleCount& count, const std::vector<Material>& materials,
                         std::vector<VolumeDraw>& draws);

} // namespace edgeshade
