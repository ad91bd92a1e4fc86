#pragma once

#include "preprocess/mesh/mesh_statistics.hpp"
#include "preprocess/mesh/topology.hpp"
#include "preprocess/scene/instance_choice.hpp"
#include "preprocess/scene/scene.hpp"
#include "preprocess/volumes/published/caps_data.hpp"
#include "preprocess/volumes/published/sides_data.hpp"

#include <memory>
#include <vector>

namespace edgeshade {

/// Upper limit of a flat tolerance, exclusive, in degrees.
inline constexpr double flatToleranceEnd = 45.0;

/// The casters that a scene's shadow data hold, and how the data are made.
struct CasterSettings {
    double weldTolerance = 0.0; ///< scene units
    bool castMasked = false;    ///< MASK and BLEND surfaces cast too
    double casterError = 0.0;   ///< scene units, see simplifyCasters()
    double flatTolerance = 0.0; ///< degrees, see growPatches(); for plane-pair records only
    InstanceChoice instances = InstanceChoice::automatic;
    bool autoWeld = false; ///< settingsFor() has still to choose weldTolerance

    bool operator==(const CasterSettings&) const = default;
};

/// Sides-data and caps-data of one batch.
struct BatchShadow {
    SidesData sides;
    CapsData caps;
    std::vector<MaterialCasters> groups; ///< ranges of caps
};

/// Seconds taken by each stage.
struct BuildSeconds {
    double weldChoice = 0.0; ///< choosing the weld tolerance
    double simplify = 0.0;
    double weld = 0.0;
    double edges = 0.0;
    double records = 0.0; ///< planes, and counting their records
    double pack = 0.0;
};

/// Topology of one batch, kept for the encodings that store it.
struct BatchTopology {
    CasterMesh mesh;
    EdgeList edges;
    std::uint64_t hash = 0; ///< positionsHash()
};

/// One per batch; batches with the same geometry share one.
using Topologies = std::vector<std::shared_ptr<const BatchTopology>>;
using Shadows = std::vector<std::shared_ptr<const BatchShadow>>;

/// Topology of every batch of the scene, in order.
Topologies buildTopology(const Scene& scene, bool castMasked, BuildSeconds& seconds,
                         Threads threads = {});

/// The multiplicity of all records: `published` has a single maxMult for the scene.
int sceneMultiplicity(const Topologies& topology);

/// Sides and caps of one batch.
BatchShadow buildShadow(const BatchTopology& topology, int maxMultiplicity);

/// All steps for one batch, with its own multiplicity.
BatchShadow buildShadow(const Batch& batch, const std::vector<Material>& materials,
                        bool castMasked);

/// All steps for every batch: weld, edges, sides and caps.
Shadows buildShadows(const Scene& scene, bool castMasked);

} // namespace edgeshade
