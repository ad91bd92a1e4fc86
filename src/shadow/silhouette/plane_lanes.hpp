#pragma once

#include "src/shadow/silhouette/silhouette_list.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// Planes of the triangles of some pairs, each once, with their components in separate arrays for
/// SIMD operations.
class PlaneLanes {
  public:
    /// Replaces them by the planes of listed pairs. `taken`: memory to use.
    void gather(const PlanePairShadow& shadow, const PairList& list,
                std::vector<std::uint8_t>& taken);

    /// Whether the light may be in one of the planes, or within `reach` of it, given floats of
    /// `mantissaBits` mantissa bits. Also if a product overflows.
    bool mayHold(const glm::vec4& light, float reach, int mantissaBits) const;

  private:
    std::vector<float> x_, y_, z_, w_; ///< a multiple of the lanes; the last plane may be repeated
};

} // namespace edgeshade
