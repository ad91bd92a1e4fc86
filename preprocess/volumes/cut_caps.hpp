#pragma once

#include "preprocess/section/cut_origins.hpp"
#include "preprocess/volumes/uncut_records.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace edgeshade {

/// The caps of a cut geometry. First come those that are visible, then those that are cut away and
/// cast all the same. Each part begins with caps that were there before, in their order, followed
/// by pieces and, last, the fill.
struct CutCaps {
    /// A piece, or a triangle of a fill.
    struct Piece {
        std::array<glm::vec3, 3> corners;
        std::uint32_t cap = 0;
    };

    /// By cap before the cut; UncutRecords::none: it is cut up, or is away and doesn't cast.
    std::vector<std::uint32_t> capOf;
    std::vector<CapRecord> caps; ///< planes of pieces are 0 as yet
    std::vector<std::uint32_t> capTriangles;
    std::vector<Piece> pieces;
    std::vector<MaterialCasters> groups; ///< one for each part
    std::uint32_t away = 0;              ///< caps that are cut away
    std::uint32_t singleSided = 0;       ///< the first caps, that are single-sided
};

/// Fills in `caps`, whose arrays are empty. `cut`: the geometry as cut; `materials`: of the cut
/// scene.
void findCaps(const UncutRecords& uncut, const Geometry& cut, const CutOrigins& origins,
              const std::vector<Material>& materials, bool castMasked, CutCaps& caps);

} // namespace edgeshade
