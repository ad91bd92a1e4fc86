#pragma once

#include "preprocess/section/cut_origins.hpp"
#include "preprocess/volumes/uncut_records.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace edgeshade {

/// The caps of a cut geometry, by their kinds: those of closed components and the fill, those of
/// open components, and those of components of which something is cut away and casts all the same.
struct CutCaps {
    /// A piece, or a triangle of a fill.
    struct Piece {
        Triangle vertices; ///< of the cut geometry
        std::uint32_t cap = 0;
    };

    /// Caps [first, end) before the cut, neighbours that stay as they were and go to one part.
    struct Run {
        std::uint32_t first, end;
        std::uint32_t component;
        std::uint8_t part;
    };

    /// Within a kind single-sided caps come first. Of these, and of the others, come first those
    /// that are visible. Each such part begins with caps that were there before, in their order.
    struct Kind {
        RecordRange caps;
        std::uint32_t singleSided = 0;
        std::vector<MaterialCasters> groups;
        std::vector<Piece> pieces;
        std::vector<std::uint32_t> met; ///< caps before the cut that planes met
    };
    static constexpr std::uint8_t closed = 0, open = 1, tested = 2;
    static constexpr std::size_t kindCount = 3;

    std::array<Kind, kindCount> kinds;
    std::vector<Run> runs;
    /// By cap before the cut; UncutRecords::none: it is cut up, or is away and doesn't cast.
    std::vector<std::uint32_t> capOf;
    std::vector<CapRecord> caps; ///< planes of pieces aren't set
    std::vector<std::uint32_t> capTriangles;
};

/// Fills in `caps`, whose arrays may have any content; they keep their memory. `cut`: the geometry
/// as cut; `materials`: of the cut scene; `cutKind`: of closed components that planes met, and of
/// fills, if nothing of them is away: closed or open.
void findCaps(const UncutRecords& uncut, const Geometry& cut, const CutOrigins& origins,
              const std::vector<Material>& materials, bool castMasked, std::uint8_t cutKind,
              CutCaps& caps);

} // namespace edgeshade
