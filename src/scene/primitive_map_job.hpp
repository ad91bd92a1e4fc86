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

/// Edges of casters, which don't depend on the light.
using KeptEdges =
    std::map<std::shared_ptr<const PlanePairShadow>, std::shared_ptr<const CasterEdges>>;

/// Parameters of a primitive map, besides the scene.
struct PrimitiveMapTask {
    Light light;
    /// Casters are receivers too; false: only see-through surfaces are, which cast nothing.
    bool castersReceive = true;
    PrimitiveMapSettings settings; ///< `mostBytes`: for everything that is built; `cutouts`: empty
                                   ///< if MASK surfaces cast nothing
    /// The section that cuts the scene. A worker that knows the whole scene cuts it first.
    std::optional<Section> section = {};
};

/// Result of a task.
struct BuiltPrimitiveMap {
    Light light;
    std::size_t mostBytes = 0; ///< its memory limit
    /// Null if it would take more memory or time than allowed, or the light is too far away.
    std::optional<PrimitiveMap> map;
    bool tooFar = false;
    std::size_t tooLong = 0;                            ///< FittingMap::tooLong()
    std::vector<std::vector<SidedTriangles>> triangles; ///< by batch, by chunk; or empty
    double milliseconds = 0.0;                          ///< time spent
};

/// The CPU work for a light's primitive map: the map, and the side of the light for every surface
/// triangle. A thread does it in the background, or, without threads, the caller does it in parts.
class PrimitiveMapJob {
  public:
    /// Until the job is destroyed, the scene's batches and materials must not change, except for
    /// the transforms of animated batches. Animated batches cast by volumes.
    PrimitiveMapJob(const LoadedScene& loaded, const PrimitiveMapTask& task, KeptEdges edges);
    ~PrimitiveMapJob() { cancel(); }
    PrimitiveMapJob(const PrimitiveMapJob&) = delete;
    PrimitiveMapJob& operator=(const PrimitiveMapJob&) = delete;

    /// Starts a thread for it; does nothing without threads.
    void start();
    /// Without threads, works for about `milliseconds`. Returns whether all is done.
    bool advance(double milliseconds);
    /// Does all of the work, on as many threads as there are cores.
    void finish();

    const Light& light() const { return light_; }
    /// Valid once all is done.
    const BuiltPrimitiveMap& built() const { return built_; }
    const KeptEdges& edges() const { return edges_; }

  private:
    /// Returns whether work remains.
    bool step();
    void cancel();
    /// Has the map list nothing for others than see-through surfaces, unless any of these moves.
    void restrictToSeeThrough();

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
    std::vector<WorldTriangle> seeThrough_;
    std::optional<FittingMap> fitting_;
    BuiltPrimitiveMap built_;
    std::atomic<bool> done_ = false;
#ifndef __EMSCRIPTEN__
    std::jthread thread_; ///< last member, so that it ends before the others
#endif
};

} // namespace edgeshade
