#pragma once

#include "edgeshade/light_lookup.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/scene/fitting_map.hpp"
#include "src/scene/packed_primitive_map.hpp"

#include <map>

namespace edgeshade {

/// What a light's map is made of.
struct LookupTask {
    struct Caster {
        std::shared_ptr<const PlanePairShadow> shadow; ///< its caps are asked
        glm::dmat4 worldFromBatch{1.0};
    };
    Light light;
    LookupSettings settings;
    std::vector<Caster> casters;
    std::string why; ///< there can be none, a clause
};

/// What came of it.
struct BuiltLookup {
    std::string why; ///< there is none, a clause
    PackedPrimitiveMap map;
    double milliseconds = 0.0; ///< that were worked
};

struct LookupWork::Data {
    /// Returns whether there is more to do.
    bool step();

    LookupTask task;
    std::size_t casterState = 0; ///< of the casters, when they were taken down
    BuiltLookup built;
    bool done = false, taken = false;

    std::map<const PlanePairShadow*, std::shared_ptr<const CasterEdges>> edges = {};
    std::vector<PlacedCasters> placed = {};
    std::optional<FittingMap> fitting = {};
};

/// Of nothing that was taken down yet.
LookupWork workOn(LookupTask task, std::size_t casterState);

} // namespace edgeshade
