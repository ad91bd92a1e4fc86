#pragma once

#include "src/shadow/lights/light_view.hpp"

#include <cstddef>
#include <vector>

namespace edgeshade::test {

/// How many casters the lines of a light certainly meet, for a lattice of lines on each of its
/// faces. Each caster is tested by itself, and lines within rounding of its edges don't meet it.
class LineCounts {
  public:
    /// `side`: lines along each side of a face, or of the scene's outline for a sun.
    LineCounts(const Scene& scene, bool castMasked, const Light& light, int side);

    /// The most casters on one line.
    std::size_t most() const;

  private:
    struct Face {
        Outline part;
        std::vector<std::size_t> counts; ///< row by row
    };
    using Rays = std::array<glm::dvec3, 3>;

    glm::dvec2 lineAt(const Face& face, int row, int column) const;
    void add(const Rays& rays, double rounding);
    bool meets(const glm::dvec3& line, const Rays& rays, double rounding) const;

    LightView view_;
    int side_;
    std::vector<Face> faces_;
};

} // namespace edgeshade::test
