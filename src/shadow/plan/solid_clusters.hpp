#pragma once

#include "preprocess/volumes/plane_pair_data.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace edgeshade {

/// By cluster: 1 where each of its components is the surface of a solid, see solidComponents(). 0
/// where nothing is single-sided, so that nobody asks, and where poses change it.
std::vector<std::uint8_t> findSolids(const PlanePairShadow& shadow);

/// Keeps what findSolids() says, for as long as the records are there, of those that don't say it.
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
