#pragma once

#include "src/image/radiance_file.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// Radiance by direction on an equirectangular picture: its middle column looks along -Z, right of
/// it is +X, its left and right edges are +Z, its top is +Y.
class Panorama {
  public:
    static constexpr int mostColumns = 1024, mostRows = 512;

    /// Reads all rows, larger pictures averaged to that size. Throws InputError.
    explicit Panorama(RadianceFile& file);

    int width() const { return width_; }
    int height() const { return height_; }

    const glm::vec3& at(int x, int y) const { return texels_[index(x, y)]; }

    /// The middle of a texel.
    glm::vec3 direction(int x, int y) const;

    /// Of each texel of a row, in sr.
    double solidAngle(int y) const;

    /// Multiplies all, and cuts it off at `largest`.
    void scale(double factor, double largest);

    /// Filtered linearly.
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
