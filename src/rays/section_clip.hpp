#pragma once

#include "preprocess/scene/section.hpp"
#include "src/rays/surface_triangle.hpp"

#include <vector>

namespace edgeshade::rays {

/// Clips triangles of a batch by a section, in double precision. Apart from the side that a vertex
/// is on, nothing is shared with the code that cuts scenes for drawing.
class SectionClip {
  public:
    SectionClip(const Section& section, const glm::dmat4& worldFromBatch);

    /// Adds what the section keeps of a triangle, and, if the section casts as a whole, what it
    /// cuts away, as invisible casters. `solid`: it bounds a solid, and goes with it if it lies in
    /// a plane.
    void add(const SurfaceTriangle& triangle, bool solid, std::vector<SurfaceTriangle>& to) const;

  private:
    std::vector<glm::dvec4> planes_; ///< in the batch's space
    bool castsWhole_;
};

} // namespace edgeshade::rays
