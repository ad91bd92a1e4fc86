#pragma once

#include "preprocess/base/shared_pool.hpp"
#include "preprocess/scene/scene.hpp"
#include "preprocess/section/component_blocks.hpp"
#include "preprocess/section/cut_origins.hpp"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace edgeshade {

/// Cuts a scene by sections, again and again. It keeps the scene as it was, and which of its
/// triangles bound solids.
class SceneCutter {
  public:
    /// `castMasked` as in CasterSettings. `whole` has no section.
    SceneCutter(Scene whole, bool castMasked, KnownTopologies topologies = {});

    /// The scene as cut, with the same batches and lights. After its materials come the fill's and,
    /// where shadows are whole, one for the part of each that is cut away. Batches that no plane
    /// crosses share their geometry with the scene before; those that a section changes no longer
    /// deform. The ground isn't cut. Surfaces are visible from both sides.
    ///
    /// Cut faces of solids, that is of closed and opaque components, are filled. Where shadows are
    /// cut too, the fill casts, and solids are closed again (docs/method.md, C50).
    Scene cut(const Section& section);

    const Scene& whole() const { return *whole_; }

    /// Gives away the topology of all triangles of a geometry of the whole scene, which cuts need
    /// only once; empty if it isn't known.
    std::optional<MeshTopology> takeTopology(const Geometry& geometry);

  private:
    struct Cutting;

    struct Known {
        Box bounds;
        std::vector<std::uint8_t> solid;           ///< by triangle; empty until a plane meets one
        std::optional<MeshTopology> topology;      ///< of all triangles, until it is taken
        std::optional<CopyOnWrite<Geometry>> away; ///< all of it cut away, and casting as a whole
        SharedPool<Geometry> made;                 ///< cuts of it
        SharedPool<CutOrigins> origins;            ///< of these cuts
    };

    Known& knownOf(const Geometry& geometry);
    void addMaterials(const Section& section, std::vector<Material>& materials) const;
    void cutBatch(Batch& batch, const Cutting& cutting);

    std::shared_ptr<const Scene> whole_;
    bool castMasked_;
    CopyOnWrite<Geometry> nothing_;          ///< of batches that are cut away and cast nothing
    std::map<const Geometry*, Known> known_; ///< of the whole scene
};

} // namespace edgeshade
