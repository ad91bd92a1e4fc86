#include "src/shadow/layers/layer_search.hpp"

#include "src/shadow/geometry/planes_between.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// Some direction on a face that is in line with few models.
const glm::dvec3 somewhere{0.0137, 0.0291, 1.0};

void fillReach(const Light& light, const std::vector<glm::dvec4>& planes,
               const glm::dmat4& worldFromBatch, CasterReach& reach) {
    reach.range = rangeInObject(light, worldFromBatch);
    reach.planes.clear();
    for (const glm::dvec4& plane : planes)
        reach.planes.push_back(plane * worldFromBatch);
}

bool casts(const LayerCasters& casters, std::size_t batch) {
    return !casters.scene.batches[batch].hidden && casters.records[batch] &&
           !casters.records[batch]->caps.empty();
}

/// The records of the smallest caster, and null in place of all others.
std::vector<std::shared_ptr<const PlanePairShadow>> smallestOf(const LayerCasters& casters) {
    std::vector<std::shared_ptr<const PlanePairShadow>> alone(casters.records.size());
    std::optional<std::size_t> least;
    for (std::size_t i = 0; i < casters.records.size(); ++i)
        if (casts(casters, i) &&
            (!least || casters.records[i]->caps.size() < casters.records[*least]->caps.size()))
            least = i;
    if (least) alone[*least] = casters.records[*least];
    return alone;
}

} // namespace

const std::shared_ptr<const CasterChain>&
KeptChains::of(const std::shared_ptr<const PlanePairShadow>& records) {
    Kept& kept = chains_[records.get()];
    if (kept.records.expired()) kept = {records, std::make_shared<const CasterChain>(*records)};
    return kept.chain;
}

void KeptChains::forgetReleased() {
    std::erase_if(chains_, [](const auto& item) { return item.second.records.expired(); });
}

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
    chains_->forgetReleased();
    const LightView view(light);
    const std::span<LitBatch> batches = beginFaces(view, casters, light, receivers);
    for (const LitBatch& of : batches)
        lookAndDraw(view, of);
    bound_.begin(limit);
    for (std::size_t face = 0; face < faces_.size(); ++face) {
        if (!view.directional) settle(faces_[face]);
        const Outline part = filledPart(faces_[face], view);
        const glm::dvec3 start =
            part.empty() ? somewhere : glm::dvec3(faces_[face].frame.from({part.u0, part.v0}), 1.0);
        // Nothing is in line with a sun outside of everything.
        const int met = view.directional ? 0 : countAlong(view.faces[face] * start, batches);
        if (!bound_.holds(faces_[face], part, met)) return std::nullopt;
    }
    return static_cast<std::size_t>(bound_.most());
}

bool LayerSearch::lookAhead(const LayerCasters& casters, const Light& light, std::size_t limit,
                            const Box& receivers) {
    if (casters.scene.triangleCount() <= limit) return true;
    if (followed_.empty()) {
        // Browsers compile a function when it is first called: here, and for few casters.
        const auto few = smallestOf(casters);
        static_cast<void>(bySilhouettes({casters.scene, few}, light, 1));
        return false;
    }
    chains_->forgetReleased();
    const LightView view(light);
    std::size_t looked = 0;
    for (const LitBatch& of : beginFaces(view, casters, light, receivers)) {
        if (!of.followed->isNew()) continue;
        if (looked >= mostAhead) return false;
        lookAndDraw(view, of);
        looked += of.chain->shadow().caps.size();
    }
    return looked == 0;
}

std::span<LayerSearch::LitBatch> LayerSearch::beginFaces(const LightView& view,
                                                         const LayerCasters& casters,
                                                         const Light& light, const Box& receivers) {
    faces_.resize(view.faces.size());
    for (FaceChain& face : faces_)
        face.clear();
    const std::span<LitBatch> batches = findLit(view, casters, light, receivers);
    if (view.directional) enterFrame(batches, faces_[0]);
    return batches;
}

void LayerSearch::lookAndDraw(const LightView& view, const LitBatch& of) {
    of.chain->look(of.light, of.reach, *of.followed, seen_);
    drawChain(view, of.rays, *of.chain, seen_, paths_, faces_);
}

std::span<LayerSearch::LitBatch> LayerSearch::findLit(const LightView& view,
                                                      const LayerCasters& casters,
                                                      const Light& light, const Box& receivers) {
    findPlanesBetween(light.position, receivers, planes_);
    followed_.resize(casters.scene.batches.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < followed_.size(); ++i) {
        const Batch& batch = casters.scene.batches[i];
        if (!casts(casters, i)) {
            if (followed_[i].chain) followed_[i] = {};
            continue;
        }
        const glm::dmat4& worldFromBatch = batch.worldFromBatch;
        const std::shared_ptr<const CasterChain>& chain = chains_->of(casters.records[i]);
        if (lit_.size() == count) lit_.emplace_back();
        LitBatch& of = lit_[count];
        of.light = lightInBatch(light, worldFromBatch);
        fillReach(light, planes_, worldFromBatch, of.reach);
        if (!of.reach.mayHold(chain->bounds(), of.light)) continue;
        Followed& followed = followed_[i];
        if (followed.chain != chain) followed = {chain, {}};
        of.chain = chain.get();
        of.followed = &followed.of;
        of.rays = RaysOfBatch(view, worldFromBatch, chain->size());
        of.batchFromRays = glm::inverse(glm::dmat3(worldFromBatch)) * glm::transpose(view.axes);
        ++count;
    }
    return std::span(lit_).first(count);
}

void LayerSearch::enterFrame(std::span<LitBatch> batches, FaceChain& face) {
    Outline all;
    for (const LitBatch& of : batches)
        all.add(of.rays.outlineOf(of.chain->bounds()));
    face.frame = FaceFrame::around(all);
    for (LitBatch& of : batches)
        of.rays.enter(face.frame);
}

int LayerSearch::countAlong(const glm::dvec3& direction, std::span<const LitBatch> batches) {
    int met = 0;
    for (const LitBatch& of : batches) {
        of.chain->findCapsAlong(of.light, of.batchFromRays * direction, of.reach, caps_);
        met += trianglesAlong(direction, of.rays, *of.chain, of.followed->facings(), caps_);
    }
    return met;
}

} // namespace edgeshade
