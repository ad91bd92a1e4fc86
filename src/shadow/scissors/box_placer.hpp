#pragma once

#include "preprocess/base/box.hpp"
#include "src/shadow/scissors/light_space.hpp"

namespace edgeshade {

/// Places boxes of a batch in a light's space. Nothing of them is left out, wherever a GL puts it.
class BoxPlacer {
  public:
    BoxPlacer(const glm::dmat4& worldFromBatch, const LightSpace& space);

    LightBox placed(const Box& box) const;

  private:
    glm::dmat3 turn_, sizes_;
    glm::dvec3 origin_;
    double farthest_;
};

} // namespace edgeshade
