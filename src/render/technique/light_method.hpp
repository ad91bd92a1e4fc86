#pragma once

#include <cstddef>
#include <string>

namespace edgeshade {

/// How a light's shadows are made, for reports.
struct LightMethod {
    std::string method;    ///< as in --shadows
    std::string rule;      ///< the rule of ShadowPolicy that chose it
    std::string why;       ///< a clause; for a map or planes, a description; empty: the user
                           ///< requested it
    double buildMs = 0.0;  ///< CPU time to build its primitive map or the scene's planes
    std::size_t bytes = 0; ///< on the GPU; lights of one kind share a shadow map
};

} // namespace edgeshade
