#pragma once

#include "src/shadow/silhouette/plane_lanes.hpp"
#include "src/shadow/silhouette/silhouette_list.hpp"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <tuple>

namespace edgeshade {

/// The records, batch and light of a silhouette list.
struct SilhouetteKey {
    std::shared_ptr<const PlanePairShadow> shadow;
    std::size_t batch = 0; ///< its index in the scene; several batches may share these records
    std::size_t light = 0; ///< its number, as of FrameView::numberOf()
    /// For a light's points: a ball that holds all of them, in the batch's space. One list serves
    /// them all.
    std::optional<LightBall> around{};
    double range = std::numeric_limits<double>::infinity(); ///< as of rangeInObject()
    float reach = 0.0f;                                     ///< ContactCaps::reach for the light
};

/// Keeps the lists of potential silhouettes for lights and batches from frame to frame. A list is
/// rebuilt only when its light leaves the ball it was built for (docs/method.md, C24).
class PotentialSilhouettes {
  public:
    static constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

    /// `mantissaBits`: of the vertex shader's floats.
    explicit PotentialSilhouettes(int mantissaBits) : mantissaBits_(mantissaBits) {}

    /// Call this first: lights move from frame to frame, never within one. Deletes lists that the
    /// last frames didn't use, those whose records nobody else holds, and all of them if `scene`,
    /// the identity of the upload, has changed. `mostListed`: once lists of so many records have
    /// been made in this frame, there are no more; for frames that aren't drawn.
    void beginFrame(const std::shared_ptr<const int>& scene, std::size_t mostListed = unlimited);

    /// The list for a light in the batch's space. Batches with the same records share one if they
    /// see the light from the same position, or a sun from the same direction. It is valid until
    /// the next frame begins; null once this frame has made as many as it may. For points of a
    /// light `lightInPlane` is that of the last request.
    const SilhouetteList* of(const SilhouetteKey& key, const glm::vec4& light);

    std::size_t made() const { return made_; } ///< lists built so far

  private:
    /// Requests for a set of records in a frame: lights, bit for bit, with their ranges, and the
    /// first batch and light to request them.
    using Asked = std::map<std::pair<std::array<std::uint32_t, 4>, double>,
                           std::pair<std::size_t, std::size_t>>;
    struct Source { ///< one for each set of records
        std::shared_ptr<const PlanePairShadow> shadow;
        LightFacings facings;
        std::size_t lastFrame = 0;
        Asked asked{};                         ///< in that frame
        std::vector<Asked::node_type> spare{}; ///< of earlier frames, for their memory

        void forgetRequests();
        /// The first batch and light to request it in this frame: perhaps this one.
        std::pair<std::size_t, std::size_t> firstToAsk(const Asked::key_type& request,
                                                       const SilhouetteKey& key);
    };
    struct Entry { ///< one for each batch and light
        LightTrack track;
        SilhouetteList list;
        PlaneLanes uncertain; ///< planes of the list's uncertain pairs
        double range = 0.0;
        float reach = 0.0f;
        std::size_t lastFrame = 0;
    };

    int mantissaBits_;
    std::shared_ptr<const int> scene_;
    std::size_t frame_ = 0;
    std::size_t made_ = 0;
    std::size_t mostListed_ = unlimited; ///< records, in this frame
    ListMemory memory_;
    std::vector<std::uint8_t> taken_;                  ///< by cap, for PlaneLanes
    std::map<const PlanePairShadow*, Source> sources_; ///< these keep their keys alive
    std::map<std::tuple<const PlanePairShadow*, std::size_t, std::size_t>, Entry> entries_;
};

} // namespace edgeshade
