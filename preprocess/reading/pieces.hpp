#pragma once

#include "preprocess/reading/node_walk.hpp"
#include "preprocess/reading/primitive.hpp"
#include "preprocess/scene/instance_choice.hpp"

#include <compare>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace edgeshade {

/// A skin, with its joints at rest.
struct Skin {
    std::vector<Joint> joints;
    std::vector<glm::dmat4> worldFromMesh; ///< by joint
    bool moves = false;                    ///< an animation can move a joint
};

/// A primitive at one place in a batch.
struct Piece {
    std::shared_ptr<const Primitive> primitive;
    std::size_t material = 0;
    glm::dmat4 batchFromMesh{1.0};    ///< unused by skinned pieces
    std::shared_ptr<const Skin> skin; ///< null: not skinned
    int node = -1;
    std::vector<double> restWeights = {}; ///< of the primitive's morph targets
    NodePlace place = {};                 ///< place of a skinned piece's node
    bool turnedOver = false; ///< a skinned piece's triangles are turned over, and nothing else
                             ///< corrects them
};

/// Everything that moves the pieces of a batch together.
struct Mover {
    bool deforms = false;
    int animatedNode = -1; ///< -1: none
    int skin = -1;         ///< the skin that deforms them; -1: none
    int morphing = -1;     ///< the node whose morph weights deform them; -1: none
    int scaledNode = -1;   ///< for joints: see Handedness
    bool mirrored = false; ///< for joints: see Handedness

    auto operator<=>(const Mover&) const = default;
};

/// The pieces of each batch: static ones first, then those that nodes move, then deforming ones.
using PiecesByMover = std::map<Mover, std::vector<Piece>>;

/// A mesh that is stored once.
struct SharedMesh {
    std::vector<Piece> pieces;     ///< in the mesh's own space
    std::vector<NodePlace> places; ///< its places: `animatedFromNode` is animatedFromMesh
    std::vector<int> nodes;        ///< the node that has the mesh, for each place
};

/// All pieces of visible nodes.
struct GatheredPieces {
    PiecesByMover byMover;
    std::vector<SharedMesh> shared; ///< in the order of their first places
};

/// Gathers the pieces of all visible nodes, in the walk's order, with the materials of `variant`;
/// warnings go to the scene's. Not shared are meshes that joints or weights deform, and places that
/// flatten them to less than a millionth. Throws InputError, also beyond the limits that the
/// document was read with.
GatheredPieces gatherPieces(const GltfDocument& document, const NodeWalk& walk,
                            const std::optional<std::size_t>& variant, InstanceChoice instances,
                            Scene& scene);

/// The matrix from a vertex to its batch at rest; to the world for skinned pieces.
glm::dmat4 matrixOf(const Piece& piece, std::size_t vertex);

} // namespace edgeshade
