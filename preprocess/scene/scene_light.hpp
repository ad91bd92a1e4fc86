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
    std::string name;     ///< its own name; empty: none
    std::string nodeName; ///< the node's name; empty: none
    NodePlace place;      ///< place of the node
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0}; ///< direction in which it shines, of length 1; unused for
                                          ///< a point light
    glm::dvec3 color{1.0};                ///< linear, 0 or more
    double intensity = 1.0;               ///< candela; lux for a directional light; 0 or more
    /// Scene units, above 0; unused for directional lights. Scaled nodes don't scale it.
    double range = std::numeric_limits<double>::infinity();
    /// A spot's angles from its direction, in radians: full light within the inner one, none from
    /// the outer one on. 0 <= inner <= outer, 0 < outer <= pi/2.
    double innerCone = 0.0, outerCone = 0.0;
};

} // namespace edgeshade
