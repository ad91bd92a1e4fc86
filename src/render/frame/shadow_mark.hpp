#pragma once

#include "src/render/drawing/whole_picture.hpp"

#include <optional>

namespace edgeshade {

/// Marks in the picture's alpha. Alpha keeps "in shadow" (0) while the stencil is cleared for the
/// next group of casters, so that 8 stencil bits suffice for any count. Or it holds the share of a
/// colour that remains in shadow.
class ShadowMark {
  public:
    /// Sets alpha to 1: nothing is marked, and shadow leaves colours unchanged.
    void clear();

    /// Marks where the stencil isn't 0.
    void markCounted();

    /// Multiplies colours by alpha where the stencil isn't 0.
    void darkenCounted();

    /// Adds a value wherever the present stencil test passes, whatever the depth.
    void addValue(float value);

    /// Begins to make the programs that aren't made yet.
    void beginPrograms();
    void forEachProgram(const gl::ProgramVisitor& visit) const;

  private:
    void drawCounted();

    WholePicture picture_;
    std::optional<WholePicture> value_; ///< created on first use
};

} // namespace edgeshade
