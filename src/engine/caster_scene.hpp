#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "src/engine/lookup_work.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/view/kept_layers.hpp"

#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <vector>

namespace edgeshade {

inline glm::dmat4 matrixOf(const Matrix16& numbers) {
    return glm::make_mat4(numbers.data());
}

/// A host's meshes as a scene without a file, one batch for each mesh. A batch keeps its number:
/// the batch of a removed mesh stays, empty and hidden, until the next mesh takes it.
class CasterScene {
  public:
    using Id = ShadowMasks::Id;

    CasterScene(SidesLayout layout, const gl::Capabilities& capabilities);

    // As in ShadowMasks. Uploads nothing. Throws InputError.
    Id add(const PreparedMesh& mesh, const Matrix16& worldFromObject);
    void change(Id id, const PreparedMesh& mesh);
    void setAlpha(Id id, const MaskAlpha& alpha);
    void move(Id id, const Matrix16& worldFromObject);
    void remove(Id id);

    /// Uploads a mesh ahead of add(); dropped when nobody holds the mesh any more.
    void upload(const PreparedMesh& mesh);
    /// Uploads all meshes that are missing on the GPU, each mesh once.
    void upload();
    /// Fills in the lights' layers, for the scene in the picture's state.
    void fillLayers(std::vector<FrameLight>& lights);

    /// All casters, in their places.
    std::vector<LookupTask::Caster> casters() const;
    /// Changes whenever a caster changes or moves.
    std::size_t casterState() const { return casterState_; }

    const LoadedScene& loaded() const { return loaded_; }
    GpuScene& gpu() { return *gpu_; }
    const Box& bounds();
    const SceneTree& tree();
    /// Size on the GPU, of surfaces and records.
    std::size_t bytes() const;

  private:
    struct Buffers {
        std::shared_ptr<std::vector<SurfaceChunk>> surfaces;
        std::shared_ptr<PlanePairBuffers> volumes;
    };
    struct Ahead {
        std::weak_ptr<const PreparedMesh::Data> mesh;
        Buffers buffers;
    };

    Buffers buffersOf(const PreparedMesh::Data& mesh) const;
    void requireKnown(Id id) const;
    /// The number of an unused batch, hidden.
    std::size_t freeBatch();
    void show(std::size_t batch, const glm::dmat4& worldFromBatch);
    void place(std::size_t batch, const glm::dmat4& worldFromBatch);
    void put(std::size_t batch, const PreparedMesh& mesh);
    AlphaLookup lookupOf(const MaskAlpha& alpha) const;
    void changed();
    bool casts(std::size_t batch) const { return !loaded_.planePairs[batch]->caps.empty(); }

    SidesLayout layout_;
    LoadedScene loaded_;
    std::vector<std::shared_ptr<const PreparedMesh::Data>> meshes_; ///< by batch
    std::optional<GpuScene> gpu_;
    std::map<const PlanePairShadow*, Ahead> ahead_;
    std::vector<bool> taken_, uploaded_; ///< by batch
    std::size_t casterState_ = 0;
    KeptLayers layers_;
    // Empty, or out of date: something has moved since they were computed.
    std::optional<Box> bounds_;
    SceneTree tree_;
    bool treeIsCurrent_ = false;
};

} // namespace edgeshade
