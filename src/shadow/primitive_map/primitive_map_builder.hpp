#pragma once

#include "src/shadow/primitive_map/primitive_map.hpp"
#include "src/shadow/primitive_map/texel_occluders.hpp"

#include <atomic>
#include <string>

namespace edgeshade {

/// Builds the map of one light part by part, so that a caller may do something else in between, or
/// have several threads work on parts. The result is the same whoever did which.
class PrimitiveMapBuilder {
  public:
    /// Projects the casters, and divides tiles into parts.
    PrimitiveMapBuilder(const Light& light, const std::vector<PlacedCasters>& casters,
                        const PrimitiveMapSettings& settings);

    /// Whether the light is too far off for floats, see leastDepthSpan: there is no map then.
    bool isTooFar() const { return tiles_.depthSpan < leastDepthSpan; }

    /// Triangles in a list that was found to be longer than is wanted; 0: none is known.
    std::size_t tooLong() const { return tooLong_; }
    /// Looks for such a list where most casters crowd, before anything is built: texel by texel, as
    /// the map will have it, so that what is found is certain. Of maps whose texels aren't divided.
    void lookForLongLists();

    std::size_t partCount() const { return parts_.size(); }
    /// Each once, in any order, different ones at the same time.
    void buildPart(std::size_t part);
    /// All of them, on as many threads as there are cores.
    void buildAllParts();
    /// Once all parts are built. Nothing if it is larger than it may be, has too long a list, or
    /// would take minutes.
    std::optional<PrimitiveMap> join();

  private:
    /// A reference of a part's own: to a list, to a block of children, or to nothing.
    struct Texel {
        double darkBehind = std::numeric_limits<double>::infinity();
        enum class Kind { none, list, block } kind = Kind::none;
        std::size_t index = 0;
    };
    struct List {
        std::size_t first = 0, count = 0, forCasters = 0;
    };
    /// A square of a tile's texels.
    struct Part {
        std::size_t tile = 0;
        int x = 0, y = 0, side = 0;
        std::vector<std::uint32_t> candidates;
        std::vector<Texel> texels, blocks;
        std::vector<List> lists;
        std::vector<ListedOccluder> listed;
    };
    struct Tile {
        std::vector<Footprint> prints;
    };
    class PartBuilder;

    /// Counts what a part takes; past what may be taken nothing more is built.
    void charge(std::size_t listed, std::size_t looks);
    /// Likewise, past the longest list that is wanted.
    void chargeList(std::size_t triangles);
    void lookForLongLists(const Part& part);
    TileFootprints footprintsOf(std::size_t tile) const;
    RaySquare squareOf(double x, double y, double side) const;
    void divideIntoParts(std::size_t tile);

    PrimitiveMapSettings settings_;
    LightTiles tiles_;
    Occluders occluders_;
    std::vector<Tile> prints_; ///< by tile
    std::vector<Part> parts_;
    std::atomic<std::size_t> listed_ = 0; ///< entries and texels, by all parts
    std::atomic<std::size_t> looks_ = 0;  ///< at a footprint in a square
    std::atomic<std::size_t> tooLong_ = 0;
    std::atomic<bool> tooLarge_ = false; ///< or too long a list: nothing more is built
};

} // namespace edgeshade
