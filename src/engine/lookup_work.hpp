#pragma once

#include "edgeshade/light_lookup.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"
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
    std::vector<HeldCaster> held; ///< the task's casters
    BuiltLookup built;
    bool done = false, taken = false;

    std::map<const PlanePairShadow*, std::shared_ptr<const CasterEdges>> edges = {};
    std::vector<PlacedCasters> placed = {};
    std::optional<FittingMap> fitting = {};
};

/// Work on a task, not yet started.
LookupWork workOn(LookupTask task, std::vector<HeldCaster> held);

} // namespace edgeshade
