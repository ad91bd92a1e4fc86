#include "src/engine/caster_scene.hpp"

#include "preprocess/base/error.hpp"
#include "src/engine/prepared_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace edgeshade {
namespace {

/// `what`: names the texture; `layers`: the number of its channels.
void requireTexels(const MaskTexels& texels, const std::string& what, std::size_t layers) {
    const auto along = [](int size) { return static_cast<std::size_t>(std::max(size, 0)); };
    const std::size_t count = layers * along(texels.width) * along(texels.height);
    const std::string size = std::to_string(texels.width) + "x" + std::to_string(texels.height);
    if (count == 0 || count > MaskTexels::most)
        throw InputError(what + " has " + size + " texels, not 1 to " +
                         std::to_string(MaskTexels::most / layers) + ".");
    if (texels.alpha.size() != count)
        throw InputError(what + " of " + size + " texels has " +
                         std::to_string(texels.alpha.size()) + " numbers.");
}

void requireTransform(const std::array<float, 9>& transform, const std::string& what) {
    for (const float number : transform)
        if (!std::isfinite(number))
            throw InputError(what + "'s transform has a number that is not finite.");
}

/// Whether two alphas cut the same mesh out in the same way.
bool cutAlike(const MaskAlpha& a, const MaskAlpha& b) {
    if (!a.cutsOut || !b.cutsOut) return a.cutsOut == b.cutsOut;
    return a.texels == b.texels && a.opacity == b.opacity && a.cutoff == b.cutoff &&
           a.texcoordTransform == b.texcoordTransform;
}

} // namespace

CasterScene::CasterScene(SidesLayout layout, const gl::Capabilities& capabilities)
    : layout_(layout) {
    loaded_.scene.materials = maskMaterials();
    loaded_.scene.culls = true;
    loaded_.settings.castMasked = true; // the material decides which of them cast
    gpu_.emplace(
        uploadScene(loaded_, VolumeRecords{VolumeLayout::planePairs, layout_}, capabilities));
}

CasterScene::Id CasterScene::add(const PreparedMesh& mesh, const Matrix16& worldFromObject) {
    return static_cast<Id>(insert(mesh, placeOf(worldFromObject)));
}

std::size_t CasterScene::insert(const PreparedMesh& mesh, const glm::dmat4& worldFromBatch) {
    const std::size_t batch = freeBatch();
    slots_[batch].use = Slot::Use::mesh;
    put(batch, mesh);
    place(batch, worldFromBatch);
    slots_[batch].rest.moved = false;
    return batch;
}

std::size_t CasterScene::freeBatch() {
    while (firstFree_ < slots_.size() && slots_[firstFree_].use != Slot::Use::free)
        ++firstFree_;
    if (firstFree_ == slots_.size()) {
        loaded_.scene.batches.emplace_back();
        loaded_.planePairs.emplace_back();
        gpu_->batches.emplace_back();
        slots_.emplace_back();
    }
    return firstFree_;
}

std::vector<CasterScene::Id> CasterScene::add(const MergedMeshes& meshes) {
    const MergedMeshes::Data& group = *meshes.data();
    std::vector<std::size_t> batches;
    for (const PlacedMesh& of : group.members)
        batches.push_back(insert(PreparedMesh(of.mesh), of.worldFromMesh));
    if (mergedTriangles_ + mostTrianglesMerged <= mostMerged) showMerged(batches, group.merged);
    return {batches.begin(), batches.end()};
}

void CasterScene::change(Id id, const PreparedMesh& mesh) {
    requireKnown(id);
    disturb(id);
    put(id, mesh);
}

void CasterScene::setAlpha(Id id, const MaskAlpha& alpha) {
    requireKnown(id);
    if (!slots_[id].whole->alphaTested)
        throw InputError("Mesh " + std::to_string(id) + " is not alpha-tested.");
    requireTransform(alpha.texcoordTransform, "An alpha");
    if (!std::isfinite(alpha.opacity) || !std::isfinite(alpha.cutoff))
        throw InputError("An alpha has an opacity or a cutoff that is not finite.");
    if (alpha.texels) requireTexels(*alpha.texels, "An alpha", 1);
    const bool alike = cutAlike(slots_[id].alpha, alpha);
    slots_[id].alpha = alpha;
    if (!alike) casterChanged(id, false);
    if (slots_[id].mesh->alphaTested) gpu_->batches[id].alpha = lookupOf(alpha);
}

