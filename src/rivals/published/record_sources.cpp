#include "src/rivals/published/record_sources.hpp"

#include "src/rivals/published/shadow_buffers.hpp"
#include "src/scene/layered_shadow.hpp"
#include "src/scene/load.hpp"

namespace edgeshade {
namespace {

using Made = std::shared_ptr<RecordBuffers>;

std::vector<glm::vec4> cornersOf(const Batch& batch, const Casters& casters, const CasterMesh& mesh,
                                 bool alphaTested) {
    return alphaTested ? alphaCorners(batch, casters, mesh) : std::vector<glm::vec4>();
}

class OppositeVertexSource : public RecordSource {
  public:
    VolumeLayout layout() const override { return VolumeLayout::oppositeVertices; }

    std::vector<Made> ofScene(const LoadedScene& loaded, SidesLayout layout) const override {
        const Shadows shadows = loaded.shadows.empty()
                                    ? buildShadows(loaded.scene, loaded.settings.castMasked)
                                    : loaded.shadows;
        return byGeometry(loaded.scene.batches, [&](std::size_t batch) {
            return uploaded(loaded, loaded.scene.batches[batch], *shadows[batch], layout);
        });
    }

    Made ofBatch(const LoadedScene& loaded, const Batch& batch, SidesLayout layout) const override {
        return uploaded(loaded, batch,
                        buildShadow(batch, loaded.scene.materials, loaded.settings.castMasked),
                        layout);
    }

    Made ofGroup(const Batch& batch, const GroupTopology& topology, bool alphaTested,
                 std::uint32_t largestOppositeCount, SidesLayout layout) const override {
        const auto& [casters, mesh, edges] = topology;
        const BatchShadow shadow{
            buildSides(mesh.welded.positions, edges, recordMultiplicityFor(largestOppositeCount)),
            buildCaps(mesh.welded), mesh.groups};
        return std::make_shared<ShadowBuffers>(
            uploadShadow(shadow, cornersOf(batch, casters, mesh, alphaTested), layout));
    }

  private:
    static Made uploaded(const LoadedScene& loaded, const Batch& batch, const BatchShadow& shadow,
                         SidesLayout layout) {
        std::vector<glm::vec4> corners;
        if (loaded.mayHaveHoles()) {
            const Casters casters =
                castersOf(batch, loaded.scene.materials, loaded.settings.castMasked);
            corners = alphaCorners(batch, casters, weldCasters(batch, casters));
        }
        return std::make_shared<ShadowBuffers>(uploadShadow(shadow, corners, layout));
    }
};

class TriangleSource : public RecordSource {
  public:
    VolumeLayout layout() const override { return VolumeLayout::triangles; }

    std::vector<Made> ofScene(const LoadedScene& loaded, SidesLayout layout) const override {
        return byGeometry(loaded.scene.batches, [&](std::size_t batch) {
            return ofBatch(loaded, loaded.scene.batches[batch], layout);
        });
    }

    Made ofBatch(const LoadedScene& loaded, const Batch& batch, SidesLayout layout) const override {
        const Casters casters =
            castersOf(batch, loaded.scene.materials, loaded.settings.castMasked);
        return uploaded(batch, casters, weldCasters(batch, casters), loaded.mayHaveHoles(), layout);
    }

    Made ofGroup(const Batch& batch, const GroupTopology& topology, bool alphaTested, std::uint32_t,
                 SidesLayout layout) const override {
        return uploaded(batch, topology.casters, topology.mesh, alphaTested, layout);
    }

  private:
    static Made uploaded(const Batch& batch, const Casters& casters, const CasterMesh& mesh,
                         bool alphaTested, SidesLayout layout) {
        return std::make_shared<ShadowBuffers>(
            uploadTriangles(mesh, cornersOf(batch, casters, mesh, alphaTested), layout));
    }
};

} // namespace

std::unique_ptr<RecordSource> oppositeVertexSource() {
    return std::make_unique<OppositeVertexSource>();
}

std::unique_ptr<RecordSource> triangleSource() {
    return std::make_unique<TriangleSource>();
}

} // namespace edgeshade
