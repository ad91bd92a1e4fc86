#pragma once

#include "preprocess/scene/node_transform.hpp"

#include <glm/glm.hpp>
#include <limits>
#include <string>

namespace edgeshade {

/// A light of the file (KHR_lights_punctual) that a node places, at rest or as posed.
struct SceneLight {
    enum class Kind { directional, point, spot };

    Kind kind = Kind::point;
    std::string name;     ///< its own; empty: none
    std::string nodeName; ///< the node's, likewise
    NodePlace place;      ///< of the node
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0.0, 0.0,
                         -1.0}; ///< where it shines, of length 1; of a point light nothing
    glm::dvec3 color{1.0};      ///< linear, 0 or more
    double intensity = 1.0;     ///< candela, of a directional light lux; 0 or more
    /// Scene units, above 0; directional lights have none. What scales nodes leaves it as it is.
    double range = std::numeric_limits<double>::infinity();
    /// Of a spot, radians from the direction: full within, nothing from there on. 0 <= inner <=
    /// outer, 0 < outer <= pi/2.
    double innerCone = 0.0, outerCone = 0.0;
};

} // namespace edgeshade
