#pragma once

#include "src/shadow/view/frustum.hpp"

namespace edgeshade::viewer {

/// What is seen of a scene, whatever lights it: counts of masks are of one such view.
struct SeenScene {
    Frustum frustum;
    glm::ivec2 size{0};
    bool ground = false, culls = false;
    std::size_t pose = 0; ///< counts whatever else has moved or changed

    bool operator==(const SeenScene&) const = default;
};

} // namespace edgeshade::viewer