void CasterScene::setTint(Id id, const std::optional<std::array<float, 3>>& tint,
                          const MaskTintTexture& texture) {
    requireKnown(id);
    for (const float share : tint.value_or(std::array<float, 3>{}))
        if (!(share >= 0.0f && share <= 1.0f))
            throw InputError("A tint lets the share " + std::to_string(share) +
                             " of light through, not 0 to 1.");
    requireTransform(texture.texcoordTransform, "A tint");
    if (texture.texels) requireTexels(*texture.texels, "A tint", 3);
    if (slots_[id].tint == tint && slots_[id].tintTexture == texture) return;
    slots_[id].tint = tint;
    slots_[id].tintTexture = texture;
    casterChanged(id, false);
}

AlphaLookup CasterScene::lookupOf(const MaskAlpha& alpha) const {
    AlphaLookup lookup;
    lookup.texture = alpha.texture != 0 ? alpha.texture : gpu_->textures.of({});
    if (alpha.channel == MaskAlpha::Channel::green) lookup.channel = {0.0f, 1.0f, 0.0f, 0.0f};
    lookup.texcoordTransform = glm::make_mat3(alpha.texcoordTransform.data());
    lookup.factor = alpha.opacity;
    lookup.cutoff = alpha.cutoff;
    return lookup;
}

void CasterScene::move(Id id, const Matrix16& worldFromObject) {
    requireKnown(id);
    const glm::dmat4 to = placeOf(worldFromObject);
    if (loaded_.scene.batches[id].worldFromBatch == to) return;
    disturb(id);
    place(id, to);
    if (clip(id)) show(id, slots_[id].mesh);
}

void CasterScene::setClippings(Id id, std::span<const MaskClipping> clippings) {
    requireKnown(id);
    std::vector<MeshClip> clips;
    std::size_t planes = 0;
    for (const bool cast : {false, true})
        for (const MaskClipping& of : clippings)
            if (of.casts == cast) planes += clips.emplace_back(of).planes();
    if (planes > ShadowMasks::mostClippingPlanes)
        throw InputError(std::to_string(planes) + " planes are more than the " +
                         std::to_string(ShadowMasks::mostClippingPlanes) +
                         " that can clip a mesh.");
    std::vector<MeshClip>& had = slots_[id].clips;
    if (std::equal(clips.begin(), clips.end(), had.begin(), had.end(),
                   [](const MeshClip& a, const MeshClip& b) { return a.hasSamePlanes(b); }))
        return;
    for (std::size_t i = 0; i < std::min(clips.size(), had.size()); ++i)
        clips[i].takeMade(std::move(had[i]));
    had = std::move(clips);
    const std::shared_ptr<const PreparedMesh::Data> before = slots_[id].caster;
    const bool cast = slots_[id].casts();
    if (clip(id)) {
        disturb(id);
        show(id, slots_[id].mesh);
    }
    if (slots_[id].caster != before && (cast || slots_[id].casts())) casterChanged(id);
}

bool CasterScene::clip(std::size_t batch) {
    Slot& slot = slots_[batch];
    const auto before = std::exchange(slot.mesh, slot.whole);
    slot.caster = slot.whole;
    for (MeshClip& by : slot.clips) {
        slot.mesh = by.clip(slot.mesh, loaded_.scene.batches[batch].worldFromBatch, slot.own);
        if (!by.casts()) slot.caster = slot.mesh;
    }
    return slot.mesh != before;
}

void CasterScene::remove(Id id) {
    requireKnown(id);
    disturb(id);
    if (slots_[id].casts()) casterChanged(id);
    release(id);
}

void CasterScene::release(std::size_t batch) {
    show(batch, nullptr);
    slots_[batch] = {};
    firstFree_ = std::min(firstFree_, batch);
}

void CasterScene::requireKnown(Id id) const {
    if (id >= slots_.size() || slots_[id].use != Slot::Use::mesh)
        throw InputError("There is no mesh " + std::to_string(id) + ".");
}

void CasterScene::place(std::size_t batch, const glm::dmat4& worldFromBatch) {
    if (slots_[batch].casts() && loaded_.scene.batches[batch].worldFromBatch != worldFromBatch)
        casterChanged(batch);
    loaded_.scene.batches[batch].worldFromBatch = worldFromBatch;
    gpu_->batches[batch].worldFromBatch = worldFromBatch;
    slots_[batch].inWorld.reset();
    slots_[batch].ownInWorld.reset();
    changed();
}

void CasterScene::put(std::size_t batch, const PreparedMesh& mesh) {
    Slot& slot = slots_[batch];
    const bool cast = slot.casts();
    slot.whole = mesh.data();
    slot.alpha = {};
    slot.changed = draws_;
    slot.own = boundsOf(*slot.whole->geometry);
    slot.ownInWorld.reset();
    clip(batch);
    if (cast || slot.casts()) casterChanged(batch);
    show(batch, slot.mesh);
}

