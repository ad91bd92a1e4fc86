#pragma once

#include "src/shadow/primitive_map/primitive_map.hpp"
#include "src/shadow/primitive_map/texel_occluders.hpp"
#include "src/shadow/primitive_map/wanted_texels.hpp"

#include <atomic>
#include <string>

namespace edgeshade {

/// Builds a light's map part by part, so that a caller can do other work in between, or let several
/// threads build parts. The result doesn't depend on which thread built a part.
class PrimitiveMapBuilder {
  public:
    /// Projects the casters, and divides tiles into parts.
    PrimitiveMapBuilder(const Light& light, const std::vector<PlacedCasters>& casters,
                        const PrimitiveMapSettings& settings);

    /// Whether the light is too far away for floats, see leastDepthSpan: then there is no map.
    bool isTooFar() const { return tiles_.depthSpan < leastDepthSpan; }

    /// Length of a list found to be too long; 0: none is known.
    std::size_t tooLong() const { return tooLong_; }
    /// Looks for too long a list where the most casters crowd, before building. It examines texels
    /// as the map will have them, so that a find is certain. Only for maps whose texels aren't
    /// divided.
    void lookForLongLists();

    std::size_t partCount() const { return parts_.size(); }
    /// Builds a part. Call it once for each part, in any order; different parts at the same time
    /// are allowed.
    void buildPart(std::size_t part);
    /// Builds all parts, on as many threads as there are cores.
    void buildAllParts();
    /// Returns the map once all parts are built. Null if it exceeds its memory, has too long a
    /// list, or would take minutes.
    std::optional<PrimitiveMap> join();

  private:
    /// A texel of the header whose reference is to its own part: 0: none; > 0: a list's number
    /// plus 1; < 0: the negated index of a block's first texel, minus 1.
    struct Texel {
        float darkBehind = neverDark;
        std::int32_t reference = 0;
    };
    struct List {
        std::uint32_t first = 0, count = 0, forCasters = 0;
    };
    /// An entry that names its footprint in place of a record.
    struct Entry {
        std::uint32_t print = 0;
        float next = neverDark; ///< nearest depth of the next entry
    };
    /// A square of a tile's texels. Its arrays are most of what building takes.
    struct Part {
        std::size_t tile = 0;
        int x = 0, y = 0, side = 0;
        std::vector<std::uint32_t> candidates;
        std::vector<Texel> texels, blocks;
        std::vector<List> lists;
        std::vector<Entry> entries;
    };
    struct Tile {
        std::vector<Footprint> prints;
    };
    class PartBuilder;

    /// Counts a part's entries and tests; beyond the limits building stops.
    void charge(std::size_t listed, std::size_t looks);
    /// Stops building if a list is longer than allowed.
    void chargeList(std::size_t triangles);
    void lookForLongLists(const Part& part);
    /// Whether any of a square's texels is looked up.
    bool isWanted(std::size_t tile, int x, int y, int side) const;
    TileFootprints footprintsOf(std::size_t tile) const;
    RaySquare squareOf(double x, double y, double side) const;
    void divideIntoParts(std::size_t tile);

    PrimitiveMapSettings settings_;
    LightTiles tiles_;
    Occluders occluders_;
    std::vector<Tile> prints_;         ///< by tile
    std::vector<WantedTexels> wanted_; ///< by tile; empty: all are
    std::vector<Part> parts_;
    std::atomic<std::size_t> listed_ = 0; ///< entries and texels, of all parts
    std::atomic<std::size_t> looks_ = 0;  ///< tests of a footprint against a square
    std::atomic<std::size_t> tooLong_ = 0;
    std::atomic<bool> tooLarge_ = false; ///< too large, or a list is too long: building has stopped
};

} // namespace edgeshade
