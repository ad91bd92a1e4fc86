#pragma once

#include "src/scene/cutout_atlas.hpp"
#include "src/scene/fitting_map.hpp"
#include "src/scene/gpu_primitive_map.hpp"
#include "src/scene/load.hpp"

#include <atomic>
#include <functional>
#include <map>
#ifndef __EMSCRIPTEN__
#include <thread>
#endif

namespace edgeshade {

/// Edges of casters, whatever the light.
using KeptEdges =
    std::map<std::shared_ptr<const PlanePairShadow>, std::shared_ptr<const CasterEdges>>;

/// What a primitive map is made from, beside the scene.
struct PrimitiveMapTask {
    Light light;
    /// What casts is looked up, too; false: only what is see-through, which casts nothing.
    bool castersReceive = true;
    PrimitiveMapSettings settings; ///< `mostBytes`: of all that is built; `cutouts`: empty where
                                   ///< MASK surfaces cast nothing
};

/// What came of it.
struct BuiltPrimitiveMap {
    Light light;
    std::size_t mostBytes = 0; ///< what it might take
    /// Nothing if it would take more memory or time than it may, or the light is too far off.
    std::optional<PrimitiveMap> map;
    bool tooFar = false;
    std::size_t tooLong = 0;                            ///< FittingMap::tooLong()
    std::vector<std::vector<SidedTriangles>> triangles; ///< by batch, by chunk, or none
    double milliseconds = 0.0;                          ///< that were worked
};

/// What a light's primitive map takes of the CPU: the map, and which side of the surfaces'
/// triangles the light is on. Where there are threads it is worked at beside everything else, else
/// part by part.
class PrimitiveMapJob {
  public:
    /// The scene's batches and materials must stay as they are, but for where animated ones are,
    /// until the job is gone. Those cast by volumes.
    PrimitiveMapJob(const LoadedScene& loaded, const PrimitiveMapTask& task, KeptEdges edges);
    ~PrimitiveMapJob() { cancel(); }
    PrimitiveMapJob(const PrimitiveMapJob&) = delete;
    PrimitiveMapJob& operator=(const PrimitiveMapJob&) = delete;

    /// Has a thread work at it; nothing where there are none.
    void start();
    /// Goes on for about so long where there are no threads; returns whether all is done.
    bool advance(double milliseconds);
    /// Does all of it, on as many threads as there are cores.
    void finish();

    const Light& light() const { return light_; }
    /// Once all is done.
    const BuiltPrimitiveMap& built() const { return built_; }
    const KeptEdges& edges() const { return edges_; }

  private:
    /// Returns whether there is more to do.
    bool step();
    void cancel();

    struct Placed {
        const Batch* batch;
        std::shared_ptr<const PlanePairShadow> shadow;
        glm::dmat4 worldFromBatch;
        bool animated;
    };
    Light light_;
    bool castersReceive_;
    PrimitiveMapSettings settings_;
    const std::vector<Material>* materials_;
    std::vector<Placed> placed_;
    KeptEdges edges_;
    std::vector<PlacedCasters> solid_, cutouts_;
    std::optional<FittingMap> fitting_;
    BuiltPrimitiveMap built_;
    std::atomic<bool> done_ = false;
#ifndef __EMSCRIPTEN__
    std::jthread thread_; ///< the last member: it ends before the others
#endif
};

} // namespace edgeshade
