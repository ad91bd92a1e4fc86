#pragma once

#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/shadow/lights/light_ball.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// A bound on what the shaders' dot(plane, light) may be off by, as a share of the sum of its
/// terms' magnitudes: in floats of so many mantissa bits, by any order of operations, contracted
/// or not, with inputs rounded again.
constexpr double dotRounding(int mantissaBits) {
    double share = 16.0;
    for (int bit = 0; bit <= mantissaBits; ++bit)
        share *= 0.5;
    return share;
}

/// What the dot product may be off by beyond that: products below the smallest float may become 0
/// on the way; below 2^-62 where floats are no more than what GLSL ES 1.00 guarantees
/// (section 4.5.2).
constexpr float dotUnderflow(int mantissaBits) {
    return mantissaBits < 23 ? 0x1p-58f : 1e-36f;
}

/// Tells which side of a batch's planes the lights of a ball are on: 1 or -1 where planeSide()
/// certainly says so for each of them, however it rounds; 0 where not.
class LightFacings {
  public:
    /// The planes of the batch's caps.
    explicit LightFacings(const PlanePairShadow& shadow);

    /// By cap. `mantissaBits`: of the vertex shader's floats.
    void find(const LightBall& ball, int mantissaBits, std::vector<std::int8_t>& facings) const;

  private:
    /// Components in arrays of their own, filled up with zeros to a multiple of the lanes.
    std::vector<float> x_, y_, z_, w_;
    std::size_t count_ = 0;
};

} // namespace edgeshade
