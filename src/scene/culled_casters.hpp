#pragma once

#include "src/scene/batch_volumes.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/geometry/frame_view.hpp"

#include <vector>

namespace edgeshade {

/// The records of a scene's casters without those that are wholly in the shadow of others
/// (docs/method.md, C43), by light, kept while lights rest. What an animation moves is as it was,
/// and has nothing left out for it. If other batches move, clear() comes first.
class CulledCasters {
  public:
    /// What came of a light's casters.
    struct Kept {
        glm::dvec4 light{0.0};             ///< its position
        std::vector<BatchVolumes> volumes; ///< by batch; null where they are the scene's
        std::size_t casters = 0, gone = 0; ///< triangles
        double buildMs = 0.0;
    };

    /// Whether a light's casters may be culled: it rests, has no extent, and one stencil counts
    /// them all.
    static bool suits(const FrameLight& light);

    /// Has those of all lights that suit, and of no others. `mantissaBits`: of the vertex shader's
    /// floats.
    void make(const LoadedScene& loaded, const std::vector<FrameLight>& lights, SidesLayout layout,
              int mantissaBits);

    /// Null: nobody has made them, or the light doesn't suit.
    const Kept* of(const FrameLight& light) const;
    /// A batch's shadow data for the light; null: the scene's.
    BatchVolumes* of(const FrameLight& light, std::size_t batch);
    const BatchVolumes* of(const FrameLight& light, std::size_t batch) const;

    void clear() { kept_.clear(); }
    std::size_t sideBytes() const;
    std::size_t capBytes() const;

  private:
    std::vector<Kept> kept_;
};

} // namespace edgeshade
