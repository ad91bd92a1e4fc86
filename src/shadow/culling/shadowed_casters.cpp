#include "src/shadow/culling/shadowed_casters.hpp"

#include "src/shadow/primitive_map/texel_occluders.hpp"

#include <algorithm>
#include <atomic>
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

/// 1 of what must stay; several threads write.
using Stays = std::vector<std::atomic<std::uint8_t>>;

/// Finds the occluders of one tile that must stay: those that in some texel begin no later than
/// all of its rays are blocked.
class Sieve {
  public:
    Sieve(const LightTiles& tiles, std::size_t tile, const std::vector<Occluder>& occluders,
          const CullingSettings& settings, Stays& stays)
        : settings_(settings), stays_(stays) {
        for (std::uint32_t i = 0; i < occluders.size(); ++i)
            if (const auto print = footprintOf(occluders[i], i, tiles, tile))
                prints_.push_back(*print);
        tile_ = {occluders, prints_, tiles.directional, TileSpread(tiles, tile)};
    }

    void run() {
        const int side = std::min(partSide, settings_.size), perRow = settings_.size / side;
        std::vector<std::vector<std::uint32_t>> parts(static_cast<std::size_t>(perRow * perRow));
        for (std::uint32_t i = 0; i < prints_.size(); ++i) {
            const auto [low, high] = reachOf(prints_[i]);
            const auto partAt = [&](double at) {
                return static_cast<int>(
                    std::clamp(std::floor((at + 1.0) * 0.5 * perRow), 0.0, perRow - 1.0));
            };
            for (int y = partAt(low.y); y <= partAt(high.y); ++y)
                for (int x = partAt(low.x); x <= partAt(high.x); ++x)
                    parts[static_cast<std::size_t>(y * perRow + x)].push_back(i);
        }
        inParallel(parts.size(), settings_.threads, [&](std::size_t part) {
            const int at = static_cast<int>(part);
            sift(at % perRow * side, at / perRow * side, side, parts[part]);
        });
    }

    std::span<const Footprint> prints() const { return prints_; }

  private:
    double margin() const { return 2.0 * settings_.margin / settings_.size + mapRounding; }

    /// The rays of all texels that it may touch.
    RaySquare reachOf(const Footprint& print) const {
        if (print.nearLight) return {glm::dvec2(-1.0), glm::dvec2(1.0)};
        return tile_.spread.reaching({print.low, print.high}, print.depths.low).grownBy(margin());
    }

    RaySquare squareOf(int x, int y, int side) const {
        const double scale = 2.0 / settings_.size;
        const glm::dvec2 low(x * scale - 1.0, y * scale - 1.0);
        return RaySquare{low, low + side * scale}.grownBy(margin());
    }

    std::atomic<std::uint8_t>& stays(std::uint32_t print) {
        return stays_[prints_[print].occluder];
    }

    void sift(int x, int y, int side, const std::vector<std::uint32_t>& candidates) {
        if (candidates.empty() || (settings_.givenUp && settings_.givenUp())) return;
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

    const CullingSettings& settings_;
    std::vector<Footprint> prints_;
    TileFootprints tile_;
    Stays& stays_; ///< by occluder
};

} // namespace

std::vector<std::vector<std::uint8_t>> shadowedCasters(const Light& light,
                                                       const std::vector<CullingCasters>& casters,
                                                       const CullingSettings& settings) {
    std::vector<std::vector<std::uint8_t>> gone;
    std::vector<PlacedCasters> placed;
    for (const CullingCasters& of : casters) {
        gone.emplace_back(of.shadow->caps.size(), 0);
        placed.push_back(of.placed);
    }
    const auto tiles = tilesFor(light, placed, settings.receivers);
    if (!tiles || tiles->depthSpan < leastDepthSpan) return gone;
    const Collected all = collected(light, *tiles, casters);
    Stays stays(all.occluders.size());
    std::vector<std::uint8_t> seen(all.occluders.size(), 0);
    for (std::size_t tile = 0; tile < tiles->tiles.size(); ++tile) {
        Sieve sieve(*tiles, tile, all.occluders, settings, stays);
        sieve.run();
        for (const Footprint& print : sieve.prints())
            seen[print.occluder] = 1;
    }
    if (settings.givenUp && settings.givenUp()) return gone;
    for (std::size_t i = 0; i < all.occluders.size(); ++i)
        if (seen[i] != 0 && stays[i] == 0) gone[all.sources[i].batch][all.sources[i].cap] = 1;
    return gone;
}

} // namespace edgeshade
