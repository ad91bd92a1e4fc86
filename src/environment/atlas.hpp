#pragma once

#include "src/environment/octahedral_map.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// A level's place in the atlas, in texels, its border included.
struct AtlasTile {
    int x, y;
    int size;
};

/// Radiance by direction and roughness, in one texture of 8-bit RGBA that is filtered linearly and
/// has no mipmaps. shaders_es2/environment_layout.glsl says what lies where.
class Atlas {
  public:
    /// All black, for radiance up to `largest`, above 0; beyond largestEncodedRadiance counts as
    /// that.
    explicit Atlas(float largest = 1.0f);

    static int width();
    static int height();
    static int levels();

    /// Perceptual roughness of a level, 0 to 1.
    static float roughness(int level);
    static AtlasTile tile(int level);

    /// Texels along the edge of the map that a level takes.
    static int mapSize(int level) { return tile(level).size - 2; }

    /// Encodes a map of mapSize(level).
    void setLevel(int level, const OctahedralMap& map);

    /// What the GL gives between texels: each channel filtered by itself, 0 to 1. `texel` counts
    /// from the first texel's corner and is at least 1/2 away from the atlas' edges.
    glm::vec4 filtered(const glm::vec2& texel) const;

    /// What decodeRadiance() takes beside a texel.
    float largestRoot() const { return largestRoot_; }

    /// Rows of width() texels.
    const std::vector<std::uint8_t>& rgba() const { return rgba_; }

  private:
    float largestRoot_;
    std::vector<std::uint8_t> rgba_;
};

} // namespace edgeshade
