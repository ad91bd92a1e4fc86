#pragma once

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/reading/primitive.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// The matrices that take a skinned vertex from mesh to world space at rest: each joint's world
/// transform times its inverse bind matrix (glTF 2.0, 3.7.3). `worldFromNode` holds every node's
/// transform; `memory` counts what is read. Throws InputError.
std::vector<glm::dmat4> skinMatrices(const GltfDocument& document, int skin,
                                     const std::vector<glm::dmat4>& worldFromNode,
                                     MemoryBudget& memory);

/// The blended matrix of one vertex; the identity where all weights are 0. Throws InputError if a
/// joint is out of range.
glm::dmat4 skinMatrixOf(const Primitive& primitive, std::size_t vertex,
                        const std::vector<glm::dmat4>& matrices, const GltfDocument& document);

} // namespace edgeshade
