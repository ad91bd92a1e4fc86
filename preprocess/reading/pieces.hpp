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

/// A skin, and where it has its joints at rest.
struct Skin {
    std::vector<Joint> joints;
    std::vector<glm::dmat4> worldFromMesh; ///< by joint
    bool moves = false;                    ///< an animation can move a joint
};

/// A primitive at one place in a batch.
struct Piece {
    std::shared_ptr<const Primitive> primitive;
    std::size_t material = 0;
    glm::dmat4 batchFromMesh{1.0};    ///< not used by a skinned piece
    std::shared_ptr<const Skin> skin; ///< null: not skinned
    int node = -1;
    std::vector<double> restWeights = {}; ///< of the primitive's morph targets
    NodePlace place = {};                 ///< of a skinned piece's node
    bool turnedOver = false; ///< a skinned piece's triangles are, and nothing else will see to it
};

/// What moves the pieces of a batch together.
struct Mover {
    bool deforms = false;
    int animatedNode = -1; ///< -1: none
    int skin = -1;         ///< that deforms them
    int morphing = -1;     ///< node whose morph weights do
    int scaledNode = -1;   ///< of what joints deform, see Handedness
    bool mirrored = false; ///< likewise

    auto operator<=>(const Mover&) const = default;
};

/// The pieces of each batch: static ones come first, then what nodes move, then what deforms.
using PiecesByMover = std::map<Mover, std::vector<Piece>>;

/// A mesh that is kept once.
struct SharedMesh {
    std::vector<Piece> pieces;     ///< in the mesh's own space
    std::vector<NodePlace> places; ///< where it stands: `animatedFromNode` is animatedFromMesh
    std::vector<int> nodes;        ///< whose mesh it is there, a node each
};

/// All that visible nodes have.
struct GatheredPieces {
    PiecesByMover byMover;
    std::vector<SharedMesh> shared; ///< in the order of their first places
};

/// Gathers the pieces of all visible nodes, in the walk's order, with the materials of `variant`;
/// warnings go to the scene's. A mesh that joints or weights deform is never shared, nor is a place
/// that flattens it to less than a millionth. Throws InputError, also for what passes the limits
/// that the document was read with.
GatheredPieces gatherPieces(const GltfDocument& document, const NodeWalk& walk,
                            const std::optional<std::size_t>& variant, InstanceChoice instances,
                            Scene& scene);

/// What takes a vertex to its batch at rest; to the world where joints place it.
glm::dmat4 matrixOf(const Piece& piece, std::size_t vertex);

} // namespace edgeshade
