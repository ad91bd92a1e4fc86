#pragma once

#include "preprocess/scene/node_transform.hpp"

#include <glm/glm.hpp>
#include <string>

namespace edgeshade {

/// A camera of the file that a node places, at rest or as posed. How wide it sees, the picture
/// says; where its depth range begins and ends is not taken from the file.
struct SceneCamera {
    std::string name;     ///< its own; empty: none. Neither need be the only one of that name
    std::string nodeName; ///< the node's, likewise
    NodePlace place;      ///< of the node
    glm::dmat4 worldFromCamera{1.0}; ///< rigid: x right, y up, looking along -z
    bool orthographic = false;
    /// The vertical field of view in radians, above 0 and below pi; of an orthographic camera the
    /// picture's height in scene units, above 0.
    double height = 1.0;
};

} // namespace edgeshade
