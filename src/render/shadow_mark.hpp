#pragma once

#include "src/gl/program.hpp"

namespace edgeshade {

/// Keeps "in shadow" in the picture's alpha (0) while the stencil is cleared for the next group of
/// casters: a counter as wide as it takes, out of one of eight bits.
class ShadowMark {
  public:
    ShadowMark();

    /// Everything is unmarked: alpha 1.
    void clear();

    /// Marks where the stencil isn't 0.
    void markCounted();

  private:
    gl::Program program_;
    gl::Buffer triangle_;
};

} // namespace edgeshade
