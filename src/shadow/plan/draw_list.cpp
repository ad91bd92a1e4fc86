#include "src/shadow/plan/draw_list.hpp"

#include "preprocess/base/inline_vector.hpp"

namespace edgeshade {
namespace {

using Records = VolumeDraw::Records;
using Shape = VolumeDraw::Shape;

/// Neighbouring records that one draw sends to the vertex shader.
struct SideRecords {
    Records records;
    RecordRange range;
};

/// The range from the first cluster's first record to the last cluster's last.
template <class Member>
RecordRange rangeOver(const PlanePairShadow& shadow, const RecordRange& clusters, Member member) {
    const RecordRange& first = shadow.clusters[clusters.first].*member;
    const RecordRange& last = shadow.clusters[clusters.end() - 1].*member;
    return {first.first, last.end() - first.first};
}

/// The range in a list that holds the records of neighbouring clusters.
RecordRange listedOver(const PairList& list, const RecordRange& clusters) {
    const std::uint32_t first = list.ofCluster[clusters.first].first;
    return {first, list.ofCluster[clusters.end() - 1].end() - first};
}

/// Builds the draws for a batch's clusters that share one plan.
class ClusterDraws {
  public:
    /// `fanned` must outlive it.
    ClusterDraws(const BatchPlan& batch, std::size_t index, std::size_t choice,
                 std::vector<std::uint8_t>& fanned)
        : shadow_(*batch.shadow), silhouettes_(batch.silhouettes),
          how_(batch.volumes.drawn[choice]), fanned_(fanned) {
        like_.batch = index;
        like_.choice = choice;
        like_.counted = how_.counted;
        like_.zFail = how_.zFail();
        end_ = endOf(how_, batch.ends);
        // A directional light pushes all points to the same point at infinity.
        verticesPerSide_ = batch.light.w == 0.0f && how_.end < 0 ? 3 : verticesPerQuad;
        like_.faces = !how_.backCaps   ? CapFaces::front
                      : how_.frontCaps ? CapFaces::both
                                       : CapFaces::back;
        fanned_.clear();
        fanned_.reserve(shadow_.clusters.size());
        for (std::uint32_t c = how_.clusters.first; c < how_.clusters.end(); ++c)
            fanned_.push_back(takesFans(c));
    }

    void appendSides(Times times, std::vector<VolumeDraw>& draws) const {
        for (const auto& [records, range] : sides(how_.clusters, times)) {
            VolumeDraw& draw = add(Shape::sides, records, range, verticesPerSide_, draws);
            draw.times = times;
            draw.end = end_;
        }
    }

    void appendFans(Times times, std::vector<VolumeDraw>& draws) const {
        if (!hasCaps()) return;
        for (std::uint32_t c = how_.clusters.first; c < how_.clusters.end(); ++c) {
            if (!isFanned(c)) continue;
            for (const auto& [records, range] : sides({c, 1}, times)) {
                VolumeDraw& draw =
                    add(Shape::fans, records, range, verticesPerCap * faceCount(), draws);
                draw.cluster = c;
                draw.times = times;
            }
        }
    }

    void appendCaps(const std::vector<Material>& materials, std::vector<VolumeDraw>& draws) const {
        if (!hasCaps()) return;
        for (std::uint32_t c = how_.clusters.first; c < how_.clusters.end(); ++c) {
            const ShadowCluster& cluster = shadow_.clusters[c];
            if (isFanned(c) || capCount(c) == 0) continue;
            if (knowsLightFacing(cluster)) {
                appendCaps(c, Records::lightFacingCaps, {0, capCount(c)}, std::nullopt, draws);
                continue;
            }
            for (std::uint32_t g = cluster.groups.first; g < cluster.groups.end(); ++g) {
                const MaterialCasters& group = shadow_.groups[g];
                const bool opaque = materials[group.material].alphaMode == AlphaMode::opaque;
                std::optional<std::size_t> alphaTested;
                if (cluster.alphaTested && !opaque && how_.frontCaps) alphaTested = group.material;
                if (cutoutsAlone() && !alphaTested) continue;
                appendCaps(c, Records::caps, {group.firstCap - cluster.caps.first, group.capCount},
                           alphaTested, draws);
            }
        }
    }

    void appendCulledCaps(const std::vector<Material>& materials,
                          std::vector<VolumeDraw>& draws) const {
        if (!how_.culledCaps) return;
        for (std::uint32_t c = how_.clusters.first; c < how_.clusters.end(); ++c) {
            const ShadowCluster& cluster = shadow_.clusters[c];
            if (cluster.singleSided == 0) continue;
            if (!cluster.alphaTested) {
                appendCulledCaps(c, {0, cluster.singleSided}, std::nullopt, draws);
                continue;
            }
            for (std::uint32_t g = cluster.groups.first; g < cluster.groups.end(); ++g) {
                const MaterialCasters& group = shadow_.groups[g];
                const Material& material = materials[group.material];
                // BLEND casters are not in the depth buffer; their caps stay in place.
                if (material.doubleSided || material.alphaMode == AlphaMode::blend ||
                    !material.isSeen())
                    continue;
                std::optional<std::size_t> alphaTested;
                if (material.alphaMode == AlphaMode::mask) alphaTested = group.material;
                appendCulledCaps(c, {group.firstCap - cluster.caps.first, group.capCount},
                                 alphaTested, draws);
            }
        }
    }

