#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>

namespace edgeshade::test {

/// A pair of PrimitiveMap's header or entries, which have two to a texel. `texels`: from theirs on.
inline glm::vec2 pairAt(std::span<const glm::vec4> texels, std::size_t number) {
    const glm::vec4& two = texels[number / 2];
    return number % 2 == 0 ? glm::vec2(two.x, two.y) : glm::vec2(two.z, two.w);
}

} // namespace edgeshade::test
