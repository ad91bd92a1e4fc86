#pragma once

#include "src/gl/capabilities.hpp"
#include "src/render/adapted_volumes.hpp"
#include "src/render/batch_view.hpp"
#include "src/render/caps_pass.hpp"
#include "src/render/light_plan.hpp"
#include "src/render/proposals.hpp"
#include "src/render/render_settings.hpp"
#include "src/render/sides_pass.hpp"
#include "src/render/whole_picture.hpp"
#include "src/scene/gpu_scene.hpp"

#include <functional>
#include <optional>

namespace edgeshade {

/// The shadow data of the scene's batch with that index.
using VolumesOfBatch = std::function<const BatchVolumes&(std::size_t)>;

/// Whose shadow volumes are counted, and seen from where.
struct CountTask {
    const GpuScene& scene;
    const FrameView& view;
    const DepthSlice& slice;
    std::size_t light; ///< its index in the view
    const VolumesOfBatch& volumesOf;
};

/// What is counted, and how.
struct PreparedCount {
    /// What of a batch.
    struct Batch {
        const BatchVolumes& volumes;
        BatchView view;
        glm::vec4 light; ///< in its space
        // Of adapted records:
        std::size_t planned = 0; ///< index in plan.batches
        const ProposedRecords* proposed = nullptr;
        // Of published ones:
        bool nearDiscard = true;
    };
    LightPlan plan; ///< of adapted records
    std::vector<Batch> batches;
    bool sealed = false;      ///< everything visible is in shadow, and nothing is drawn
    bool countsByTwo = false; ///< some sides do
    int start = 0;            ///< the count before anything is drawn
    std::size_t vertexRuns = 0;

    /// What the stencil must be cleared to.
    int cleared() const;
};

/// Counts in the stencil, modulo 256, how many shadow volumes the surfaces in the depth buffer are
/// in: 0 where they are lit.
class VolumeCounter {
  public:
    /// Throws Error(unavailable) if the layout needs instancing and there is none.
    VolumeCounter(const RenderSettings& settings, const gl::Capabilities& capabilities);

    /// Lights move from frame to frame, never within one.
    void beginFrame(const GpuScene& scene);

    /// Holds for this frame. Draws nothing, but uploads records that are proposed.
    PreparedCount prepare(const CountTask& task);

    /// Counts in a stencil that was cleared to prepared.cleared(). Colour and depth masks, the
    /// depth test and its function (less) and the stencil's test and function (always) are the
    /// caller's state.
    void count(const PreparedCount& prepared, const GpuScene& scene);

    /// Of the records that are proposed for the lights of late; null where none are.
    const Proposals* proposals() const { return proposals_ ? &*proposals_ : nullptr; }

  private:
    PreparedCount prepareAdapted(const CountTask& task);
    PreparedCount preparePublished(const CountTask& task) const;
    void countAdapted(const PreparedCount& prepared, const GpuScene& scene);
    void countPublished(const PreparedCount& prepared, const GpuScene& scene);

    int mantissaBits_;                      ///< of the vertex shader's floats
    std::optional<AdaptedVolumes> adapted_; ///< where multiplicities come from planes
    std::optional<WholePicture> picture_;   ///< likewise
    std::optional<Proposals> proposals_;    ///< where they are asked for
    std::optional<SidesPass> sides_;        ///< where not
    std::optional<CapsPass> caps_;          ///< likewise
};

} // namespace edgeshade
