#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "src/gl/headless_context.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"

#include <set>
#include <string>

namespace edgeshade::test {

inline constexpr int hostWidth = 240, hostHeight = 180;

/// eglGetProcAddress().
void* eglLookUp(const char* name);
/// The same for a context without vertex array objects.
void* lookUpWithoutArrays(const char* name);

Matrix16 numbersOf(const glm::dmat4& matrix);
MaskMesh meshOf(const Geometry& geometry); ///< seen from both sides
MaskView viewOf(const Camera& camera);
MaskLight hostLight(const Light& light);

Light spot();                                   ///< above yard()
const Geometry& geometryOf(const Scene& scene); ///< the first batch's

/// RGBA, rows bottom to top.
std::vector<std::uint8_t> readTexture(unsigned texture);

/// One byte per pixel, rows top to bottom: a light's channel.
std::vector<std::uint8_t> readMask(const ShadowMasks& masks, std::size_t light);

/// The same from `render --mask`, 255 where there is no surface.
std::vector<std::uint8_t> renderedMask(const Scene& scene, const Camera& camera, const Light& light,
                                       const SceneImages& images = {}, bool castMasked = false);

} // namespace edgeshade::test
