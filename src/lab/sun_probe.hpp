#pragma once

#include "src/lab/oracle.hpp"
#include "src/scene/load.hpp"

#include <optional>
#include <span>
#include <vector>

namespace edgeshade::lab {

/// Which of the directions, in the world, a point of it sees: no caster lies on the way, and its
/// normal, which is not 0, faces there; without one it faces everywhere. The surface that it lies
/// on doesn't block it, nor do triangles in that plane; with a normal, a surface that it touches
/// but doesn't face along does. Throws Error as Oracle does.
std::vector<bool> seenFrom(const LoadedScene& loaded, const AlphaLookup& alpha,
                           const glm::dvec3& point, const std::optional<glm::dvec3>& normal,
                           std::span<const glm::dvec3> directions);

} // namespace edgeshade::lab
