#pragma once

#include "src/render/whole_picture.hpp"

namespace edgeshade {

/// What the picture's alpha is for: it keeps "in shadow" (0) while the stencil is cleared for the
/// next group of casters, a counter as wide as it takes, out of one of eight bits; or the share of
/// a colour that shadow leaves.
class ShadowMark {
  public:
    /// Alpha 1: everything is unmarked, and shadow leaves all of it.
    void clear();

    /// Marks where the stencil isn't 0.
    void markCounted();

    /// Leaves, where the stencil isn't 0, of each colour the share that alpha says.
    void darkenCounted();

  private:
    void drawCounted();

    WholePicture picture_;
};

} // namespace edgeshade
