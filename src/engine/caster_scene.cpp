#include "src/engine/caster_scene.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/stopwatch.hpp"
#include "preprocess/scene/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

enum MaterialNumber : std::size_t { casting, receiving };

std::vector<Material> materials() {
    std::vector<Material> made(2);
    // All of it is seen, and MASK surfaces cast nothing.
    made[receiving].alphaMode = AlphaMode::mask;
    made[receiving].alphaCutoff = 0.0f;
    return made;
}

Geometry geometryOf(const MaskMesh& from, std::size_t material) {
    TriangleMesh mesh = triangleMesh(from.positions, from.indices);
    Geometry geometry;
    const std::size_t vertices = mesh.positions.size();
    geometry.positions = std::move(mesh.positions);
    geometry.normals.resize(vertices, glm::vec3(0.0f));
    geometry.texcoords.resize(vertices);
    geometry.colors.resize(vertices, glm::vec4(1.0f));
    geometry.indices = std::move(mesh.indices);
    if (!geometry.indices.empty())
        geometry.groups = {{material, 0, static_cast<std::uint32_t>(geometry.indices.size())}};
    return geometry;
}

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
    loaded_.scene.materials = materials();
    gpu_.emplace(
        uploadScene(loaded_, VolumeRecords{VolumeLayout::planePairs, layout_}, capabilities));
}

CasterScene::Id CasterScene::add(const MaskMesh& mesh, const Matrix16& worldFromObject,
                                 bool casts) {
    Geometry geometry = geometryOf(mesh, casts ? casting : receiving);
    const glm::dmat4 place = placeOf(worldFromObject);
    const auto free = std::find(taken_.begin(), taken_.end(), false);
    const auto at = static_cast<std::size_t>(free - taken_.begin());
    if (free == taken_.end()) {
        loaded_.scene.batches.emplace_back();
        loaded_.planePairs.emplace_back();
        gpu_->batches.emplace_back();
        taken_.push_back(false);
        uploaded_.push_back(false);
    }
    put(at, std::move(geometry));
    this->place(at, place);
    taken_[at] = true;
    gpu_->batches[at].hidden = false;
    return static_cast<Id>(at);
}

void CasterScene::change(Id id, const MaskMesh& mesh) {
    requireKnown(id);
    const auto& groups = loaded_.scene.batches[id].geometry->groups;
    put(id, geometryOf(mesh, groups.empty() ? casting : groups.front().material));
}

void CasterScene::move(Id id, const Matrix16& worldFromObject) {
    requireKnown(id);
    place(id, placeOf(worldFromObject));
}

void CasterScene::remove(Id id) {
    requireKnown(id);
    put(id, {});
    gpu_->batches[id].hidden = true;
    taken_[id] = false;
}

void CasterScene::requireKnown(Id id) const {
    if (id >= taken_.size() || !taken_[id])
        throw InputError("There is no mesh " + std::to_string(id) + ".");
}

void CasterScene::place(std::size_t batch, const glm::dmat4& worldFromBatch) {
    loaded_.scene.batches[batch].worldFromBatch = worldFromBatch;
    gpu_->batches[batch].worldFromBatch = worldFromBatch;
    changed();
}

void CasterScene::put(std::size_t batch, Geometry geometry) {
    Stopwatch watch;
    Batch& to = loaded_.scene.batches[batch];
    to.geometry = CopyOnWrite<Geometry>(std::move(geometry));
    const std::vector<Material>& materials = loaded_.scene.materials;
    loaded_.planePairs[batch] = std::make_shared<const PlanePairShadow>(
        buildPlanePairs(to, castersOf(to, materials, false), materials, 0.0));
    uploaded_[batch] = false;
    changed();
    buildMs_ += 1e3 * watch.lap();
}

void CasterScene::changed() {
    bounds_.reset();
    layers_.clear();
    gpu_->groups.clear();
}

void CasterScene::upload() {
    for (std::size_t i = 0; i < uploaded_.size(); ++i) {
        if (uploaded_[i]) continue;
        GpuBatch& to = gpu_->batches[i];
        to.surfaces = std::make_shared<std::vector<SurfaceChunk>>(
            uploadSurfaces(loaded_.scene.batches[i], loaded_.scene.materials));
        to.volumes.planePairs = std::make_shared<PlanePairBuffers>(
            loaded_.planePairs[i], std::vector<glm::vec4>(), layout_);
        uploaded_[i] = true;
    }
}

void CasterScene::fillLayers(std::vector<FrameLight>& lights) {
    layers_.fill(loaded_.scene, false, lights);
}

const Box& CasterScene::bounds() {
    if (!bounds_) bounds_ = worldBounds(loaded_.scene);
    return *bounds_;
}

std::size_t CasterScene::bytes() const {
    std::size_t total = gpu_->shadowBytes();
    for (const GpuBatch& batch : gpu_->batches)
        if (batch.surfaces)
            for (const SurfaceChunk& chunk : *batch.surfaces)
                total += chunk.vertices.size() + chunk.indices.size();
    return total;
}

} // namespace edgeshade
