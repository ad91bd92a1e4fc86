#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "src/engine/caster_rest.hpp"
#include "src/engine/lookup_work.hpp"
#include "src/engine/merged_meshes.hpp"
#include "src/engine/mesh_clip.hpp"
#include "src/engine/mesh_place.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/layers/layer_search.hpp"
#include "src/shadow/view/kept_layers.hpp"

#include <map>
#include <optional>
#include <vector>

namespace edgeshade {

/// A host's meshes as a scene without a file, one batch for each mesh. A batch keeps its number:
/// the batch of a removed mesh stays, empty and hidden, until the next mesh takes it.
///
/// Small meshes that rest are merged (mesh_merging.hpp). A merged mesh has a batch of its own, and
/// the batches of its members are empty and hidden until one of the members changes.
class CasterScene {
  public:
    using Id = ShadowMasks::Id;

    CasterScene(SidesLayout layout, const gl::Capabilities& capabilities);

    // As in ShadowMasks. Uploads nothing. Throws InputError.
    Id add(const PreparedMesh& mesh, const Matrix16& worldFromObject);
    std::vector<Id> add(const MergedMeshes& meshes);
    void change(Id id, const PreparedMesh& mesh);
    void setAlpha(Id id, const MaskAlpha& alpha);
    void setTint(Id id, const std::optional<std::array<float, 3>>& tint,
                 const MaskTintTexture& texture);
    void move(Id id, const Matrix16& worldFromObject);
    void setClippings(Id id, std::span<const MaskClipping> clippings);
    void remove(Id id);

    /// Called before each draw(): merges some meshes that have rested for a while, if there are
    /// enough. Makes at most one merged mesh a call, so that no frame waits long.
    void mergeResting();

    /// Uploads a mesh ahead of add(), makes the tree of its triangles, and prepares its records for
    /// fillLayers(), one step a call. Returns whether all is there; it is dropped when nobody holds
    /// the mesh any more.
    bool uploadStep(const PreparedMesh& mesh);
    /// Uploads all meshes that are missing on the GPU, each mesh once. Returns whether any were.
    bool upload();
    /// Takes a step of what tree(), upload() and bounds() take. Returns whether any was left.
    bool prepareStep();
    /// Fills in the layers of the view's lights, except those that count movers alone. Returns
    /// whether any weren't known yet.
    bool fillLayers(FrameView& view);

    bool hasCasters() const;
    /// Casters for a light's map, in their places.
    struct Casters {
        std::vector<LookupTask::Caster> casters;
        std::vector<HeldCaster> held; ///< the same ones
    };
    /// All casters except movers: those that have moved, and have rested less than `restMs`. Meshes
    /// that are cut out or tinted otherwise cast as in masks.
    Casters resting(double restMs, LookupCasters of) const;
    /// Those that masks can't draw: meshes that are cut out or tinted, moving ones too.
    Casters cutouts(LookupCasters of) const;
    /// Compares the casters in a map with the present ones, as in ShadowMasks::state().
    LookupState compare(std::span<const HeldCaster> held, double restMs) const;
    /// Changes whenever a caster changes or moves.
    std::size_t casterState() const { return casterState_; }
    /// As in ShadowMasks.
    std::size_t restingState() const { return restingState_; }

    /// Casters that a light's map doesn't hold.
    struct Movers {
        std::vector<char> counted; ///< by batch, whether it is one, or has one among its members
        Box bounds;                ///< in the world
    };
    /// All that are held must be casters.
    Movers moversOver(std::span<const HeldCaster> held) const;
    /// Fills in the layers of one of the view's lights that counts movers alone. Returns whether
    /// they weren't known yet.
    bool fillLayers(FrameView& view, std::size_t light, const Movers& movers);
    /// Takes a step of what fillLayers() takes for one of the view's lights; `movers`: that it
    /// counts alone, if any. Returns whether no step is left but that call.
    bool lookAhead(const FrameView& view, std::size_t light, const std::optional<Movers>& movers);
    /// Makes these the animated batches.
    void animate(const Movers& movers);

    const LoadedScene& loaded() const { return loaded_; }
    GpuScene& gpu() { return *gpu_; }
    const Box& bounds();
    const SceneTree& tree();
    /// Number of batches that have triangles: single and merged meshes.
    std::size_t drawnBatches() const;
    /// Size on the GPU, of surfaces and records.
    std::size_t bytes() const;

  private:
    /// Parts of a mesh that uploadStep() has made so far, in this order.
    struct Ahead {
        std::weak_ptr<const PreparedMesh::Data> mesh{};
        std::shared_ptr<std::vector<SurfaceChunk>> surfaces{};
        std::shared_ptr<PlanePairBuffers> volumes{};
        std::optional<CopyOnWrite<TriangleTree>> triangles{};
    };

