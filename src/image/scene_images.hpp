#pragma once

#include "src/image/image.hpp"

#include <map>
#include <memory>

namespace edgeshade {

/// Decoded images by their index in glTF.
using SceneImages = std::map<int, std::shared_ptr<const Image>>;

} // namespace edgeshade