void CasterScene::show(std::size_t batch, const std::shared_ptr<const PreparedMesh::Data>& mesh) {
    const PreparedMesh::Data& shown = mesh ? *mesh : *nothing_.data();
    loaded_.scene.batches[batch].geometry = shown.geometry;
    loaded_.planePairs[batch] = shown.shadow;
    gpu_->batches[batch].alpha.reset();
    if (shown.alphaTested) gpu_->batches[batch].alpha = lookupOf(slots_[batch].alpha);
    gpu_->batches[batch].hidden = !mesh;
    slots_[batch].uploaded = false;
    slots_[batch].inWorld.reset();
    changed();
}

void CasterScene::disturb(std::size_t batch) {
    Slot& slot = slots_[batch];
    slot.changed = draws_;
    if (!slot.mergedInto) return;
    slot.patience = std::min(2 * slot.patience, longRest);
    dissolve(*slot.mergedInto);
}

void CasterScene::dissolve(std::size_t merged) {
    for (const std::size_t member : slots_[merged].members) {
        slots_[member].mergedInto.reset();
        slots_[member].changed = draws_;
        show(member, slots_[member].mesh);
    }
    mergedTriangles_ -= slots_[merged].mesh->triangles();
    release(merged);
}

std::vector<MergeCandidate> CasterScene::candidates() const {
    std::vector<MergeCandidate> found;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        const Slot& slot = slots_[i];
        if (slot.use != Slot::Use::mesh || slot.mergedInto || slot.isClipped() ||
            !mayMerge(*slot.mesh) || draws_ - slot.changed < slot.patience)
            continue;
        MergeCandidate& of = found.emplace_back();
        of.number = i;
        of.material = slot.mesh->material();
        of.triangles = slot.mesh->triangles();
        of.box = worldBox(i);
    }
    return found;
}

const Box& CasterScene::worldBox(std::size_t batch) const {
    std::optional<Box>& box = slots_[batch].ownInWorld;
    if (box) return *box;
    box.emplace();
    for (int corner = 0; corner < 8; ++corner)
        box->add(loaded_.scene.batches[batch].worldFromBatch *
                 glm::dvec4(slots_[batch].own.corner(corner), 1.0));
    return *box;
}

void CasterScene::mergeResting() {
    ++draws_;
    if (mergedTriangles_ + mostTrianglesMerged > mostMerged) return;
    const std::vector<MergeCandidate> resting = candidates();
    if (resting.size() < fewestMembers) return;
    const std::vector<std::size_t> members = neighbours(resting);
    if (members.size() >= fewestMembers)
        makeMerged(members);
    else
        for (const std::size_t member : members)
            slots_[member].changed = draws_; // tries again later
}

void CasterScene::makeMerged(const std::vector<std::size_t>& members) {
    std::vector<PlacedMesh> placed;
    for (const std::size_t member : members)
        placed.push_back({slots_[member].mesh, loaded_.scene.batches[member].worldFromBatch});
    showMerged(members, merge(placed));
}

void CasterScene::showMerged(const std::vector<std::size_t>& members, const MergedMesh& merged) {
    const std::size_t batch = freeBatch();
    Slot& slot = slots_[batch];
    slot.use = Slot::Use::merged;
    slot.mesh = merged.mesh.data();
    slot.members = members;
    mergedTriangles_ += slot.mesh->triangles();
    loaded_.scene.batches[batch].worldFromBatch = merged.worldFromMerged;
    gpu_->batches[batch].worldFromBatch = merged.worldFromMerged;
    show(batch, slot.mesh);
    for (const std::size_t member : members) {
        slots_[member].mergedInto = batch;
        show(member, nullptr);
    }
}

std::size_t CasterScene::drawnBatches() const {
    return static_cast<std::size_t>(
        std::count_if(loaded_.scene.batches.begin(), loaded_.scene.batches.end(),
                      [](const Batch& of) { return !of.geometry->indices.empty(); }));
}

void CasterScene::casterChanged(std::size_t batch, bool moves) {
    CasterRest& rest = slots_[batch].rest;
    if (!rest.moves(ShadowMasks::longRestMs)) ++restingState_;
    rest = {++casterState_, std::chrono::steady_clock::now(), rest.moved || moves};
}

void CasterScene::changed() {
    bounds_.reset();
    treeIsCurrent_ = false;
    layers_.clear();
    for (MoverLayers& of : moverLayers_)
        of.layers.clear();
    gpu_->groups.clear();
}

