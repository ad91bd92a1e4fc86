#pragma once

#include "edgeshade/light_lookup.hpp"
#include "src/engine/prepared_mesh.hpp"
#include "src/scene/fitting_map.hpp"
#include "src/scene/packed_primitive_map.hpp"

#include <map>

namespace edgeshade {

/// A caster in a light's map.
struct HeldCaster {
    std::size_t batch = 0;
    std::size_t version = 0; ///< unique to its shape and place
};

/// Input for building a light's map.
struct LookupTask {
    /// A mesh that casts what its alpha leaves, or tints the light.
    struct Cutout {
        std::shared_ptr<const PreparedMesh::Data> mesh; ///< only its geometry counts
        MaskAlpha alpha; ///< with a tint: its texture, a MaskTintTexture
        std::optional<std::array<float, 3>> tint;
    };
    struct Caster {
        /// Its caps are the casting triangles. Null: `cutout` casts instead.
        std::shared_ptr<const PlanePairShadow> shadow;
        Cutout cutout{};
        glm::dmat4 worldFromBatch{1.0};
    };
    Light light;
    LookupSettings settings;
    std::vector<Caster> casters;
    std::string why; ///< why there can be no map, a clause; else empty
    /// Everything that a light with a radius shines on, in the world.
    Box receivers{};
};

/// Result of building a light's map.
struct BuiltLookup {
    std::string why; ///< why there is no map, a clause; else empty
    PackedPrimitiveMap map;
    double milliseconds = 0.0; ///< time spent building
};

struct LookupWork::Data {
    /// Returns whether more remains to do.
    bool step();
    /// The edges of a caster, found once for all that share them.
    std::shared_ptr<const CasterEdges> edgesOf(const LookupTask::Caster& caster);
    /// The number of a cutout's look in `looks`.
    std::size_t lookOf(const LookupTask::Cutout& cutout);

    /// How cutouts look that may be of several meshes.
    struct Look {
        MaskAlpha alpha;
        std::optional<std::array<float, 3>> tint;
        std::uint32_t texture; ///< its number in `textures`
    };

    LookupTask task;
    std::vector<HeldCaster> held; ///< the task's casters
    BuiltLookup built;
    bool done = false, taken = false;

    /// Edges by mesh, and by the number of its look; solid meshes have none.
    std::map<std::pair<const void*, std::size_t>, std::shared_ptr<const CasterEdges>> edges = {};
    std::vector<Look> looks = {};
    CutoutTextures textures = {};
    std::vector<PlacedCasters> placed = {};
    std::optional<FittingMap> fitting = {};
};

/// Work on a task, not yet started.
LookupWork workOn(LookupTask task, std::vector<HeldCaster> held);

} // namespace edgeshade
