#pragma once

#include "src/environment/octahedral_map.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// A level's rectangle in the atlas, in texels, with its border.
struct AtlasTile {
    int x, y;
    int size;
};

/// Radiance by direction and roughness, in one texture of 8-bit RGBA, filtered linearly and without
/// mipmaps. shaders_es2/environment_layout.glsl gives its layout.
class Atlas {
  public:
    /// Creates a black atlas for radiance up to `largest`, above 0, clamped to
    /// largestEncodedRadiance.
    explicit Atlas(float largest = 1.0f);

    static int width();
    static int height();
    static int levels();

    /// Perceptual roughness of a level, 0 to 1.
    static float roughness(int level);
    static AtlasTile tile(int level);

    /// Texels along the edge of a level's map.
    static int mapSize(int level) { return tile(level).size - 2; }

    /// Encodes a map of mapSize(level).
    void setLevel(int level, const OctahedralMap& map);

    /// The second argument of encodeRadiance().
    float largestRoot() const { return largestRoot_; }

    /// Texels in rows of width().
    const std::vector<std::uint8_t>& rgba() const { return rgba_; }

  private:
    float largestRoot_;
    std::vector<std::uint8_t> rgba_;
};

} // namespace edgeshade
