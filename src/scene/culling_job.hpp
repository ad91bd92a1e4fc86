#pragma once

#include "src/scene/load.hpp"
#include "src/scene/primitive_map_job.hpp"

#include <atomic>
#ifndef __EMSCRIPTEN__
#include <thread>
#endif

namespace edgeshade {

/// What is left of a light's casters without those that are wholly in the shadow of others
/// (docs/method.md, C43).
struct KeptCasters {
    Light light;
    /// By batch, for LoadedScene::planePairs; null: nothing is left out.
    std::vector<std::shared_ptr<const PlanePairShadow>> shadows;
    std::size_t casters = 0, gone = 0; ///< triangles
    double milliseconds = 0.0;         ///< that it took
};

/// Finds them, beside everything else or at once, on as many threads as there are cores.
class CullingJob {
  public:
    /// `light`: with an extent, one that may be anywhere in it. `edges`: of other jobs. The scene's
    /// batches must stay as they are, but for where animated ones are, until the job is gone: these
    /// neither go nor hide others.
    CullingJob(const LoadedScene& loaded, const Light& light, int mantissaBits, KeptEdges edges);
    ~CullingJob();
    CullingJob(const CullingJob&) = delete;
    CullingJob& operator=(const CullingJob&) = delete;

    /// Works in the background, in time that nobody else needs.
    void start();
    bool isDone() const { return done_; }
    /// Works at it here.
    void finish();

    const Light& light() const { return light_; }
    /// Once all is done.
    const KeptCasters& kept() const { return kept_; }
    const KeptEdges& edges() const { return edges_; }

  private:
    void work();

    /// A batch that rests and casts.
    struct Resting {
        std::size_t batch;
        std::shared_ptr<const PlanePairShadow> shadow;
        glm::dmat4 worldFromBatch;
    };
    Light light_;
    int mantissaBits_;
    std::vector<Resting> resting_;
    Box receivers_;
    KeptEdges edges_;
    KeptCasters kept_;
    std::atomic<bool> done_ = false, givenUp_ = false;
#ifndef __EMSCRIPTEN__
    std::jthread thread_;
#endif
};

} // namespace edgeshade
