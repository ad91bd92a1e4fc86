#pragma once

#include "src/gl/objects.hpp"
#include "src/scene/adapted_buffers.hpp"
#include "src/shadow/plan/volume_plan.hpp"
#include "src/shadow/silhouette/proposal.hpp"

#include <map>
#include <memory>

namespace edgeshade {

/// A proposal with its records gathered for the GPU, in the forms that AdaptedBuffers has.
struct ProposedRecords {
    Proposal list;
    gl::Buffer certainPairs, uncertainPairs; ///< in the order of their lists
    /// By cluster: caps that may face the light, uploaded when they are first drawn.
    mutable std::map<std::uint32_t, CapBuffers> caps;

    std::size_t sideBytes() const { return certainPairs.size() + uncertainPairs.size(); }
    std::size_t capBytes() const;
};

/// The list alone, null of null.
inline const Proposal* listOf(const ProposedRecords* proposed) {
    return proposed ? &proposed->list : nullptr;
}

/// The caps of a cluster that may face the light; `buffers` are those that the proposal was made
/// for.
const CapBuffers& lightFacingCaps(const ProposedRecords& proposed, const AdaptedBuffers& buffers,
                                  std::uint32_t cluster);

/// Keeps proposals for lights and batches from frame to frame, and makes them anew only where a
/// light leaves the ball that its list was made for. Needs a current context for its whole life.
class Proposals {
  public:
    /// `layout`: how gathered records reach the shader; `mantissaBits`: of its floats.
    Proposals(SidesLayout layout, int mantissaBits)
        : layout_(layout), mantissaBits_(mantissaBits) {}

    /// Lights move from frame to frame, never within one. Forgets what the last ones didn't need,
    /// and everything where `scene`, what tells an upload from any other, is another than before.
    void beginFrame(const std::shared_ptr<const int>& scene);

    /// What to draw of a batch for the light with that index, which is in the batch's space.
    const ProposedRecords& of(const std::shared_ptr<const AdaptedShadow>& shadow, std::size_t index,
                              const glm::vec4& light);

    std::size_t sideBytes() const; ///< on the GPU
    std::size_t capBytes() const;  ///< on the GPU
    std::size_t bytes() const { return sideBytes() + capBytes(); }
    std::size_t made() const { return made_; } ///< lists, since the beginning

  private:
    struct Source { ///< one for a batch
        std::shared_ptr<const AdaptedShadow> shadow;
        LightFacings facings;
        std::size_t lastFrame = 0;
    };
    struct Entry { ///< one for a batch and a light
        LightTrack track;
        ProposedRecords records;
        std::size_t lastFrame = 0;
    };

    void gather(const AdaptedShadow& shadow, ProposedRecords& records);

    SidesLayout layout_;
    int mantissaBits_;
    std::shared_ptr<const int> scene_;
    std::size_t frame_ = 0;
    std::size_t made_ = 0;
    std::map<const AdaptedShadow*, Source> sources_; ///< which keep their keys alive
    std::map<std::pair<const AdaptedShadow*, std::size_t>, Entry> entries_;
    std::vector<PairRecord> gathered_;
};

} // namespace edgeshade
