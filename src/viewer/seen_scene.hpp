#pragma once

#include "src/shadow/view/frustum.hpp"

namespace edgeshade::viewer {

/// The visible scene apart from its lights; counts of masks hold for one such view.
struct SeenScene {
    Frustum frustum;
    glm::ivec2 size{0};
    bool ground = false, culls = false;
    std::size_t pose = 0; ///< counts all other movements and changes

    bool operator==(const SeenScene&) const = default;
};

} // namespace edgeshade::viewer
