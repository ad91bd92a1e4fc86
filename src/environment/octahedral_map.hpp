#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// The position of a direction, of any length but 0, on the map, within [-1, 1]. The map is the
/// octahedron unfolded into a square, +Y in its middle, -Y in its corners (Meyer et al., "On
/// Floating-Point Normal Vectors", 2010).
glm::vec2 octahedralFromDirection(const glm::vec3& direction);

/// The direction of unit length at a position on the map.
glm::vec3 directionFromOctahedral(const glm::vec2& at);

/// Radiance by direction. A border of one texel repeats the texels across the square's edge, so
/// that linear filtering has no seam.
class OctahedralMap {
  public:
    /// Allocates `size` x `size` texels, 1 or more, and the border.
    explicit OctahedralMap(int size);

    int size() const { return size_; }

    /// A texel; x and y from -1, in the border, to size().
    glm::vec3& at(int x, int y) { return texels_[index(x, y)]; }
    const glm::vec3& at(int x, int y) const { return texels_[index(x, y)]; }

    /// The direction of a texel's middle.
    glm::vec3 direction(int x, int y) const;

    /// The texel that contains a direction.
    glm::ivec2 texelAt(const glm::vec3& direction) const;

    /// Solid angle of a texel in sr, by the formula at its middle; the sum is about 4 pi.
    float solidAngle(int x, int y) const;

    /// Fills the border; call it after setting texels.
    void closeBorder();

    /// The largest value of any channel.
    float largest() const;

    /// Radiance in a direction, filtered linearly.
    glm::vec3 lookUp(const glm::vec3& direction) const;

    /// Sets every texel to `radiance` of its direction, and the border.
    template <class Radiance>
    void fill(Radiance radiance) {
        for (int y = 0; y < size_; ++y)
            for (int x = 0; x < size_; ++x)
                at(x, y) = radiance(direction(x, y));
        closeBorder();
    }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(size_ + 2) +
               static_cast<std::size_t>(x + 1);
    }
    glm::vec2 middle(int x, int y) const;

    int size_;
    std::vector<glm::vec3> texels_; ///< rows of size_ + 2
};

} // namespace edgeshade
