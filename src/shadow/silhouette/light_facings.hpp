#pragma once

#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/shadow/lights/light_ball.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// A bound of the error in the shaders' dot(plane, light), relative to the sum of its terms'
/// magnitudes. It holds for floats of `mantissaBits` mantissa bits, any order of operations,
/// contracted or not, with inputs rounded again.
constexpr double dotRounding(int mantissaBits) {
    double share = 16.0;
    for (int bit = 0; bit <= mantissaBits; ++bit)
        share *= 0.5;
    return share;
}

/// An additional absolute error of the dot product: products below the smallest float may become 0.
/// These are below 2^-62 if floats have only what GLSL ES 1.00 guarantees (section 4.5.2).
constexpr float dotUnderflow(int mantissaBits) {
    return mantissaBits < 23 ? 0x1p-58f : 1e-36f;
}

/// Classifies a batch's planes by the side that the lights of a ball are on: 1 or -1 if planeSide()
/// certainly gives that for each of them, however it rounds; otherwise 0.
class LightFacings {
  public:
    /// Uses the planes of the batch's caps.
    explicit LightFacings(const PlanePairShadow& shadow);

    /// Sets `facings`, one per cap. `mantissaBits`: of the vertex shader's floats.
    void find(const LightBall& ball, int mantissaBits, std::vector<std::int8_t>& facings) const;

  private:
    /// Components in separate arrays, padded with zeros to a multiple of the lanes.
    std::vector<float> x_, y_, z_, w_;
    std::size_t count_ = 0;
};

} // namespace edgeshade
