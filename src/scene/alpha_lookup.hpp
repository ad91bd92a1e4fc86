#pragma once

#include "src/gl/objects.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

struct Material;
class Textures;

/// Where an alpha-tested surface finds its alpha: `factor` times its vertices' times what a
/// texture has in one channel. Below `cutoff` it is cut out.
struct AlphaLookup {
    gl::Name texture = 0;
    glm::vec4 channel{0.0f, 0.0f, 0.0f, 1.0f}; ///< 1 in that channel, else 0
    glm::mat3 texcoordTransform{1.0f};         ///< uv' = texcoordTransform * (u, v, 1)
    float factor = 1.0f;
    float cutoff = 0.5f;
};

/// That of a file's material; its vertices' texture coordinates are transformed.
AlphaLookup alphaLookupOf(const Material& material, const Textures& textures);

} // namespace edgeshade
