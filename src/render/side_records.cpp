#include "src/render/side_records.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// From the first cluster's first record to the last one's last.
template <class Member>
RecordRange rangeOver(const AdaptedShadow& shadow, const RecordRange& clusters, Member member) {
    const RecordRange& first = shadow.clusters[clusters.first].*member;
    const RecordRange& last = shadow.clusters[clusters.end() - 1].*member;
    return {first.first, last.end() - first.first};
}

/// Where the records of neighbouring clusters are in a list.
RecordRange listedOver(const PairList& list, const RecordRange& clusters) {
    const std::uint32_t first = list.ofCluster[clusters.first].first;
    return {first, list.ofCluster[clusters.end() - 1].end() - first};
}

std::uint32_t countOf(const std::vector<SideRecords>& records) {
    std::uint32_t count = 0;
    for (const SideRecords& some : records)
        count += some.range.count;
    return count;
}

/// Of the triangles that are drawn for a cluster's caps of one kind.
std::uint32_t capCount(const AdaptedShadow& shadow, const ProposedRecords* proposed,
                       const VolumeDraw& draw, std::uint32_t cluster) {
    const ShadowCluster& drawn = shadow.clusters[cluster];
    const bool fewer = proposed && takesLightFacingCaps(drawn, draw.counted);
    return fewer ? lightFacingCapCount(*proposed, drawn) : drawn.caps.count;
}

/// How many records a draw takes.
std::size_t drawnRecords(const AdaptedShadow& shadow, const ProposedRecords* proposed,
                         const VolumeDraw& draw) {
    return countOf(sideRecords(shadow, proposed, draw, Times::once)) +
           countOf(sideRecords(shadow, proposed, draw, Times::twice));
}

} // namespace

std::vector<SideRecords> sideRecords(const AdaptedShadow& shadow, const ProposedRecords* proposed,
                                     const VolumeDraw& draw, Times times) {
    using Kind = SideRecords::Kind;
    std::vector<SideRecords> taken;
    const auto take = [&](Kind kind, const RecordRange& range) {
        if (range.count > 0) taken.push_back({kind, range});
    };
    const bool bothCast = draw.counted == Counted::all;
    if (times == Times::once)
        take(Kind::singles, rangeOver(shadow, draw.clusters, &ShadowCluster::singles));
    else if (!bothCast)
        return taken;
    if (!proposed) {
        take(Kind::allPairs, rangeOver(shadow, draw.clusters, &ShadowCluster::pairs));
        return taken;
    }
    const bool twiceOrNever = bothCast && times == Times::once;
    if (!twiceOrNever) take(Kind::certainPairs, listedOver(proposed->list.certain, draw.clusters));
    if (!twiceOrNever || proposed->lightInPlane)
        take(Kind::uncertainPairs, listedOver(proposed->list.uncertain, draw.clusters));
    return taken;
}

VolumeDraw drawOf(const VolumeDraw& draw, std::uint32_t cluster) {
    VolumeDraw one = draw;
    one.clusters = {cluster, 1};
    return one;
}

bool takesFannedCaps(const AdaptedShadow& shadow, const ProposedRecords* proposed,
                     const VolumeDraw& draw, std::uint32_t cluster) {
    if (!draw.fannedCaps || !proposed) return false;
    const std::size_t records = drawnRecords(shadow, proposed, drawOf(draw, cluster));
    return 2 * records < capCount(shadow, proposed, draw, cluster);
}

bool mayCountTwice(const AdaptedShadow& shadow, const ProposedRecords* proposed,
                   const std::vector<VolumeDraw>& draws) {
    return std::any_of(draws.begin(), draws.end(), [&](const VolumeDraw& draw) {
        return !sideRecords(shadow, proposed, draw, Times::twice).empty();
    });
}

std::size_t vertexRuns(const AdaptedShadow& shadow, const ProposedRecords* proposed,
                       const std::vector<VolumeDraw>& draws, const std::vector<Material>& materials,
                       bool sun) {
    std::size_t runs = 0;
    for (const VolumeDraw& draw : draws) {
        const std::size_t perQuad = sun && draw.end < 0 ? 3 : verticesPerQuad;
        runs += perQuad * drawnRecords(shadow, proposed, draw);
        if (!draw.zFail()) continue;
        const std::size_t kinds = (draw.frontCaps ? 1 : 0) + (draw.backCaps ? 1 : 0);
        for (std::uint32_t c = draw.clusters.first; c < draw.clusters.end(); ++c) {
            const ShadowCluster& cluster = shadow.clusters[c];
            const bool fanned = takesFannedCaps(shadow, proposed, draw, c);
            runs += verticesPerCap * kinds *
                    (fanned ? drawnRecords(shadow, proposed, drawOf(draw, c))
                            : capCount(shadow, proposed, draw, c));
            if (!cluster.holes || !draw.frontCaps) continue;
            // Opaque triangles of such a cluster take one front cap, those with holes two.
            for (std::uint32_t g = cluster.groups.first; g < cluster.groups.end(); ++g)
                if (materials[shadow.groups[g].material].alphaMode != AlphaMode::opaque)
                    runs += verticesPerCap * shadow.groups[g].capCount;
        }
    }
    return runs;
}

} // namespace edgeshade
