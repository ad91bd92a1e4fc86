#pragma once

#include "src/shadow/layers/face_bound.hpp"
#include "src/shadow/layers/layer_bound.hpp"
#include "src/shadow/layers/layer_casters.hpp"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade {

/// Keeps what searches find out about records, as long as somebody holds these.
class KeptChains {
  public:
    /// A records' chain, made on first use.
    const std::shared_ptr<const CasterChain>&
    of(const std::shared_ptr<const PlanePairShadow>& records);

    /// Forgets records that nobody holds: they are of an earlier pose.
    void forgetReleased();

  private:
    struct Kept {
        std::weak_ptr<const PlanePairShadow> records;
        std::shared_ptr<const CasterChain> chain;
    };
    std::map<const PlanePairShadow*, Kept> chains_;
};

/// Bounds layers: by silhouettes, and where groups may be needed by triangles. Keeps what it finds
/// out for the next search.
class LayerSearch {
  public:
    /// `chains`: of searches for the same casters.
    explicit LayerSearch(std::shared_ptr<KeptChains> chains = std::make_shared<KeptChains>())
        : chains_(std::move(chains)) {}

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

    /// Takes a step of what bound() of the same takes, so that none takes long: a search for the
    /// smallest caster if there was none yet, or a first look at some more of the casters. Returns
    /// whether no such step was left.
    bool lookAhead(const LayerCasters& casters, const Light& light, std::size_t limit,
                   const Box& receivers = {});

  private:
    /// Triangles of a step of looks, which takes some 10 ms in a page that has just loaded.
    static constexpr std::size_t mostAhead = std::size_t{1} << 16;

    /// Keeps what the last light found on its way.
    struct Followed {
        std::shared_ptr<const CasterChain> chain; ///< its records may be gone
        FollowedChain of{};
    };
    /// A batch that a light may see.
    struct LitBatch {
        const CasterChain* chain = nullptr; ///< in chains_
        FollowedChain* followed = nullptr;
        LightInBatch light{};
        CasterReach reach{};
        RaysOfBatch rays{};
        glm::dmat3 batchFromRays{1.0}; ///< of a point light
    };
    /// Empties the light's faces. Returns the batches that it may see, in lit_, until the next
    /// call.
    std::span<LitBatch> beginFaces(const LightView& view, const LayerCasters& casters,
                                   const Light& light, const Box& receivers);
    void lookAndDraw(const LightView& view, const LitBatch& batch);
    /// In lit_, until the next call.
    std::span<LitBatch> findLit(const LightView& view, const LayerCasters& casters,
                                const Light& light, const Box& receivers);
    /// Lets the rays of a directional light enter the frame around all that it sees.
    static void enterFrame(std::span<LitBatch> batches, FaceChain& face);
    /// At most how many certain triangles a ray from a point light meets; no fewer than on any ray
    /// that is next to it.
    int countAlong(const glm::dvec3& direction, std::span<const LitBatch> batches);

    std::shared_ptr<KeptChains> chains_;
    std::vector<Followed> followed_; ///< by batch; empty until the first search
    // Memory that searches reuse.
    std::vector<glm::dvec4> planes_; ///< findPlanesBetween()
    std::vector<LitBatch> lit_;
    SeenCasters seen_;
    ChainPaths paths_;
    std::vector<FaceChain> faces_;
    std::vector<std::uint32_t> caps_; ///< along a ray
    FaceBound bound_;
};

} // namespace edgeshade
