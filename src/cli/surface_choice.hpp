#pragma once

#include "src/hours/surfaces/world_triangles.hpp"

#include <string>
#include <vector>

namespace edgeshade {
struct GltfDocument;
}

namespace edgeshade::cli {

/// The surfaces of nodes with one of the names, or beneath such a node, and of materials with one
/// of the names; no names: all. Nameless nodes and materials have titles, such as "nodes[3]".
/// Throws Error(usage) naming the option and a name that the file lacks.
hours::SurfaceChoice surfaceChoice(const GltfDocument& document,
                                   const std::vector<std::string>& nodes,
                                   const std::vector<std::string>& materials);

} // namespace edgeshade::cli