  private:
    bool cutoutsAlone() const { return how_.caps == CapsNeeded::cutoutsAlone; }
    bool hasCaps() const {
        return (how_.zFail() || cutoutsAlone()) && (how_.frontCaps || how_.backCaps);
    }
    int faceCount() const { return like_.faces == CapFaces::both ? 2 : 1; }
    bool isFanned(std::uint32_t cluster) const { return fanned_[cluster - how_.clusters.first]; }

    VolumeDraw& add(Shape shape, Records records, const RecordRange& range, int verticesPerRecord,
                    std::vector<VolumeDraw>& draws) const {
        VolumeDraw& draw = draws.emplace_back(like_);
        draw.shape = shape;
        draw.records = records;
        draw.range = range;
        draw.verticesPerRecord = verticesPerRecord;
        return draw;
    }

    void appendCaps(std::uint32_t cluster, Records records, const RecordRange& range,
                    std::optional<std::size_t> alphaTested, std::vector<VolumeDraw>& draws) const {
        const int triangles = faceCount() + (alphaTested && !cutoutsAlone() ? 1 : 0);
        VolumeDraw& draw = add(Shape::caps, records, range, verticesPerCap * triangles, draws);
        draw.cutoutsAlone = cutoutsAlone();
        draw.cluster = cluster;
        draw.nearDiscard = how_.nearDiscard;
        draw.alphaTested = alphaTested;
    }

    void appendCulledCaps(std::uint32_t cluster, const RecordRange& range,
                          std::optional<std::size_t> alphaTested,
                          std::vector<VolumeDraw>& draws) const {
        VolumeDraw& draw = add(Shape::caps, Records::caps, range, verticesPerCap, draws);
        draw.cluster = cluster;
        draw.zFail = false;
        draw.faces = CapFaces::front;
        draw.alphaTested = alphaTested;
        draw.culled = true;
    }

    /// The records whose sides may count `times`.
    InlineVector<SideRecords, 3> sides(const RecordRange& clusters, Times times) const {
        InlineVector<SideRecords, 3> taken;
        const auto take = [&](Records records, const RecordRange& range) {
            if (range.count > 0) taken.push_back({records, range});
        };
        const bool bothCast = how_.counted == Counted::all;
        if (times == Times::once)
            take(Records::singles, rangeOver(shadow_, clusters, &ShadowCluster::singles));
        else if (!bothCast)
            return taken;
        if (!silhouettes_) {
            take(Records::allPairs, rangeOver(shadow_, clusters, &ShadowCluster::pairs));
            return taken;
        }
        const bool twiceOrNever = bothCast && times == Times::once;
        if (!twiceOrNever) take(Records::certainPairs, listedOver(silhouettes_->certain, clusters));
        if (!twiceOrNever || silhouettes_->lightInPlane)
            take(Records::uncertainPairs, listedOver(silhouettes_->uncertain, clusters));
        return taken;
    }

    /// Whether the cluster's caps can be limited to those that may face the light.
    bool knowsLightFacing(const ShadowCluster& cluster) const {
        return silhouettes_ && how_.counted == Counted::lightFacing && !cluster.alphaTested;
    }

    /// Number of caps of one kind, front or back, that are drawn for a cluster.
    std::uint32_t capCount(std::uint32_t cluster) const {
        const ShadowCluster& of = shadow_.clusters[cluster];
        return knowsLightFacing(of) ? silhouettes_->lightFacingCaps[cluster] : of.caps.count;
    }

    /// Whether fans replace the cluster's caps.
    bool takesFans(std::uint32_t cluster) const {
        if (!how_.fannedCaps || !silhouettes_) return false;
        std::uint32_t records = 0;
        for (const Times times : {Times::once, Times::twice})
            for (const SideRecords& some : sides({cluster, 1}, times))
                records += some.range.count;
        return 2 * records < capCount(cluster);
    }

    const PlanePairShadow& shadow_;
    const SilhouetteList* silhouettes_;
    const ClusterPlan& how_;
    VolumeDraw like_; ///< the values that all draws share
    glm::vec4 end_;
    int verticesPerSide_;
    std::vector<std::uint8_t>& fanned_; ///< by cluster
};

} // namespace

void appendDraws(const BatchPlan& batch, std::size_t index, const std::vector<Material>& materials,
                 std::vector<std::uint8_t>& fanned, DrawList& list) {
    for (std::size_t i = 0; i < batch.volumes.drawn.size(); ++i) {
        const ClusterDraws draws(batch, index, i, fanned);
        draws.appendSides(Times::twice, list.twice);
        draws.appendFans(Times::twice, list.twice);
        draws.appendSides(Times::once, list.once);
        draws.appendFans(Times::once, list.once);
        draws.appendCaps(materials, list.once);
        draws.appendCulledCaps(materials, list.once);
    }
}

} // namespace edgeshade
