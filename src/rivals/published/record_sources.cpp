#include "src/rivals/published/record_sources.hpp"

#include "src/rivals/published/shadow_buffers.hpp"
#include "src/scene/layered_shadow.hpp"
#include "src/scene/load.hpp"

namespace edgeshade {
namespace {

using Made = std::shared_ptr<RecordBuffers>;

/// Makes each geometry's records once. `make` takes the index of a batch.
template <class Make>
std::vector<Made> byGeometry(const Scene& scene, Make make) {
    const std::vector<std::size_t> first = firstOfGeometry(scene.batches);
    std::vector<Made> made;
    for (std::size_t i = 0; i < first.size(); ++i)
        made.push_back(first[i] != i ? made[first[i]] : make(i));
    return made;
}

std::vector<glm::vec4> cornersOf(const Batch& batch, const Casters& casters, const CasterMesh& mesh,
                                 bool alphaTested) {
    return alphaTested ? alphaCorners(batch, casters, mesh) : std::vector<glm::vec4>();
}

Made uploaded(const LoadedScene& loaded, const Batch& batch, const BatchShadow& shadow,
              SidesLayout layout) {
    std::vector<glm::vec4> corners;
    if (loaded.settings.castMasked) {
        const Casters casters = castersOf(batch, loaded.scene.materials, true);
        corners = alphaCorners(batch, casters, weldCasters(batch, casters));
    }
    return std::make_shared<ShadowBuffers>(uploadShadow(shadow, corners, layout));
}

} // namespace

std::vector<Made> OppositeVertexSource::ofScene(const LoadedScene& loaded,
                                                SidesLayout layout) const {
    const Shadows shadows = loaded.shadows.empty()
                                ? buildShadows(loaded.scene, loaded.settings.castMasked)
                                : loaded.shadows;
    return byGeometry(loaded.scene, [&](std::size_t batch) {
        return uploaded(loaded, loaded.scene.batches[batch], *shadows[batch], layout);
    });
}

Made OppositeVertexSource::ofBatch(const LoadedScene& loaded, const Batch& batch,
                                   SidesLayout layout) const {
    const BatchShadow shadow =
        buildShadow(batch, loaded.scene.materials, loaded.settings.castMasked);
    return uploaded(loaded, batch, shadow, layout);
}

Made OppositeVertexSource::ofGroup(const Batch& batch, const GroupTopology& topology,
                                   bool alphaTested, std::uint32_t largestOppositeCount,
                                   SidesLayout layout) const {
    const auto& [casters, mesh, edges] = topology;
    const BatchShadow shadow{
        buildSides(mesh.welded.positions, edges, recordMultiplicityFor(largestOppositeCount)),
        buildCaps(mesh.welded), mesh.groups};
    return std::make_shared<ShadowBuffers>(
        uploadShadow(shadow, cornersOf(batch, casters, mesh, alphaTested), layout));
}

std::vector<Made> TriangleSource::ofScene(const LoadedScene& loaded, SidesLayout layout) const {
    return byGeometry(loaded.scene, [&](std::size_t batch) {
        return ofBatch(loaded, loaded.scene.batches[batch], layout);
    });
}

Made TriangleSource::ofBatch(const LoadedScene& loaded, const Batch& batch,
                             SidesLayout layout) const {
    const bool alphaTested = loaded.settings.castMasked;
    const Casters casters = castersOf(batch, loaded.scene.materials, alphaTested);
    const CasterMesh mesh = weldCasters(batch, casters);
    return std::make_shared<ShadowBuffers>(
        uploadTriangles(mesh, cornersOf(batch, casters, mesh, alphaTested), layout));
}

Made TriangleSource::ofGroup(const Batch& batch, const GroupTopology& topology, bool alphaTested,
                             std::uint32_t, SidesLayout layout) const {
    const CasterMesh& mesh = topology.mesh;
    return std::make_shared<ShadowBuffers>(
        uploadTriangles(mesh, cornersOf(batch, topology.casters, mesh, alphaTested), layout));
}

} // namespace edgeshade
