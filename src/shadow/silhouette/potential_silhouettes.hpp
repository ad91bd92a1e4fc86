#pragma once

#include "src/shadow/silhouette/silhouette_list.hpp"

#include <map>
#include <memory>

namespace edgeshade {

/// Keeps the lists of potential silhouettes for lights and batches from frame to frame, and makes
/// them anew only where a light leaves the ball that its list was made for (docs/method.md, C24).
class PotentialSilhouettes {
  public:
    /// `mantissaBits`: of the vertex shader's floats.
    explicit PotentialSilhouettes(int mantissaBits) : mantissaBits_(mantissaBits) {}

    /// Lights move from frame to frame, never within one. Forgets what the last ones didn't need
    /// and what nobody else holds any more, and everything where `scene`, what tells an upload
    /// from any other, is another than before.
    void beginFrame(const std::shared_ptr<const int>& scene);

    /// The list of a batch for the light with that index, which is in the batch's space. It stays
    /// where it is until the next frame begins.
    const SilhouetteList& of(const std::shared_ptr<const PlanePairShadow>& shadow,
                             std::size_t index, const glm::vec4& light);

    std::size_t made() const { return made_; } ///< lists, since the beginning

  private:
    struct Source { ///< one for a batch
        std::shared_ptr<const PlanePairShadow> shadow;
        LightFacings facings;
        std::size_t lastFrame = 0;
    };
    struct Entry { ///< one for a batch and a light
        LightTrack track;
        SilhouetteList list;
        std::size_t lastFrame = 0;
    };

    int mantissaBits_;
    std::shared_ptr<const int> scene_;
    std::size_t frame_ = 0;
    std::size_t made_ = 0;
    std::map<const PlanePairShadow*, Source> sources_; ///< which keep their keys alive
    std::map<std::pair<const PlanePairShadow*, std::size_t>, Entry> entries_;
};

} // namespace edgeshade
