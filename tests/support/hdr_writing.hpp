#pragma once

#include "preprocess/base/file_io.hpp"

#include <functional>
#include <glm/glm.hpp>

namespace edgeshade::test {

/// A Radiance picture (.hdr) in the form of stb_image_write, run-length encoded from 8 pixels per
/// row.
Bytes hdrOf(int width, int height, const std::function<glm::vec3(int x, int y)>& pixel);

/// An equirectangular one. `radiance` gets directions of unit length; the picture's middle column
/// is -Z, its quarters are -X and +X.
Bytes panoramaOf(int width, int height,
                 const std::function<glm::vec3(const glm::vec3& direction)>& radiance);

} // namespace edgeshade::test
