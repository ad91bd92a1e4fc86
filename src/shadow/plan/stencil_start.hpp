#pragma once

#include "src/shadow/plan/volume_plan.hpp"

namespace edgeshade {

/// The count at which a stencil starts before any volume is drawn, and the value it is cleared to
/// for that (docs/method.md, C13 and C19). Counts are modulo 256.
class StencilStart {
  public:
    /// Adds a batch's volumes that contain the near rectangle.
    void add(const VolumePlan& plan);

    /// Everything visible is in shadow: sets the start to one volume around all of it.
    void setFullyShadowed() { count_ = 1; }

    /// Some volumes count by two. They are drawn first and count by one; then all counts are
    /// doubled.
    void setDoubled() { doubled_ = true; }

    int count() const { return count_; }
    bool isDoubled() const { return doubled_; }

    /// The stencil's clear value, 0..255: half the count if counts are doubled.
    int cleared() const { return (count_ & 0xFF) >> (doubled_ ? 1 : 0); }

    /// Whether 1 is added after doubling, because halving lost it from an odd count.
    bool isOddWhenDoubled() const { return doubled_ && (count_ & 1) != 0; }

  private:
    int count_ = 0;
    bool doubled_ = false;
};

} // namespace edgeshade
