#pragma once

#include "src/shadow/plan/volume_plan.hpp"

namespace edgeshade {

/// The count that a stencil starts at before any volume is drawn, and what it is cleared to for
/// that (docs/method.md, C13 and C19). Counts are modulo 256.
class StencilStart {
  public:
    /// Volumes of one batch more: the near rectangle is in some of them.
    void add(const VolumePlan& plan);

    /// Where everything that is visible is in shadow: one volume around all of it.
    void setFullyShadowed() { count_ = 1; }

    /// Some of what counts does so by two: it is drawn first and counts by one, then all counts are
    /// doubled.
    void setDoubled() { doubled_ = true; }

    int count() const { return count_; }
    bool isDoubled() const { return doubled_; }

    /// What the stencil is cleared to, 0..255: half the count where counts are doubled.
    int cleared() const { return (count_ & 0xFF) >> (doubled_ ? 1 : 0); }

    /// Whether doubled counts take a one, which half of an odd count has lost.
    bool isOddWhenDoubled() const { return doubled_ && (count_ & 1) != 0; }

  private:
    int count_ = 0;
    bool doubled_ = false;
};

} // namespace edgeshade
