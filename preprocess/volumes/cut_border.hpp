#pragma once

#include "preprocess/volumes/cut_caps.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// The triangles and edges of one kind of a cut geometry's caps at which its topology is found
/// again: pieces and fills, and the sides at which other caps meet them.
struct CutBorder {
    std::vector<glm::vec3> positions; ///< distinct
    std::vector<std::uint32_t> capOf; ///< by triangle, as cut
    std::vector<glm::vec4> planes;    ///< by triangle; a piece has one of its own
    /// Edges in any order; their triangles are the pieces, then caps that share an edge with a cut
    /// cap. Edges of pieces, and of caps that were cut. A cap that stays as it was is listed only
    /// at those that a cut cap had too.
    EdgeList edges;
    std::vector<std::uint32_t> replaced; ///< edges of caps that were cut, each once
    bool balanced =
        true; ///< each of `edges` has as many triangles in one direction as in the other
};

/// Numbers by cap and by vertex for cutBorder(). It leaves all of them at UncutRecords::none, and
/// so must find them.
struct BorderNumbers {
    std::vector<std::uint32_t> ofCap, ofVertex;
};

/// `cut`: the geometry as cut; `kind`: one of `caps`.
CutBorder cutBorder(const UncutRecords& uncut, const Geometry& cut, const CutCaps& caps,
                    const CutCaps::Kind& kind, BorderNumbers& numbers);

} // namespace edgeshade
