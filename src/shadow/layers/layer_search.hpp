#pragma once

#include "src/shadow/layers/face_chain.hpp"
#include "src/shadow/layers/layer_bound.hpp"
#include "src/shadow/layers/layer_casters.hpp"

#include <map>
#include <optional>

namespace edgeshade {

/// Bounds layers: by silhouettes, and where groups may be needed by triangles. Keeps what it finds
/// out about records for the next search, as long as somebody holds them.
class LayerSearch {
  public:
    /// Bounds the layers around each light. Costs nothing for scenes of at most `limit` triangles.
    /// For several lights the bound holds for every line from any of them, and they share the
    /// groups. `receivers`: where the shadows are seen; the bound holds for lines that end in this
    /// box, and leaves out casters that can't shadow anything in it. Empty: everywhere.
    LayerBound bound(const LayerCasters& casters, std::span<const Light> lights, std::size_t limit,
                     const Box& receivers = {});
    LayerBound bound(const LayerCasters& casters, const Light& light, std::size_t limit,
                     const Box& receivers = {}) {
        return bound(casters, std::span(&light, 1), limit, receivers);
    }

    /// An upper bound of the triangles that a straight line from the light meets, up to its range
    /// and up to the receivers; null if silhouettes don't show that it is at most `limit`
    /// (docs/method.md, C48). Takes 1 to 3 ms for 150,000 triangles.
    std::optional<std::size_t> bySilhouettes(const LayerCasters& casters, const Light& light,
                                             std::size_t limit, const Box& receivers = {});

  private:
    struct Kept {
        std::weak_ptr<const PlanePairShadow> records;
        CasterChain chain;
    };
    /// Keeps what the last light found on its way.
    struct Followed {
        const CasterChain* chain = nullptr; ///< in chains_
        FollowedChain of{};
    };
    const CasterChain& chainOf(const std::shared_ptr<const PlanePairShadow>& records);

    std::map<const PlanePairShadow*, Kept> chains_;
    std::vector<Followed> followed_; ///< by batch
    // Memory that searches reuse.
    SeenCasters seen_;
    std::vector<FaceChain> faces_;
};

} // namespace edgeshade
