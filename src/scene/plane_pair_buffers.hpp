#pragma once

#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/gl/objects.hpp"
#include "src/scene/sides_layout.hpp"
#include "src/shadow/plan/volume_draw.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade {

/// Some or all caps of one cluster. If copied for every vertex, all front caps come first, then all
/// back caps; `alphaCorners` have the same order.
struct CapBuffers {
    std::uint32_t count = 0;
    gl::Buffer records;
    gl::Buffer alphaCorners; ///< three vec4s per cap, see alphaCorners(); or empty
};

/// Uploads records as they are, or a copy for every vertex; without records, an empty buffer.
gl::Buffer uploadPairs(std::span<const PairRecord> records, SidesLayout layout);
CapBuffers uploadCaps(std::span<const CapRecord> records, std::span<const glm::vec4> alphaCorners,
                      SidesLayout layout);

/// One batch's plane-pair shadow data on the GPU. Pairs, and caps cluster by cluster, are uploaded
/// when a plan draws them, and most never are.
class PlanePairBuffers {
  public:
    /// `alphaCorners`: three vec4s per cap, in its order of corners; empty if no caster is
    /// alpha-tested.
    PlanePairBuffers(std::shared_ptr<const PlanePairShadow> shadow,
                     std::vector<glm::vec4> alphaCorners, SidesLayout layout);

    const std::shared_ptr<const PlanePairShadow>& shadow() const { return shadow_; }
    /// Replaces the records by the same ones in another pose, see posedPlanePairs().
    void take(std::shared_ptr<const PlanePairShadow> posed);
    /// Uploads all pairs, or a cluster's caps, if they are missing.
    void uploadAllPairs();
    void uploadCapsOf(std::size_t cluster);

    // Only after their upload:
    const gl::Buffer& pairs() const { return pairs_.value(); }
    const gl::Buffer& singles() const { return singles_; }
    const CapBuffers& capsOf(std::size_t cluster) const { return caps_[cluster].value(); }
    SidesLayout layout() const { return layout_; }
    /// Whether records are copied for every vertex.
    bool copied() const { return layout_ == SidesLayout::notInstanced; }
    // Sizes of everything uploaded so far.
    std::size_t sideBytes() const { return (pairs_ ? pairs_->size() : 0) + singles_.size(); }
    std::size_t capBytes() const;
    std::size_t bytes() const { return sideBytes() + capBytes(); }

  private:
    std::shared_ptr<const PlanePairShadow> shadow_;
    std::vector<glm::vec4> alphaCorners_;
    SidesLayout layout_;
    std::optional<gl::Buffer> pairs_;
    gl::Buffer singles_;
    std::vector<std::optional<CapBuffers>> caps_; ///< by cluster
};

} // namespace edgeshade
