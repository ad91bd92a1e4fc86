#pragma once

#include "preprocess/mesh/components.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// For each component, 1 if it is the surface of a solid, wound outwards. Every edge has two
/// triangles, in opposite directions, no triangles cross, and the enclosed volume is above 0. Its
/// winding number is then 1 inside and 0 outside, and a ray from outside meets a front first
/// (docs/method.md, C39).
///
/// 0 if it is not a solid, or not certainly: rounding can't tell, or so many triangles lie within
/// each other's boxes that the test would take long. Contacts aren't crossings, and neither is a
/// crossing too small to tell from one.
///
/// mesh: finite positions; edges and components: its buildEdges() and findComponents(). Takes a few
/// hundred milliseconds for 100,000 triangles.
std::vector<std::uint8_t> solidComponents(const WeldedMesh& mesh, const EdgeList& edges,
                                          const Components& components);

} // namespace edgeshade
