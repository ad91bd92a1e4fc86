#pragma once

#include "src/scene/batch_volumes.hpp"
#include "src/scene/culling_job.hpp"
#include "src/shadow/geometry/frame_view.hpp"

#include <vector>

namespace edgeshade {

/// The records of a scene's casters without those that are wholly in the shadow of others
/// (docs/method.md, C43): for lights at rest those of their place, for lights that wander those of
/// all places around. What an animation moves is as it was, and has nothing left out for it. If
/// other batches move, or others are shown, clear() comes first.
class CulledCasters {
  public:
    /// What came of a light's casters.
    struct Kept {
        Light light;                       ///< with an extent: anywhere within it, isWithin()
        std::vector<BatchVolumes> volumes; ///< by batch; null where they are the scene's
        std::size_t casters = 0, gone = 0; ///< triangles
        double buildMs = 0.0;
    };
    /// How records reach the shaders.
    struct Form {
        SidesLayout layout;
        int mantissaBits; ///< of the vertex shader's floats
    };

    /// Whether a light's casters may be culled: it has no extent, and one stencil counts them all.
    static bool suits(const FrameLight& light);

    /// Has those of all lights that suit and rest or wander, and of no others.
    void make(const LoadedScene& loaded, const std::vector<FrameLight>& lights, const Form& form);
    /// The same in the background, light after light: returns whether one has been finished.
    bool advance(const LoadedScene& loaded, const std::vector<FrameLight>& lights,
                 const Form& form);
    /// Whether it works at some.
    bool isBusy() const { return job_ != nullptr; }

    /// Null: nobody has made them, or the light doesn't suit.
    const Kept* of(const FrameLight& light) const;
    /// A batch's shadow data for the light; null: the scene's.
    BatchVolumes* of(const FrameLight& light, std::size_t batch);
    const BatchVolumes* of(const FrameLight& light, std::size_t batch) const;

    void clear();
    std::size_t sideBytes() const;
    std::size_t capBytes() const;

  private:
    void keepOnly(const std::vector<FrameLight>& lights);
    void take(const CullingJob& job, const Form& form);

    std::vector<Kept> kept_;
    KeptEdges edges_;
    std::unique_ptr<CullingJob> job_; ///< in the background
};

} // namespace edgeshade
