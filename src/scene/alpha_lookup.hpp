#pragma once

#include "src/gl/objects.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

struct Material;
class Textures;

/// How an alpha-tested surface gets its alpha: `factor` times the vertex alpha times one channel of
/// a texture. Below `cutoff` it is cut out.
struct AlphaLookup {
    gl::Name texture = 0;
    glm::vec4 channel{0.0f, 0.0f, 0.0f, 1.0f}; ///< 1 in the alpha channel, 0 in the others
    glm::mat3 texcoordTransform{1.0f};         ///< uv' = texcoordTransform * (u, v, 1)
    float factor = 1.0f;
    float cutoff = 0.5f;
};

/// The lookup for a material of a file, whose vertices' texture coordinates are already
/// transformed.
AlphaLookup alphaLookupOf(const Material& material, const Textures& textures);

} // namespace edgeshade