std::shared_ptr<std::vector<SurfaceChunk>>
CasterScene::surfacesOf(const PreparedMesh::Data& mesh) const {
    Batch batch;
    batch.geometry = mesh.geometry;
    return std::make_shared<std::vector<SurfaceChunk>>(
        uploadSurfaces(batch, loaded_.scene.materials));
}

std::shared_ptr<PlanePairBuffers> CasterScene::volumesOf(const PreparedMesh::Data& mesh) const {
    return std::make_shared<PlanePairBuffers>(mesh.shadow, mesh.alphaCorners, layout_);
}

bool CasterScene::uploadStep(const PreparedMesh& of) {
    std::erase_if(ahead_, [](const auto& entry) { return entry.second.mesh.expired(); });
    const PreparedMesh::Data& mesh = *of.data();
    const auto [entry, isNew] = ahead_.try_emplace(mesh.shadow.get(), Ahead{of.data()});
    Ahead& made = entry->second;
    if (isNew && !mesh.shadow->caps.empty())
        chains_->of(mesh.shadow);
    else if (!made.surfaces)
        made.surfaces = surfacesOf(mesh);
    else if (!made.volumes)
        made.volumes = volumesOf(mesh);
    else if (!made.triangles)
        made.triangles.emplace(TriangleTree(*mesh.geometry, loaded_.scene.materials));
    return made.triangles.has_value();
}

bool CasterScene::upload() {
    if (std::all_of(slots_.begin(), slots_.end(), [](const Slot& of) { return of.uploaded; }))
        return false;
    tree(); // while trees that were made ahead are there
    std::map<const PlanePairShadow*, std::size_t> first;
    for (std::size_t i = 0; i < slots_.size(); ++i)
        if (slots_[i].uploaded) first.emplace(loaded_.planePairs[i].get(), i);
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        if (slots_[i].uploaded) continue;
        GpuBatch& to = gpu_->batches[i];
        slots_[i].uploaded = true;
        const auto [same, isFirst] = first.emplace(loaded_.planePairs[i].get(), i);
        if (!isFirst) {
            to.surfaces = gpu_->batches[same->second].surfaces;
            to.volumes = gpu_->batches[same->second].volumes;
            continue;
        }
        const auto found = ahead_.find(loaded_.planePairs[i].get());
        const Ahead ahead = found != ahead_.end() ? found->second : Ahead{};
        const PreparedMesh::Data& mesh = to.hidden ? *nothing_.data() : *slots_[i].mesh;
        to.surfaces = ahead.surfaces ? ahead.surfaces : surfacesOf(mesh);
        to.volumes.planePairs = ahead.volumes ? ahead.volumes : volumesOf(mesh);
        if (found != ahead_.end()) ahead_.erase(found);
    }
    std::set<const PlanePairBuffers*> owned;
    for (GpuBatch& batch : gpu_->batches)
        batch.owns = owned.insert(batch.volumes.planePairs.get()).second;
    return true;
}

bool CasterScene::hasCasters() const {
    for (std::size_t i = 0; i < slots_.size(); ++i)
        if (isCaster(i)) return true;
    return false;
}

CasterScene::Casters CasterScene::resting(double restMs, LookupCasters of) const {
    Casters all;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        const Slot& slot = slots_[i];
        if (!isCaster(i) || slot.rest.moves(restMs)) continue;
        all.held.push_back({i, slot.rest.version});
        LookupTask::Caster& caster = all.casters.emplace_back();
        caster.worldFromBatch = loaded_.scene.batches[i].worldFromBatch;
        if (of.tints && slot.tint)
            caster.cutout = {slot.caster,
                             {.texcoordTransform = slot.tintTexture.texcoordTransform,
                              .texels = slot.tintTexture.texels},
                             slot.tint};
        else if (of.cutouts && slot.cutsOut())
            caster.cutout = {slot.caster, slot.alpha, {}};
        else
            caster.shadow = slot.caster->shadow;
    }
    return all;
}

CasterScene::Casters CasterScene::cutouts(LookupCasters of) const {
    const Casters all = resting(0.0, of);
    Casters alone;
    for (std::size_t i = 0; i < all.casters.size(); ++i) {
        if (all.casters[i].shadow) continue;
        alone.casters.push_back(all.casters[i]);
        alone.held.push_back(all.held[i]);
    }
    return alone;
}

