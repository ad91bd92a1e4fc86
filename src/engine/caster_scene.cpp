#include "src/engine/caster_scene.hpp"

#include "preprocess/base/error.hpp"
#include "src/engine/prepared_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace edgeshade {
namespace {

glm::dmat4 placeOf(const Matrix16& numbers) {
    const glm::dmat4 place = matrixOf(numbers);
    for (const double value : numbers)
        if (!std::isfinite(value))
            throw InputError("A mesh's matrix has a number that is not finite.");
    if (numbers[3] != 0.0 || numbers[7] != 0.0 || numbers[11] != 0.0 || numbers[15] != 1.0)
        throw InputError("A mesh's matrix is not affine: its last row is not 0, 0, 0, 1.");
    if (glm::determinant(glm::dmat3(place)) == 0.0)
        throw InputError("A mesh's matrix is singular: it flattens the mesh.");
    return place;
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
    const glm::dmat4 place = placeOf(worldFromObject);
    const std::size_t at = freeBatch();
    put(at, mesh);
    show(at, place);
    return static_cast<Id>(at);
}

std::size_t CasterScene::freeBatch() {
    const auto free = std::find(taken_.begin(), taken_.end(), false);
    const auto at = static_cast<std::size_t>(free - taken_.begin());
    if (free == taken_.end()) {
        loaded_.scene.batches.emplace_back();
        loaded_.planePairs.emplace_back();
        meshes_.emplace_back();
        gpu_->batches.emplace_back();
        taken_.push_back(false);
        uploaded_.push_back(false);
    }
    return at;
}

void CasterScene::show(std::size_t batch, const glm::dmat4& worldFromBatch) {
    place(batch, worldFromBatch);
    taken_[batch] = true;
    gpu_->batches[batch].hidden = false;
}

void CasterScene::change(Id id, const PreparedMesh& mesh) {
    requireKnown(id);
    put(id, mesh);
}

void CasterScene::setAlpha(Id id, const MaskAlpha& alpha) {
    requireKnown(id);
    if (!meshes_[id]->alphaTested)
        throw InputError("Mesh " + std::to_string(id) + " is not alpha-tested.");
    for (const float number : alpha.texcoordTransform)
        if (!std::isfinite(number))
            throw InputError("An alpha's transform has a number that is not finite.");
    if (!std::isfinite(alpha.opacity) || !std::isfinite(alpha.cutoff))
        throw InputError("An alpha has an opacity or a cutoff that is not finite.");
    gpu_->batches[id].alpha = lookupOf(alpha);
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
    place(id, placeOf(worldFromObject));
}

void CasterScene::remove(Id id) {
    requireKnown(id);
    put(id, PreparedMesh(MaskMesh{}));
    gpu_->batches[id].hidden = true;
    taken_[id] = false;
}

void CasterScene::requireKnown(Id id) const {
    if (id >= taken_.size() || !taken_[id])
        throw InputError("There is no mesh " + std::to_string(id) + ".");
}

void CasterScene::place(std::size_t batch, const glm::dmat4& worldFromBatch) {
    if (casts(batch) && loaded_.scene.batches[batch].worldFromBatch != worldFromBatch)
        ++casterState_;
    loaded_.scene.batches[batch].worldFromBatch = worldFromBatch;
    gpu_->batches[batch].worldFromBatch = worldFromBatch;
    changed();
}

void CasterScene::put(std::size_t batch, const PreparedMesh& mesh) {
    const bool cast = loaded_.planePairs[batch] && casts(batch);
    loaded_.scene.batches[batch].geometry = mesh.data()->geometry;
    loaded_.planePairs[batch] = mesh.data()->shadow;
    meshes_[batch] = mesh.data();
    gpu_->batches[batch].alpha.reset();
    if (mesh.data()->alphaTested) gpu_->batches[batch].alpha = lookupOf(MaskAlpha{});
    if (cast || casts(batch)) ++casterState_;
    uploaded_[batch] = false;
    changed();
}

void CasterScene::changed() {
    bounds_.reset();
    treeIsCurrent_ = false;
    layers_.clear();
    gpu_->groups.clear();
}

CasterScene::Buffers CasterScene::buffersOf(const PreparedMesh::Data& mesh) const {
    Batch batch;
    batch.geometry = mesh.geometry;
    return {
        std::make_shared<std::vector<SurfaceChunk>>(uploadSurfaces(batch, loaded_.scene.materials)),
        std::make_shared<PlanePairBuffers>(mesh.shadow, mesh.alphaCorners, layout_)};
}

void CasterScene::upload(const PreparedMesh& mesh) {
    std::erase_if(ahead_, [](const auto& entry) { return entry.second.mesh.expired(); });
    if (ahead_.contains(mesh.data()->shadow.get())) return;
    ahead_[mesh.data()->shadow.get()] = {mesh.data(), buffersOf(*mesh.data())};
}

void CasterScene::upload() {
    if (std::find(uploaded_.begin(), uploaded_.end(), false) == uploaded_.end()) return;
    std::map<const PlanePairShadow*, std::size_t> first;
    for (std::size_t i = 0; i < uploaded_.size(); ++i)
        if (uploaded_[i]) first.emplace(loaded_.planePairs[i].get(), i);
    for (std::size_t i = 0; i < uploaded_.size(); ++i) {
        if (uploaded_[i]) continue;
        GpuBatch& to = gpu_->batches[i];
        uploaded_[i] = true;
        const auto [same, isFirst] = first.emplace(loaded_.planePairs[i].get(), i);
        if (!isFirst) {
            to.surfaces = gpu_->batches[same->second].surfaces;
            to.volumes = gpu_->batches[same->second].volumes;
            continue;
        }
        const auto ahead = ahead_.find(loaded_.planePairs[i].get());
        const Buffers buffers =
            ahead != ahead_.end() ? ahead->second.buffers : buffersOf(*meshes_[i]);
        to.surfaces = buffers.surfaces;
        to.volumes.planePairs = buffers.volumes;
        if (ahead != ahead_.end()) ahead_.erase(ahead);
    }
    std::set<const PlanePairBuffers*> owned;
    for (GpuBatch& batch : gpu_->batches)
        batch.owns = owned.insert(batch.volumes.planePairs.get()).second;
}

std::vector<LookupTask::Caster> CasterScene::casters() const {
    std::vector<LookupTask::Caster> all;
    for (std::size_t i = 0; i < taken_.size(); ++i)
        if (taken_[i] && casts(i))
            all.push_back({loaded_.planePairs[i], loaded_.scene.batches[i].worldFromBatch});
    return all;
}

void CasterScene::fillLayers(std::vector<FrameLight>& lights) {
    layers_.fill(loaded_.layerCasters(), lights);
}

const Box& CasterScene::bounds() {
    if (!bounds_) bounds_ = worldBounds(loaded_.scene);
    return *bounds_;
}

const SceneTree& CasterScene::tree() {
    if (!treeIsCurrent_) tree_.update(loaded_.scene);
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
