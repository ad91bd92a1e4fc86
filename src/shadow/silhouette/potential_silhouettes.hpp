#pragma once

#include "src/shadow/silhouette/silhouette_list.hpp"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <tuple>

namespace edgeshade {

/// Whose silhouettes are asked for.
struct SilhouetteKey {
    std::shared_ptr<const PlanePairShadow> shadow;
    std::size_t batch = 0; ///< its index in the scene: several may have these records
    std::size_t light = 0; ///< its index in the view
    /// Of a light's points: holds all of them, in the batch's space. The list serves them all.
    std::optional<LightBall> around{};
    double range = std::numeric_limits<double>::infinity(); ///< as rangeInObject() has it
    float reach = 0.0f;                                     ///< ContactCaps', of the light
};

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

    /// The list for a light that is in the batch's space. Batches that have the same records and
    /// see the light from the same place, or a sun from the same direction, get the same list. It
    /// stays where it is until the next frame begins; of a light's points `lightInPlane` is that of
    /// the last one that was asked for.
    const SilhouetteList& of(const SilhouetteKey& key, const glm::vec4& light);

    std::size_t made() const { return made_; } ///< lists, since the beginning

  private:
    struct Source { ///< one for records
        std::shared_ptr<const PlanePairShadow> shadow;
        LightFacings facings;
        std::size_t lastFrame = 0;
        /// What was asked for of them in that frame: lights, bit for bit, with their ranges, and
        /// who asked first.
        std::map<std::pair<std::array<std::uint32_t, 4>, double>,
                 std::pair<std::size_t, std::size_t>>
            asked{};
    };
    struct Entry { ///< one for a batch and a light
        LightTrack track;
        SilhouetteList list;
        double range = 0.0;
        float reach = 0.0f;
        std::size_t lastFrame = 0;
    };

    int mantissaBits_;
    std::shared_ptr<const int> scene_;
    std::size_t frame_ = 0;
    std::size_t made_ = 0;
    std::map<const PlanePairShadow*, Source> sources_; ///< which keep their keys alive
    std::map<std::tuple<const PlanePairShadow*, std::size_t, std::size_t>, Entry> entries_;
};

} // namespace edgeshade
