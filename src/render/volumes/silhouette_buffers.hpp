#pragma once

#include "src/scene/plane_pair_buffers.hpp"
#include "src/shadow/silhouette/silhouette_list.hpp"

#include <map>
#include <memory>

namespace edgeshade {

/// The records of potential silhouettes, gathered on the GPU in the forms that PlanePairBuffers
/// has. They go with their lists (SilhouetteList::identity), and are replaced by later versions.
class SilhouetteBuffers {
  public:
    /// What is gathered of one list.
    struct Gathered {
        std::size_t version = 0;                  ///< the list's
        gl::Buffer certainPairs, uncertainPairs;  ///< in the order of their lists
        std::map<std::uint32_t, CapBuffers> caps; ///< by cluster: those that may face the light
    };

    /// `layout`: how records reach the shader.
    explicit SilhouetteBuffers(SidesLayout layout) : layout_(layout) {}

    /// Uploads the pairs of a list, if they are not there yet. `shadow`: what it lists records of.
    void upload(const PlanePairShadow& shadow, const SilhouetteList& list);
    /// Uploads the light-facing caps of a cluster too.
    void uploadCapsOf(const PlanePairShadow& shadow, const SilhouetteList& list,
                      std::uint32_t cluster);

    /// What was uploaded of a list.
    const Gathered& of(const SilhouetteList& list) const {
        return gathered_.find(list.identity)->second;
    }

    /// Gives back what belongs to lists that are no more.
    void dropExpired();

    std::size_t sideBytes() const;
    std::size_t capBytes() const;

  private:
    SidesLayout layout_;
    std::map<std::weak_ptr<const int>, Gathered, std::owner_less<>> gathered_;
    std::vector<PairRecord> pairs_; ///< of a list, on the way
};

} // namespace edgeshade
