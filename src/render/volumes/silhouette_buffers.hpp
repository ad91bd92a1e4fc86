#pragma once

#include "src/scene/plane_pair_buffers.hpp"
#include "src/shadow/silhouette/silhouette_list.hpp"

#include <map>
#include <memory>

namespace edgeshade {

/// The records of potential silhouettes on the GPU, in the layout of PlanePairBuffers. They are
/// dropped with their lists (SilhouetteList::identity), and replaced by later versions.
class SilhouetteBuffers {
  public:
    /// The records of one list.
    struct Gathered {
        std::size_t version = 0;                  ///< the list's
        gl::Buffer certainPairs, uncertainPairs;  ///< in the order of their lists
        std::map<std::uint32_t, CapBuffers> caps; ///< by cluster: the caps that may face the light
    };

    /// `layout`: how records reach the shader.
    explicit SilhouetteBuffers(SidesLayout layout) : layout_(layout) {}

    /// Uploads the pairs of a list, if they are missing. `shadow`: the records that the list refers
    /// to.
    void upload(const PlanePairShadow& shadow, const SilhouetteList& list);
    /// Also uploads the light-facing caps of a cluster.
    void uploadCapsOf(const PlanePairShadow& shadow, const SilhouetteList& list,
                      std::uint32_t cluster);

    /// The uploaded records of a list.
    const Gathered& of(const SilhouetteList& list) const {
        return gathered_.find(list.identity)->second;
    }

    /// Frees the records of lists that no longer exist.
    void dropExpired();

    std::size_t sideBytes() const;
    std::size_t capBytes() const;

  private:
    SidesLayout layout_;
    std::map<std::weak_ptr<const int>, Gathered, std::owner_less<>> gathered_;
    // Scratch space for the pairs of a list, and the caps of a cluster.
    std::vector<PairRecord> pairs_;
    std::vector<CapRecord> caps_;
};

} // namespace edgeshade
