#pragma once

#include "src/shadow/lights/light.hpp"
#include "src/shadow/view/frustum.hpp"

#include <vector>

namespace edgeshade::test {

/// The content of a pixel, by ray casting.
enum class Answer : std::uint8_t { nothing, shadow, lit };

/// The lit mask of a small scene, by casting rays at every triangle in double; lit as in
/// docs/method.md, C30. `castMasked`: MASK and BLEND triangles block light; MASK surfaces are
/// visible where their factor's alpha reaches the cutoff, BLEND ones never. Surfaces nearer than
/// `near` along the viewing direction are invisible but cast, as do backs that the scene culls.
/// Rows top to bottom.
std::vector<Answer> castMask(const Scene& scene, const Frustum& frustum, const Light& light,
                             int width, int height, double near, bool castMasked = false);
std::vector<Answer> castMask(const Scene& scene, const Camera& camera, const Light& light,
                             int width, int height, double near, bool castMasked = false);

/// Whether all 3x3 pixels around a pixel have its answer.
bool isFlat(const std::vector<Answer>& answers, int width, int height, int x, int y);

} // namespace edgeshade::test
