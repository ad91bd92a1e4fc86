#pragma once

#include "preprocess/volumes/cut_caps.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// The triangles and edges of one kind of a cut geometry's caps at which its topology is found
/// again: pieces and fills, and the sides at which other caps meet them.
struct CutBorder {
    WeldedMesh mesh;                  ///< pieces, and caps that share an edge with a cut cap
    std::vector<std::uint32_t> capOf; ///< by triangle of the mesh, as cut
    std::vector<glm::vec4> planes;    ///< by triangle of the mesh; a piece has one of its own
    /// Edges of pieces, and of caps that were cut. A cap that stays as it was is listed only at
    /// those that a cut cap had too.
    EdgeList edges;
    std::vector<std::uint32_t> replaced; ///< edges of caps that were cut, each once
    bool balanced =
        true; ///< each of `edges` has as many triangles in one direction as in the other
};

/// `cut`: the geometry as cut; `kind`: one of `caps`.
CutBorder cutBorder(const UncutRecords& uncut, const Geometry& cut, const CutCaps& caps,
                    const CutCaps::Kind& kind);

} // namespace edgeshade
