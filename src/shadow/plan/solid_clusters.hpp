#pragma once

#include "preprocess/volumes/plane_pair_data.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace edgeshade {

/// By cluster: 1 where each of its components is the surface of a solid, wound outwards: every edge
/// has two triangles, which run through it opposite ways, no triangles cross, and the volume within
/// is above 0. Its winding number is then 1 within and 0 outside, and a ray that comes from outside
/// meets a front first (docs/method.md, C39). 0 where that is not so, or not beyond doubt; and
/// where nothing is single-sided, so that nobody asks. Contacts are no crossings, nor is what
/// rounding can't tell from one. Some hundred milliseconds for 100,000 triangles.
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