LookupState CasterScene::compare(std::span<const HeldCaster> held, double restMs) const {
    LookupState state;
    std::vector<char> isHeld(slots_.size(), 0);
    state.holds = true;
    for (const HeldCaster& of : held) {
        const bool same = of.batch < slots_.size() && isCaster(of.batch) &&
                          slots_[of.batch].rest.version == of.version;
        if (same)
            isHeld[of.batch] = 1;
        else
            state.holds = false;
    }
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        if (!isCaster(i) || isHeld[i]) continue;
        ++state.movers;
        if (!slots_[i].rest.moves(restMs)) ++state.rested;
    }
    return state;
}

CasterScene::Movers CasterScene::moversOver(std::span<const HeldCaster> held) const {
    Movers movers;
    movers.counted.resize(slots_.size());
    for (std::size_t i = 0; i < slots_.size(); ++i)
        movers.counted[i] = isCaster(i);
    for (const HeldCaster& of : held)
        movers.counted[of.batch] = 0;
    for (std::size_t i = 0; i < slots_.size(); ++i)
        if (movers.counted[i]) movers.bounds.add(worldBox(i));
    for (std::size_t i = 0; i < slots_.size(); ++i)
        for (const std::size_t member : slots_[i].members)
            if (movers.counted[member]) movers.counted[i] = 1;
    return movers;
}

void CasterScene::animate(const Movers& movers) {
    for (std::size_t i = 0; i < slots_.size(); ++i)
        gpu_->batches[i].animated = movers.counted[i];
}

bool CasterScene::fillLayers(FrameView& view) {
    return layers_.fill(loaded_.layerCasters(), view.lights, view.visible);
}

bool CasterScene::fillLayers(FrameView& view, std::size_t light, const Movers& movers) {
    const auto records = recordsOf(movers);
    const LayerCasters casters{loaded_.scene, records, loaded_.settings.castMasked};
    return layersOf(light, movers).fillMovers(casters, view.lights[light], view.visible);
}

bool CasterScene::lookAhead(const FrameView& view, std::size_t light,
                            const std::optional<Movers>& movers) {
    const FrameLight& of = view.lights[light];
    if (!movers) return layers_.lookAhead(loaded_.layerCasters(), of, view.visible);
    const auto records = recordsOf(*movers);
    const LayerCasters casters{loaded_.scene, records, loaded_.settings.castMasked};
    return layersOf(light, *movers).lookAhead(casters, of, view.visible);
}

KeptLayers& CasterScene::layersOf(std::size_t light, const Movers& movers) {
    while (moverLayers_.size() <= light)
        moverLayers_.push_back({KeptLayers(chains_)});
    MoverLayers& kept = moverLayers_[light];
    if (kept.counted != movers.counted) {
        kept.layers.clear();
        kept.counted = movers.counted;
    }
    return kept.layers;
}

std::vector<std::shared_ptr<const PlanePairShadow>>
CasterScene::recordsOf(const Movers& movers) const {
    std::vector<std::shared_ptr<const PlanePairShadow>> records(slots_.size());
    for (std::size_t i = 0; i < slots_.size(); ++i)
        if (movers.counted[i]) records[i] = loaded_.planePairs[i];
    return records;
}

const Box& CasterScene::bounds() {
    if (bounds_) return *bounds_;
    bounds_.emplace();
    for (std::size_t i = 0; i < slots_.size(); ++i)
        bounds_->add(drawnBox(i));
    return *bounds_;
}

const Box& CasterScene::drawnBox(std::size_t batch) {
    std::optional<Box>& box = slots_[batch].inWorld;
    if (!box) box = worldBounds(loaded_.scene.batches[batch]);
    return *box;
}

bool CasterScene::prepareStep() {
    if (!treeIsCurrent_) {
        tree();
        return true;
    }
    if (upload()) return true;
    std::size_t measured = 0;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        if (slots_[i].inWorld) continue;
        if (measured >= mostMeasured) return true;
        measured += loaded_.scene.batches[i].geometry->positions.size();
        drawnBox(i);
    }
    return measured > 0;
}

const SceneTree& CasterScene::tree() {
    if (treeIsCurrent_) return tree_;
    SceneTree::Trees made;
    for (const auto& [shadow, ahead] : ahead_)
        if (const auto mesh = ahead.mesh.lock(); mesh && ahead.triangles)
            made.emplace(&*mesh->geometry, *ahead.triangles);
    tree_.update(loaded_.scene, std::move(made));
    treeIsCurrent_ = true;
    return tree_;
}

std::size_t CasterScene::bytes() const {
    std::size_t total = gpu_->shadowBytes();
    for (const GpuBatch& batch : gpu_->batches)
        if (batch.owns && batch.surfaces)
            for (const SurfaceChunk& chunk : *batch.surfaces)
                total += chunk.vertices.size() + chunk.indices.size();
    return total;
}

} // namespace edgeshade
