#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/reading/primitive.hpp"
#include "preprocess/scene/node_transform.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// A skin's joints and inverse bind matrices (glTF 2.0, 3.7.3). `placeOf`: the place of every node,
/// by index. `memory` counts what is read. Throws InputError.
std::vector<Joint> readJoints(const GltfDocument& document, int skin,
                              const std::vector<NodePlace>& placeOf, MemoryBudget& memory);

/// The matrices that transform a skinned vertex from mesh to world space at rest: each joint's
/// world transform times its inverse bind matrix. `worldFromNode` holds every node's transform.
std::vector<glm::dmat4> skinMatrices(const GltfDocument& document, int skin,
                                     const std::vector<Joint>& joints,
                                     const std::vector<glm::dmat4>& worldFromNode);

/// Throws InputError if a vertex refers to a joint that the skin lacks.
void requireJoints(const GltfDocument& document, const Primitive& primitive, std::size_t joints);

/// The blended matrix of one vertex.
glm::dmat4 skinMatrixOf(const Primitive& primitive, std::size_t vertex,
                        const std::vector<glm::dmat4>& matrices);

} // namespace edgeshade
