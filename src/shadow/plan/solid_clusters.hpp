#pragma once

#include "preprocess/volumes/plane_pair_data.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace edgeshade {

/// By cluster: 1 if each of its components is the surface of a solid, see solidComponents(). 0 for
/// clusters without single-sided triangles, which need no answer, and for deforming batches.
std::vector<std::uint8_t> findSolids(const PlanePairShadow& shadow);

/// Caches findSolids() by shadow data, for as long as the data exist.
class KeptSolids {
  public:
    const std::vector<std::uint8_t>& of(const std::shared_ptr<const PlanePairShadow>& shadow);

  private:
    struct Entry {
        std::weak_ptr<const PlanePairShadow> shadow;
        std::vector<std::uint8_t> solids;
    };
    std::map<const PlanePairShadow*, Entry> entries_;
};

} // namespace edgeshade
