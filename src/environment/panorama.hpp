#pragma once

#include "src/image/radiance_file.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// Radiance by direction on an equirectangular picture: its middle column is -Z, to the right of it
/// is +X, its left and right edges are +Z, its top is +Y.
class Panorama {
  public:
    static constexpr int mostColumns = 1024, mostRows = 512;

    /// Reads all rows, and averages larger pictures down to that size. Throws InputError.
    explicit Panorama(RadianceFile& file);

    int width() const { return width_; }
    int height() const { return height_; }

    const glm::vec3& at(int x, int y) const { return texels_[index(x, y)]; }

    /// The direction of a texel's middle.
    glm::vec3 direction(int x, int y) const;

    /// Solid angle of each texel in a row, in sr.
    double solidAngle(int y) const;

    /// Multiplies all radiance by `factor`, and clamps it to `largest`.
    void scale(double factor, double largest);

    /// Radiance in a direction, filtered linearly.
    glm::vec3 lookUp(const glm::vec3& direction) const;

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

    int width_, height_;
    std::vector<glm::vec3> texels_;
};

} // namespace edgeshade
