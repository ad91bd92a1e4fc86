#include "src/environment/environment.hpp"

#include "src/environment/radiance_encoding.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

glm::vec3 levelRadiance(const Atlas& atlas, const glm::vec2& at, int level) {
    const AtlasTile tile = Atlas::tile(level);
    const auto mapSize = static_cast<float>(Atlas::mapSize(level));
    return decodeRadiance(
        atlas.filtered(glm::vec2(tile.x, tile.y) + 1.0f + (at * 0.5f + 0.5f) * mapSize),
        atlas.largestRoot());
}

} // namespace

glm::vec3 environmentDiffuse(const Environment& environment, const glm::vec3& normal) {
    const std::array<float, 9> terms = diffuseTerms(normal);
    glm::vec3 sum(0.0f);
    for (std::size_t i = 0; i < terms.size(); ++i)
        sum += environment.diffuse[i] * terms[i];
    return glm::max(sum, 0.0f);
}

glm::vec3 environmentSpecular(const Environment& environment, const glm::vec3& direction,
                              float roughness) {
    const glm::vec2 at = octahedralFromDirection(direction);
    const int last = Atlas::levels() - 1;
    const float level = std::clamp(roughness, 0.0f, 1.0f) * static_cast<float>(last);
    const int lower = std::min(static_cast<int>(level), last - 1);
    return glm::mix(levelRadiance(environment.specular, at, lower),
                    levelRadiance(environment.specular, at, lower + 1),
                    level - static_cast<float>(lower));
}

} // namespace edgeshade
