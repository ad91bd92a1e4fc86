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

/// Floats of records on the GPU: those of the structs in plane_pair_data.hpp, when copied for every
/// vertex with the corner's number in front.
inline constexpr std::size_t pairFloats = sizeof(PairRecord) / sizeof(float);
inline constexpr std::size_t singleFloats = sizeof(SingleRecord) / sizeof(float);
inline constexpr std::size_t capFloats = sizeof(CapRecord) / sizeof(float);

/// One cluster's caps, or some of them. Copied for every vertex, all front caps come first, then
/// all back caps; `alphaCorners` in the same order.
struct CapBuffers {
    std::uint32_t count = 0;
    gl::Buffer records;
    gl::Buffer alphaCorners; ///< three vec4s a cap, see alphaCorners(); or empty
};

/// Uploads records as they are, or a copy for every vertex; nothing where there are none.
gl::Buffer uploadPairs(std::span<const PairRecord> records, SidesLayout layout);
CapBuffers uploadCaps(std::span<const CapRecord> records, std::span<const glm::vec4> alphaCorners,
                      SidesLayout layout);

/// One batch's plane-pair shadow data on the GPU. Pairs, and caps cluster by cluster, are uploaded
/// where a plan draws them: most never are.
class PlanePairBuffers {
  public:
    /// `alphaCorners`: three vec4s a cap, in its order of corners; empty where none is
    /// alpha-tested.
    PlanePairBuffers(std::shared_ptr<const PlanePairShadow> shadow,
                     std::vector<glm::vec4> alphaCorners, SidesLayout layout);

    const std::shared_ptr<const PlanePairShadow>& shadow() const { return shadow_; }
    /// The same records in another pose, see posedPlanePairs().
    void take(std::shared_ptr<const PlanePairShadow> posed);
    /// Uploads all pairs, or a cluster's caps, if they are not there yet.
    void uploadAllPairs();
    void uploadCapsOf(std::size_t cluster);

    // Of what was uploaded:
    const gl::Buffer& pairs() const { return pairs_.value(); }
    const gl::Buffer& singles() const { return singles_; }
    const CapBuffers& capsOf(std::size_t cluster) const { return caps_[cluster].value(); }
    SidesLayout layout() const { return layout_; }
    /// Whether records are copied for every vertex.
    bool copied() const { return layout_ == SidesLayout::notInstanced; }
    // Of what was uploaded so far.
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
