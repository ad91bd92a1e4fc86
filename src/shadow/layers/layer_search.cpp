#include "src/shadow/layers/layer_search.hpp"

#include "src/shadow/geometry/planes_between.hpp"
#include "src/shadow/layers/face_bound.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// A batch that a light may see.
struct LitBatch {
    const CasterChain* chain;
    FollowedChain* followed;
    LightInBatch light;
    CasterReach reach;
    RaysOfBatch rays;
    glm::dmat3 batchFromWorld; ///< of directions
};

/// Some direction on a face that is in line with few models.
const glm::dvec3 somewhere{0.0137, 0.0291, 1.0};

/// At most how many certain triangles a ray from a point light meets; no fewer than on any ray that
/// is next to it.
int countAlong(const glm::dvec3& direction, const std::vector<LitBatch>& batches) {
    int met = 0;
    for (const LitBatch& batch : batches)
        met += trianglesAlong(
            direction, batch.rays, *batch.chain, batch.followed->facings(),
            batch.chain->capsAlong(batch.light, batch.batchFromWorld * direction, batch.reach));
    return met;
}

CasterReach reachInBatch(const Light& light, const std::vector<glm::dvec4>& planes,
                         const glm::dmat4& worldFromBatch) {
    CasterReach reach{rangeInObject(light, worldFromBatch)};
    for (const glm::dvec4& plane : planes)
        reach.planes.push_back(plane * worldFromBatch);
    return reach;
}

/// Lets the rays of a directional light enter the frame around all that it sees.
void enterFrame(std::vector<LitBatch>& batches, FaceChain& face) {
    Outline all;
    for (const LitBatch& of : batches)
        all.add(of.rays.outlineOf(of.chain->bounds()));
    face.frame = FaceFrame::around(all);
    for (LitBatch& of : batches)
        of.rays.enter(face.frame);
}

} // namespace

LayerBound LayerSearch::bound(const LayerCasters& casters, std::span<const Light> lights,
                              std::size_t limit, const Box& receivers) {
    LayerBound bound;
    bound.most = casters.scene.triangleCount();
    if (bound.most <= limit) return bound;
    bound.most = 0;
    for (const Light& light : lights) {
        const auto most = bySilhouettes(casters, light, limit, receivers);
        if (!most) return boundByTriangles(casters.scene, casters.castMasked, lights, limit);
        bound.most = std::max(bound.most, *most);
    }
    return bound;
}

std::optional<std::size_t> LayerSearch::bySilhouettes(const LayerCasters& casters,
                                                      const Light& light, std::size_t limit,
                                                      const Box& receivers) {
    // Records that nobody holds are of an earlier pose.
    if (std::erase_if(chains_, [](const auto& item) { return item.second.records.expired(); }) > 0)
        followed_.clear();
    const LightView view(light);
    const std::vector<glm::dvec4> planes = planesBetween(light.position, receivers);
    faces_.resize(view.faces.size());
    for (FaceChain& face : faces_)
        face.clear();
    followed_.resize(casters.scene.batches.size());
    std::vector<LitBatch> batches;
    for (std::size_t i = 0; i < followed_.size(); ++i) {
        const Batch& batch = casters.scene.batches[i];
        if (batch.hidden || !casters.records[i] || casters.records[i]->caps.empty()) continue;
        const glm::dmat4& worldFromBatch = batch.worldFromBatch;
        const CasterChain& chain = chainOf(casters.records[i]);
        const LightInBatch inBatch = lightInBatch(light, worldFromBatch);
        const CasterReach reach = reachInBatch(light, planes, worldFromBatch);
        if (!reach.mayHold(chain.bounds(), inBatch)) continue;
        Followed& followed = followed_[i];
        if (followed.chain != &chain) followed = {&chain, {}};
        batches.push_back({&chain, &followed.of, inBatch, reach,
                           RaysOfBatch(view, worldFromBatch, chain.size()),
                           glm::inverse(glm::dmat3(worldFromBatch))});
    }
    if (view.directional) enterFrame(batches, faces_[0]);
    for (LitBatch& of : batches) {
        of.chain->look(of.light, of.reach, *of.followed, seen_);
        drawChain(view, of.rays, *of.chain, seen_, faces_);
    }
    FaceBound bound(limit);
    for (std::size_t face = 0; face < faces_.size(); ++face) {
        if (!view.directional) settle(faces_[face]);
        const Outline part = filledPart(faces_[face], view);
        const glm::dvec3 start =
            part.empty() ? somewhere : glm::dvec3(faces_[face].frame.from({part.u0, part.v0}), 1.0);
        // Nothing is in line with a sun outside of everything.
        const int met = view.directional ? 0 : countAlong(view.faces[face] * start, batches);
        if (!bound.holds(faces_[face], part, met)) return std::nullopt;
    }
    return static_cast<std::size_t>(bound.most());
}

const CasterChain& LayerSearch::chainOf(const std::shared_ptr<const PlanePairShadow>& records) {
    const auto found = chains_.find(records.get());
    if (found != chains_.end()) return found->second.chain;
    return chains_.emplace(records.get(), Kept{records, CasterChain(*records)}).first->second.chain;
}

} // namespace edgeshade
