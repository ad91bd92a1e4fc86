#pragma once

#include "src/rays/lit_rays.hpp"

namespace edgeshade::test {

/// Whether a sun lights a point, by docs/method.md, C30: every triangle is tested in rational
/// numbers, by other formulas than those of src/rays, and no tree is used. Of C47 only the light's
/// angle to the surface is computed in doubles, as C47 says.
bool isLitRationally(const Scene& scene, const std::vector<rays::SurfaceTriangle>& triangles,
                     const rays::SurfacePoint& point, const glm::dvec3& direction);

/// The point that a SurfacePoint means, each coordinate rounded once.
glm::dvec3 placeRationally(const std::vector<rays::SurfaceTriangle>& triangles,
                           const rays::SurfacePoint& point);

} // namespace edgeshade::test
