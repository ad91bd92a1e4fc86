#pragma once

#include "preprocess/scene/section.hpp"
#include "src/lab/eye_triangle.hpp"

#include <vector>

namespace edgeshade::lab {

/// Clips triangles by a section, in double precision and on its own: nothing is shared with the
/// code that cuts scenes for drawing.
class SectionClip {
  public:
    /// `eye`: the origin of the triangles' coordinates, in the world.
    SectionClip(const Section& section, const glm::dvec3& eye);

    /// Adds what the section keeps of a triangle, and, if the section casts as a whole, what it
    /// cuts away, as invisible casters.
    void add(const EyeTriangle& triangle, std::vector<EyeTriangle>& to) const;

  private:
    std::vector<glm::dvec4> planes_; ///< relative to the eye
    bool castsWhole_;
};

} // namespace edgeshade::lab
