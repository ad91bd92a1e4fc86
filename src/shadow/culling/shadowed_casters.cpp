#include "src/shadow/culling/shadowed_casters.hpp"

#include "src/shadow/primitive_map/texel_occluders.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// Texels along the edge of what casters are sorted into first.
constexpr int partSide = 32;

/// Occluder::contours.
constexpr std::uint8_t allEdges = 7;

/// Into how many pieces squares are divided along each axis.
constexpr int pieces = 4;

/// Casting triangles of all batches in the light's map space, and which of whose each is.
struct Collected {
    struct Source {
        std::size_t batch;
        std::uint32_t cap;
    };
    std::vector<Occluder> occluders;
    std::vector<Source> sources;
};

Collected collected(const Light& light, const LightTiles& tiles,
                    const std::vector<CullingCasters>& casters) {
    Collected all;
    for (std::size_t b = 0; b < casters.size(); ++b) {
        const CullingCasters& of = casters[b];
        std::vector<const ShadowCluster*> clusterOf(of.shadow->caps.size());
        for (const ShadowCluster& cluster : of.shadow->clusters)
            std::fill_n(clusterOf.begin() + cluster.caps.first, cluster.caps.count, &cluster);
        for (Occluder& occluder : occludersOf(light, tiles, {of.placed}).all) {
            const std::uint32_t cap = of.placed.casters->mesh.source[occluder.triangle];
            const ShadowCluster& cluster = *clusterOf[cap];
            const bool certain = !cluster.alphaTested && of.facings[cap] != 0 &&
                                 (of.facings[cap] > 0) == occluder.lightFacing;
            // Of closed clusters light-facing triangles alone may count.
            occluder.blocks = certain && (occluder.lightFacing || !cluster.closed);
            // What isn't certain goes on across none of its edges.
            if (!certain) occluder.contours = allEdges;
            all.sources.push_back({b, cap});
            all.occluders.push_back(occluder);
        }
    }
    return all;
}

/// Finds the occluders of one tile that must stay: those that in some texel begin no later than
/// all of its rays are blocked.
class Sieve {
  public:
    Sieve(const LightTiles& tiles, std::size_t tile, const std::vector<Occluder>& occluders,
          const CullingGrid& grid, std::vector<std::uint8_t>& stays)
        : grid_(grid), stays_(stays) {
        for (std::uint32_t i = 0; i < occluders.size(); ++i)
            if (const auto print = footprintOf(occluders[i], i, tiles, tile))
                prints_.push_back(*print);
        tile_ = {occluders, prints_, tiles.directional, TileSpread(tiles, tile)};
    }

    void run() {
        const int side = std::min(partSide, grid_.size), perRow = grid_.size / side;
        std::vector<std::vector<std::uint32_t>> parts(static_cast<std::size_t>(perRow * perRow));
        const double reach = marginOfTile() + mapRounding;
        const auto partAt = [&](double at) {
            return static_cast<int>(
                std::clamp(std::floor((at + 1.0) * 0.5 * perRow), 0.0, perRow - 1.0));
        };
        for (std::uint32_t i = 0; i < prints_.size(); ++i)
            for (int y = partAt(prints_[i].low.y - reach); y <= partAt(prints_[i].high.y + reach);
                 ++y)
                for (int x = partAt(prints_[i].low.x - reach);
                     x <= partAt(prints_[i].high.x + reach); ++x)
                    parts[static_cast<std::size_t>(y * perRow + x)].push_back(i);
        for (int y = 0; y < perRow; ++y)
            for (int x = 0; x < perRow; ++x)
                sift(x * side, y * side, side, parts[static_cast<std::size_t>(y * perRow + x)]);
    }

    std::span<const Footprint> prints() const { return prints_; }

  private:
    double marginOfTile() const { return 2.0 * grid_.margin / grid_.size; }

    RaySquare squareOf(int x, int y, int side) const {
        const double scale = 2.0 / grid_.size;
        const glm::dvec2 low(x * scale - 1.0, y * scale - 1.0);
        return RaySquare{low, low + side * scale}.grownBy(marginOfTile() + mapRounding);
    }

    std::uint8_t& stays(std::uint32_t print) { return stays_[prints_[print].occluder]; }

    void sift(int x, int y, int side, const std::vector<std::uint32_t>& candidates) {
        if (candidates.empty()) return;
        TexelOccluders found;
        findOccluders(tile_, candidates, squareOf(x, y, side), false, found);
        const bool settled = std::all_of(found.touching.begin(), found.touching.end(),
                                         [&](std::uint32_t print) { return stays(print) != 0; });
        if (settled) return;
        if (side == 1) {
            for (const std::uint32_t print : found.touching)
                stays(print) = 1;
            return;
        }
        const int step = std::max(1, side / pieces);
        for (int j = 0; j < side; j += step)
            for (int i = 0; i < side; i += step)
                sift(x + i, y + j, step, found.touching);
    }

    CullingGrid grid_;
    std::vector<Footprint> prints_;
    TileFootprints tile_;
    std::vector<std::uint8_t>& stays_; ///< by occluder
};

} // namespace

std::vector<std::vector<std::uint8_t>> shadowedCasters(const Light& light,
                                                       const std::vector<CullingCasters>& casters,
                                                       const CullingGrid& grid) {
    std::vector<std::vector<std::uint8_t>> gone;
    std::vector<PlacedCasters> placed;
    for (const CullingCasters& of : casters) {
        gone.emplace_back(of.shadow->caps.size(), 0);
        placed.push_back(of.placed);
    }
    const auto tiles = tilesFor(light, placed);
    if (!tiles || tiles->depthSpan < leastDepthSpan) return gone;
    const Collected all = collected(light, *tiles, casters);
    std::vector<std::uint8_t> stays(all.occluders.size(), 0), seen(all.occluders.size(), 0);
    for (std::size_t tile = 0; tile < tiles->tiles.size(); ++tile) {
        Sieve sieve(*tiles, tile, all.occluders, grid, stays);
        sieve.run();
        for (const Footprint& print : sieve.prints())
            seen[print.occluder] = 1;
    }
    for (std::size_t i = 0; i < all.occluders.size(); ++i)
        if (seen[i] != 0 && stays[i] == 0) gone[all.sources[i].batch][all.sources[i].cap] = 1;
    return gone;
}

} // namespace edgeshade
