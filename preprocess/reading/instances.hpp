#pragma once

#include "preprocess/gltf/gltf_document.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// How often the mesh of a node stands in it: once, or as EXT_mesh_gpu_instancing says, once where
/// it has no attributes. Throws InputError where its accessors do not agree.
std::size_t instanceCount(const GltfDocument& document, int node);

/// Warns of a node whose EXT_mesh_gpu_instancing has no attributes.
void warnOfNoAttributes(const GltfDocument& document, int node, Warnings& warnings);

/// Where each of them stands: nodeFromInstance. Counted in `memory`. Throws InputError, also for
/// what is no place.
std::vector<glm::dmat4> readInstances(const GltfDocument& document, int node, MemoryBudget& memory);

} // namespace edgeshade
