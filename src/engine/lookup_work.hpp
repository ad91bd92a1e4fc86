#pragma once

#include "edgeshade/light_lookup.hpp"
#include "src/engine/prepared_mesh.hpp"
#include "src/scene/fitting_map.hpp"
#include "src/scene/packed_primitive_map.hpp"

#include <map>
#include <tuple>

namespace edgeshade {

/// Input for building a light's map.
struct LookupTask {
    /// A mesh that casts what its alpha leaves, or tints the light.
    struct Cutout {
        std::shared_ptr<const PreparedMesh::Data> mesh; ///< only its geometry counts
        MaskAlpha alpha;
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
    std::shared_ptr<const CasterEdges> edgesOf(const LookupTask::Cutout& cutout);
    /// The number of a cutout's texture, or tint, in `textures`.
    std::uint32_t textureFor(const LookupTask::Cutout& cutout);

    LookupTask task;
    std::size_t casterState = 0; ///< state of the casters when `task` was recorded
    BuiltLookup built;
    bool done = false, taken = false;

    std::map<const PlanePairShadow*, std::shared_ptr<const CasterEdges>> edges = {};
    /// Cutouts by mesh, texture, and the numbers of their alpha, which casters may share.
    std::map<std::tuple<const PreparedMesh::Data*, std::uint32_t, std::array<float, 10>>,
             std::shared_ptr<const CasterEdges>>
        cutoutEdges = {};
    std::map<std::pair<const MaskTexels*, float>, std::uint32_t> textureOf = {};
    std::map<std::array<float, 3>, std::uint32_t> tintOf = {};
    CutoutTextures textures = {}; ///< by the numbers of `textureOf`
    std::vector<PlacedCasters> placed = {};
    std::optional<FittingMap> fitting = {};
};

/// Work on a task, not yet started.
LookupWork workOn(LookupTask task, std::size_t casterState);

} // namespace edgeshade
