#pragma once

#include "src/gl/objects.hpp"
#include "src/render/proposal.hpp"
#include "src/scene/adapted_buffers.hpp"

#include <map>
#include <memory>

namespace edgeshade {

/// A proposal with its pair records gathered for the GPU, in the order of the list.
struct ProposedPairs {
    Proposal list;
    gl::Buffer records; ///< PairRecords, or copies for every vertex as AdaptedBuffers has them
};

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
    const ProposedPairs& of(const std::shared_ptr<const AdaptedShadow>& shadow, std::size_t index,
                            const glm::vec4& light);

    std::size_t bytes() const;                 ///< on the GPU
    std::size_t made() const { return made_; } ///< lists, since the beginning

  private:
    struct Source { ///< one for a batch
        std::shared_ptr<const AdaptedShadow> shadow;
        LightFacings facings;
        std::size_t lastFrame = 0;
    };
    struct Entry { ///< one for a batch and a light
        LightTrack track;
        ProposedPairs pairs;
        std::size_t lastFrame = 0;
    };

    void gather(const AdaptedShadow& shadow, ProposedPairs& pairs);

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
