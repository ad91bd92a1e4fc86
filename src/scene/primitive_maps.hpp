#pragma once

#include "src/scene/gpu_primitive_map.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/primitive_map/primitive_map_builder.hpp"

#include <map>

namespace edgeshade {

/// A light's primitive map, or why it has none.
struct PrimitiveMapState {
    std::shared_ptr<const GpuPrimitiveMap> map; ///< null: shadows are counted by volumes
    std::string why;                            ///< a clause
    double buildMs = 0.0;                       ///< on the CPU
};

/// Primitive maps of a scene's lights, kept while lights and casters rest.
class PrimitiveMaps {
  public:
    /// Makes those that the lights have none of, and forgets other lights'. If batches have moved
    /// since, clear() comes first. `hidden`: by batch, those that cast nothing; or empty. Throws
    /// Error(unavailable) if the GL can't.
    void make(const LoadedScene& loaded, const std::vector<bool>& hidden,
              const std::vector<Light>& lights, const PrimitiveMapSettings& settings,
              const gl::Capabilities& capabilities);

    /// Null: nobody has made one yet.
    const PrimitiveMapState* of(const Light& light) const;

    void clear() { kept_.clear(); }
    std::size_t bytes() const;

  private:
    struct Kept {
        glm::dvec4 light; ///< its position
        PrimitiveMapState state;
    };

    std::vector<Kept> kept_;
    /// Of the scene's batches, whatever the light.
    std::map<std::shared_ptr<const PlanePairShadow>, std::shared_ptr<const CasterEdges>> edges_;
};

/// Why a scene's casters can't be in a primitive map; empty if they can.
std::string primitiveMapObstacle(const LoadedScene& loaded, const gl::Capabilities& capabilities);

} // namespace edgeshade
