#pragma once

#include "preprocess/gltf/gltf_document.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// The number of times that a node's mesh is drawn: by EXT_mesh_gpu_instancing, or once without it
/// or without attributes. Throws InputError if its accessors disagree.
std::size_t instanceCount(const GltfDocument& document, int node);

/// Warns of a node whose EXT_mesh_gpu_instancing has no attributes.
void warnOfNoAttributes(const GltfDocument& document, int node, Warnings& warnings);

/// The transforms of the instances, nodeFromInstance. Counted in `memory`. Throws InputError, also
/// for an invalid transform.
std::vector<glm::dmat4> readInstances(const GltfDocument& document, int node, MemoryBudget& memory);

} // namespace edgeshade
