#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/shadow/view/frustum.hpp"

namespace edgeshade {

/// An orthographic view from straight above that shows all vertices of the scene with a small
/// margin, in a picture with this aspect (width over height). `north`: degrees clockwise, seen from
/// above, from the scene's -Z to its north, which points up in the picture.
Frustum planView(const Scene& scene, double aspect, double north);

} // namespace edgeshade
