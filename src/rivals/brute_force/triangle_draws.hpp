#pragma once

#include "src/shadow/plan/volume_draw.hpp"

#include <vector>

namespace edgeshade {

/// How the volumes of a batch's triangles are counted.
struct TriangleCount {
    bool zFail = true; ///< behind surfaces; otherwise before surfaces, starting with near caps
    bool directional = false; ///< the light is directional: sides end in one point, and there are
                              ///< no back caps
    bool nearDiscard = false; ///< with z-fail: some caster may cross the near plane
};

/// Appends the draws of one batch. With z-fail they are every triangle's whole volume; with z-pass
/// near caps for the parts of triangles before the near plane (ZP+), then sides, then front caps in
/// cutouts. Sides of multiplicity 1 are drawn before those of -1. `index`: the batch's index in the
/// plan; `groups`: ranges of its triangles.
void appendTriangleDraws(const std::vector<MaterialCasters>& groups, std::size_t index,
                         const TriangleCount& count, const std::vector<Material>& materials,
                         std::vector<VolumeDraw>& draws);

} // namespace edgeshade
