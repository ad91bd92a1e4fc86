#pragma once

#include "preprocess/scene/node_transform.hpp"

#include <glm/glm.hpp>
#include <string>

namespace edgeshade {

/// A camera of the file that a node places, at rest or as posed. The picture's aspect gives its
/// horizontal field of view, and its depth range isn't taken from the file.
struct SceneCamera {
    std::string name;                ///< its own name, which need not be unique; empty: none
    std::string nodeName;            ///< the node's name, which need not be unique; empty: none
    NodePlace place;                 ///< place of the node
    glm::dmat4 worldFromCamera{1.0}; ///< rigid: x right, y up, looking along -z
    bool orthographic = false;
    /// For perspective the vertical field of view in radians, above 0 and below pi. For an
    /// orthographic camera the picture's height in scene units, above 0.
    double height = 1.0;
};

} // namespace edgeshade