    struct Slot {
        enum class Use { free, mesh, merged };
        Use use = Use::free;
        bool uploaded = false;
        /// As it was added, clipped as a caster, and clipped as a surface; the same mesh if no
        /// plane crosses it. A merged mesh has only the last.
        std::shared_ptr<const PreparedMesh::Data> whole, caster, mesh;
        std::vector<MeshClip> clips; ///< those that cut casters come first
        MaskAlpha alpha;
        std::optional<std::array<float, 3>> tint;
        MaskTintTexture tintTexture;
        CasterRest rest{};                       ///< as a caster
        Box own;                                 ///< of the whole mesh, in its space
        mutable std::optional<Box> ownInWorld{}; ///< the same in the world; empty: out of date
        std::optional<Box> inWorld{};            ///< of the batch's vertices; empty: out of date
        std::size_t changed = 0;                 ///< the draw() before which it last changed
        std::size_t patience = shortRest;        ///< draws that it has to rest before it is merged
        std::optional<std::size_t> mergedInto{}; ///< the batch that draws it
        std::vector<std::size_t> members{};      ///< of a merged mesh

        bool cutsOut() const { return caster && caster->alphaTested && alpha.cutsOut; }
        bool casts() const {
            return caster && (tint || cutsOut() || !caster->shadow->caps.empty());
        }
        bool isClipped() const { return mesh != whole; }
    };
    /// Layers of a light that counts movers alone, and which these were.
    struct MoverLayers {
        KeptLayers layers;
        std::vector<char> counted{};
    };
    static constexpr std::size_t shortRest = 30, longRest = 3000;     // draws
    static constexpr std::size_t mostMerged = std::size_t{1} << 20;   // triangles
    static constexpr std::size_t mostMeasured = std::size_t{1} << 16; // vertices

    std::shared_ptr<std::vector<SurfaceChunk>> surfacesOf(const PreparedMesh::Data& mesh) const;
    std::shared_ptr<PlanePairBuffers> volumesOf(const PreparedMesh::Data& mesh) const;
    void requireKnown(Id id) const;
    /// The number of an unused batch, hidden.
    std::size_t freeBatch();
    /// Takes in a new mesh, which is at rest. Returns its batch.
    std::size_t insert(const PreparedMesh& mesh, const glm::dmat4& worldFromBatch);
    void place(std::size_t batch, const glm::dmat4& worldFromBatch);
    void put(std::size_t batch, const PreparedMesh& mesh);
    /// Clips a mesh again. Returns whether the batch has to draw another one.
    bool clip(std::size_t batch);
    /// Makes the batch draw a mesh; null: nothing.
    void show(std::size_t batch, const std::shared_ptr<const PreparedMesh::Data>& mesh);
    /// Leaves a batch, empty and hidden, to the next mesh.
    void release(std::size_t batch);
    /// Notes that a mesh changes: it is split off, and takes longer to be merged again.
    void disturb(std::size_t batch);
    void dissolve(std::size_t merged);
    std::vector<MergeCandidate> candidates() const;
    void makeMerged(const std::vector<std::size_t>& members);
    /// Draws a merged mesh in place of its members.
    void showMerged(const std::vector<std::size_t>& members, const MergedMesh& merged);
    AlphaLookup lookupOf(const MaskAlpha& alpha) const;
    /// Layers of a light that counts movers alone.
    KeptLayers& layersOf(std::size_t light, const Movers& movers);
    /// By batch.
    std::vector<std::shared_ptr<const PlanePairShadow>> recordsOf(const Movers& movers) const;
    void changed();
    /// Notes that a caster comes, goes or changes: maps of it end. `moves`: it is a mover for a
    /// while, which the next maps don't hold.
    void casterChanged(std::size_t batch, bool moves = true);
    const Box& worldBox(std::size_t batch) const;
    /// A box around the batch's vertices in the world.
    const Box& drawnBox(std::size_t batch);
    bool isCaster(std::size_t batch) const {
        return slots_[batch].use == Slot::Use::mesh && slots_[batch].casts();
    }

    SidesLayout layout_;
    LoadedScene loaded_;
    std::vector<Slot> slots_;   ///< by batch
    std::size_t firstFree_ = 0; ///< no batch before it is free
    const PreparedMesh nothing_{MaskMesh{}};
    std::optional<GpuScene> gpu_;
    std::map<const PlanePairShadow*, Ahead> ahead_;
    std::size_t draws_ = 0,
                mergedTriangles_ = 0; ///< calls of mergeResting(); triangles of merged meshes
    std::size_t casterState_ = 0, restingState_ = 0;
    std::shared_ptr<KeptChains> chains_ = std::make_shared<KeptChains>();
    KeptLayers layers_{chains_};
    std::vector<MoverLayers> moverLayers_; ///< by light
    // Empty, or out of date: something has moved since they were computed.
    std::optional<Box> bounds_;
    SceneTree tree_;
    bool treeIsCurrent_ = false;
};

} // namespace edgeshade
