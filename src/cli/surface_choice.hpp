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
///
/// `windows`: names of nodes or materials; empty: all. A surface that is chosen by those of nodes
/// and materials is a window if one of these names is that of its node, or of a node above it, or
/// of its material.
hours::SurfaceChoice surfaceChoice(const GltfDocument& document,
                                   const std::vector<std::string>& nodes,
                                   const std::vector<std::string>& materials,
                                   const std::vector<std::string>& windows);

} // namespace edgeshade::cli
