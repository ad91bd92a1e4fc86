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

/// The facings that a light finds on its way through a batch's space, and how much farther it may
/// go until those of a run of neighbouring caps may change (docs/method.md, C48).
struct FollowedFacings {
    static constexpr std::size_t run = 32; ///< caps

    std::vector<std::int8_t> facings;     ///< as of LightFacings::find()
    std::vector<double> holdsUntil;       ///< by run: its facings hold while `way` is less
    std::vector<std::uint32_t> foundAt;   ///< by run: the last look that tested it
    std::vector<std::uint32_t> changedAt; ///< by run: the last look that found other facings
    double way = 0.0;                     ///< at least the length of the light's way up to here
    float margin = 0.0f;                  ///< of the last look
    glm::vec4 light{0.0f};                ///< of the last look
    std::uint32_t look = 0;               ///< number of looks
};

/// Classifies a batch's planes by the side that the lights of a ball are on: 1 or -1 if planeSide()
/// certainly gives that for each of them, however it rounds; otherwise 0.
class LightFacings {
  public:
    /// Uses the planes of the batch's caps.
    explicit LightFacings(const PlanePairShadow& shadow);

    /// Sets `facings`, one per cap. `mantissaBits`: of the vertex shader's floats.
    void find(const LightBall& ball, int mantissaBits, std::vector<std::int8_t>& facings) const;

    /// Sets `followed.facings` to the same, for the next place of a light on its way; skips the
    /// runs that its way can't have changed. `followed`: new, or of this batch's last look.
    void follow(const LightBall& ball, int mantissaBits, FollowedFacings& followed) const;

  private:
    std::size_t runCount() const {
        return (count_ + FollowedFacings::run - 1) / FollowedFacings::run;
    }

    /// Components in separate arrays, padded with the last plane to a multiple of a run.
    std::vector<float> x_, y_, z_, w_;
    std::size_t count_ = 0;
};

} // namespace edgeshade
