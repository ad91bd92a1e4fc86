#pragma once

#include "edgeshade/light_lookup.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/scene/fitting_map.hpp"
#include "src/scene/packed_primitive_map.hpp"

#include <map>

namespace edgeshade {

/// Input for building a light's map.
struct LookupTask {
    struct Caster {
        std::shared_ptr<const PlanePairShadow> shadow; ///< its caps are the casting triangles
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

    LookupTask task;
    std::size_t casterState = 0; ///< state of the casters when `task` was recorded
    BuiltLookup built;
    bool done = false, taken = false;

    std::map<const PlanePairShadow*, std::shared_ptr<const CasterEdges>> edges = {};
    std::vector<PlacedCasters> placed = {};
    std::optional<FittingMap> fitting = {};
};

/// Work on a task, not yet started.
LookupWork workOn(LookupTask task, std::size_t casterState);

} // namespace edgeshade
