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

/// A host's meshes as a scene that isn't from a file, each of them a batch. A batch keeps its
/// number: that of one that was removed is empty, and hidden, until the next one takes it.
class CasterScene {
  public:
    using Id = ShadowMasks::Id;

    CasterScene(SidesLayout layout, const gl::Capabilities& capabilities);

    // As in ShadowMasks. Nothing is uploaded. Throws InputError.
    Id add(const PreparedMesh& mesh, const Matrix16& worldFromObject);
    void change(Id id, const PreparedMesh& mesh);
    void setAlpha(Id id, const MaskAlpha& alpha);
    void move(Id id, const Matrix16& worldFromObject);
    void remove(Id id);

    /// Uploads a mesh ahead of add(); forgotten when nobody has the mesh any more.
    void upload(const PreparedMesh& mesh);
    /// Uploads what is not there yet; the same mesh once.
    void upload();
    /// The lights' layers, in a scene that is as the picture shows it.
    void fillLayers(std::vector<FrameLight>& lights);

    /// All that casts, where it is.
    std::vector<LookupTask::Caster> casters() const;
    /// Another number whenever what casts has changed, or where.
    std::size_t casterState() const { return casterState_; }

    const LoadedScene& loaded() const { return loaded_; }
    GpuScene& gpu() { return *gpu_; }
    const Box& bounds();
    /// On the GPU, of surfaces and records.
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
    /// A number that none has, hidden.
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
    std::optional<Box> bounds_; ///< nothing: something has moved since
};

} // namespace edgeshade
