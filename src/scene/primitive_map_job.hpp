#pragma once

#include "src/scene/cutout_atlas.hpp"
#include "src/scene/gpu_primitive_map.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/primitive_map/primitive_map_builder.hpp"

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

/// What a light's primitive map takes of the CPU: the map, and which side of the surfaces'
/// triangles the light is on. Where there are threads it is worked at beside everything else, else
/// part by part.
class PrimitiveMapJob {
  public:
    /// The scene's batches and materials must stay as they are, but for where animated ones are,
    /// until the job is gone. Those cast by volumes. `settings.cutouts`: empty where MASK surfaces
    /// cast nothing.
    PrimitiveMapJob(const LoadedScene& loaded, const Light& light,
                    const PrimitiveMapSettings& settings, KeptEdges edges);
    ~PrimitiveMapJob() { cancel(); }
    PrimitiveMapJob(const PrimitiveMapJob&) = delete;
    PrimitiveMapJob& operator=(const PrimitiveMapJob&) = delete;

    /// Has a thread work at it; nothing where there are none.
    void start();
    /// Goes on for about so long where there are no threads; returns whether all is done.
    bool advance(double milliseconds);
    /// Does all of it, on as many threads as there are cores.
    void finish();

    const glm::dvec4& light() const { return light_.position; }
    /// Once all is done: nothing if it would take more memory or time than it may, or the light is
    /// too far off.
    const std::optional<PrimitiveMap>& map() const { return map_; }
    bool isTooFar() const { return tooFar_; }
    const std::vector<std::vector<SidedTriangles>>& triangles() const { return triangles_; }
    const KeptEdges& edges() const { return edges_; }
    double milliseconds() const { return milliseconds_; } ///< that were worked

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
    PrimitiveMapSettings settings_;
    const std::vector<Material>* materials_;
    int smallest_; ///< size that is tried
    std::vector<Placed> placed_;
    KeptEdges edges_;
    std::vector<PlacedCasters> solid_, cutouts_;
    std::unique_ptr<PrimitiveMapBuilder> builder_;
    std::size_t nextPart_ = 0;
    bool joined_ = false;
    bool tooFar_ = false;
    std::optional<PrimitiveMap> map_;
    std::vector<std::vector<SidedTriangles>> triangles_;
    double milliseconds_ = 0.0;
    std::atomic<bool> done_ = false;
#ifndef __EMSCRIPTEN__
    std::jthread thread_; ///< the last member: it ends before the others
#endif
};

} // namespace edgeshade
