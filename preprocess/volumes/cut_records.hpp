#pragma once

#include "preprocess/volumes/cut_border.hpp"

namespace edgeshade {

/// The memory that cutRecords() works in. One serves all geometries, one after the other.
struct CutMemory {
    CutCaps caps;
    BorderNumbers numbers;
};

/// The records of a geometry that a section cuts. Records away from the cut are those of the uncut
/// geometry; only edges of triangles that planes meet, and of fills, are found again. They count
/// for every light as buildPlanePairs()'s do (docs/method/sections.md, C51). Each kind of CutCaps
/// is one cluster, whose components aren't counted. That of closed components counts as closed if
/// the cut left all of its edges closed.
///
/// `uncut`: canFollowCuts(). `cut`: the geometry as cut, of these origins; `materials`: of the cut
/// scene. `spare`: records that are no longer needed, for the memory of their arrays.
PlanePairShadow cutRecords(const UncutRecords& uncut, const Geometry& cut,
                           const CutOrigins& origins, const std::vector<Material>& materials,
                           bool castMasked, CutMemory& memory, PlanePairShadow spare = {});

} // namespace edgeshade
