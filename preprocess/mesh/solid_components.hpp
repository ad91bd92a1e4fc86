#pragma once

#include "preprocess/mesh/components.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// By component: 1 where it is the surface of a solid, wound outwards: every edge has two
/// triangles, which run through it opposite ways, no triangles cross, and the volume within is
/// above 0. Its winding number is then 1 within and 0 outside, and a ray that comes from outside
/// meets a front first (docs/method.md, C39). 0 where that is not so, or not beyond doubt: where
/// rounding can't tell, or so many triangles lie within each other's boxes that it would take long.
/// Contacts are no crossings, nor is what rounding can't tell from one.
///
/// mesh: finite positions; edges and components: buildEdges() and findComponents() of it.
/// Some hundred milliseconds for 100,000 triangles.
std::vector<std::uint8_t> solidComponents(const WeldedMesh& mesh, const EdgeList& edges,
                                          const Components& components);

} // namespace edgeshade
