#include "preprocess/reading/pieces.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/longest_axis.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"
#include "preprocess/reading/animation_reading.hpp"
#include "preprocess/reading/instances.hpp"
#include "preprocess/reading/skin.hpp"
#include "preprocess/reading/variants.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace edgeshade {
namespace {

std::vector<double> morphWeights(const GltfDocument& document, const tinygltf::Node& node) {
    return node.weights.empty() ? document.model->meshes[node.mesh].weights : node.weights;
}

/// The skins that nodes use, each read once.
class Skins {
  public:
    Skins(const GltfDocument& document, const NodeWalk& walk, MemoryBudget& memory)
        : document_(document), walk_(walk), memory_(memory) {
        for (const glm::dmat4& worldFromNode : walk.worldFromNode)
            placeOf_.push_back({-1, worldFromNode, glm::dmat4(1.0)});
        for (const PlacedNode& node : walk.nodes)
            if (node.place.animatedNode >= 0) placeOf_[node.node] = node.place;
    }

    std::shared_ptr<const Skin> of(int index) {
        auto& known = known_[index];
        if (known) return known;
        Skin skin{readJoints(document_, index, placeOf_, memory_), {}};
        skin.worldFromMesh = skinMatrices(document_, index, skin.joints, walk_.worldFromNode);
        skin.moves = std::any_of(skin.joints.begin(), skin.joints.end(),
                                 [](const Joint& joint) { return joint.place.animatedNode >= 0; });
        return known = std::make_shared<const Skin>(std::move(skin));
    }

  private:
    const GltfDocument& document_;
    const NodeWalk& walk_;
    MemoryBudget& memory_;
    std::vector<NodePlace> placeOf_; ///< by node
    std::map<int, std::shared_ptr<const Skin>> known_;
};

std::size_t materialOf(const GltfDocument& document, const Primitive& primitive,
                       const std::vector<Material>& materials) {
    const std::size_t defaultMaterial = materials.size() - 1;
    if (primitive.material < 0) return defaultMaterial;
    if (static_cast<std::size_t>(primitive.material) >= defaultMaterial)
        throw InputError(document.where("meshes: material ") + std::to_string(primitive.material) +
                         " does not exist; there are " + std::to_string(defaultMaterial) + ".");
    return static_cast<std::size_t>(primitive.material);
}

/// Counts the memory of pieces in batches, so that a mesh with many nodes is refused before it is
/// repeated.
class PieceCounter {
  public:
    PieceCounter(const GltfDocument& document, MemoryBudget& memory)
        : document_(document), memory_(memory) {}

    /// `instances`: of the primitive at the node.
    void count(const Primitive& primitive, int node, std::uint64_t instances) {
        addTriangles(primitive.indices.size() / 3, node, instances);
        countVertices(primitive, node, instances);
    }

    /// Counts what a shared mesh stores once.
    void countVertices(const Primitive& primitive, int node, std::uint64_t instances = 1) {
        const std::string field = document_.where("nodes[" + std::to_string(node) + "]");
        const std::size_t vertices =
            primitive.normals.empty() ? primitive.indices.size() : primitive.positions.size();
        constexpr std::size_t plainBytes =
            2 * sizeof(glm::vec3) + sizeof(glm::vec2) + sizeof(glm::vec4);
        std::size_t bytesPerVertex = plainBytes;
        for (std::size_t channel = 1; channel < primitive.texcoords.size(); ++channel)
            if (!primitive.texcoords[channel].empty()) bytesPerVertex += sizeof(glm::vec2);
        if (!primitive.tangents.empty()) bytesPerVertex += sizeof(glm::vec4);
        memory_.take(instances, sizeof(Piece), field);
        memory_.take(instances * vertices, bytesPerVertex, field);
        memory_.take(instances * primitive.indices.size(), sizeof(std::uint32_t), field);
    }

    /// Counts the places of a mesh of `triangles` triangles, one batch each.
    void countPlaces(std::size_t triangles, int node, std::uint64_t places) {
        addTriangles(triangles, node, places);
        memory_.take(places, sizeof(Batch), document_.where("nodes[" + std::to_string(node) + "]"));
    }

    /// Counts the primitive's data that a deforming piece keeps: vertices, influences and targets.
    void countSource(const Primitive& primitive, int node) {
        const std::string field = document_.where("nodes[" + std::to_string(node) + "]");
        const std::size_t vertices = primitive.positions.size();
        memory_.take(vertices, 2 * sizeof(glm::vec3) + sizeof(glm::vec4), field);
        memory_.take(primitive.influences.all.size(), sizeof(Influence), field);
        memory_.take(primitive.targets.size() * vertices, 3 * sizeof(glm::vec3), field);
    }

  private:
    void addTriangles(std::size_t triangles, int node, std::uint64_t times) {
        const std::uint64_t most = memory_.limits().triangles;
        triangles_ += times * triangles;
        if (triangles_ > most)
            throw InputError(document_.where("nodes[" + std::to_string(node) + "]") +
                             " brings the scene to " + std::to_string(triangles_) +
                             " triangles, but the limit is " + std::to_string(most) + ".");
    }

    const GltfDocument& document_;
    MemoryBudget& memory_;
    std::uint64_t triangles_ = 0;
};

/// Reads primitives of meshes, once for each use of their morph targets.
class Primitives {
  public:
    Primitives(const GltfDocument& document, const std::optional<std::size_t>& variant,
               Scene& scene, MemoryBudget& memory)
        : document_(document), variant_(variant), scene_(scene), memory_(memory) {}

    const std::vector<std::shared_ptr<Primitive>>& of(int mesh, const MorphUse& morphs) {
        auto& primitives = read_[{mesh, morphs.kept, morphs.weights}];
        const auto& sources = document_.model->meshes[mesh].primitives;
        for (std::size_t p = primitives.size(); p < sources.size(); ++p) {
            const auto index = static_cast<std::size_t>(mesh);
            const int material = materialInVariant(document_, index, p, variant_, scene_.warnings);
            const bool known =
                material >= 0 && static_cast<std::size_t>(material) < scene_.materials.size();
            primitives.push_back(std::make_shared<Primitive>(readPrimitive(
                document_, index, p, morphs, known ? scene_.materials[material] : Material(),
                scene_.warnings, memory_)));
            primitives.back()->material = material;
        }
        return primitives;
    }

  private:
    const GltfDocument& document_;
    const std::optional<std::size_t> variant_;
    Scene& scene_;
    MemoryBudget& memory_;
    std::map<std::tuple<int, bool, std::vector<double>>, std::vector<std::shared_ptr<Primitive>>>
        read_;
};

/// A node's mesh, read.
struct MeshUse {
    const PlacedNode* visit = nullptr;
    const std::vector<std::shared_ptr<Primitive>>* primitives = nullptr;
    std::vector<double> weights; ///< of morph targets
    bool morphs = false;         ///< an animation can move them
    std::shared_ptr<const Skin> skin;

    bool isRigid() const { return !morphs && !skin; }
    std::size_t triangles() const {
        std::size_t count = 0;
        for (const auto& primitive : *primitives)
            count += primitive->indices.size() / 3;
        return count;
    }
};

/// Whether a mesh can be drawn from its own space: the transform doesn't flatten it.
bool isWellPlaced(const glm::dmat4& animatedFromMesh) {
    constexpr double leastShare = 1e-6;
    const double longest = longestAxis(animatedFromMesh);
    return std::abs(glm::determinant(glm::dmat3(animatedFromMesh))) >=
               leastShare * longest * longest * longest &&
           longest > std::numeric_limits<float>::min() &&
           longest < std::numeric_limits<float>::max();
}

/// Gathers the pieces of meshes.
class PieceGatherer {
  public:
    PieceGatherer(const GltfDocument& document, const NodeWalk& walk,
                  const std::optional<std::size_t>& variant, InstanceChoice instances, Scene& scene)
        : document_(document), choice_(instances), scene_(scene), memory_(document.memory),
          counter_(document, memory_), skins_(document, walk, memory_),
          read_(document, variant, scene, memory_), morphing_(morphingNodes(document)) {}

    /// Reads a node's mesh, if it has one and is visible.
    void read(const PlacedNode& visit) {
        const tinygltf::Node& node = document_.model->nodes[visit.node];
        if (node.mesh < 0 || !visit.visible) return;
        if (static_cast<std::size_t>(node.mesh) >= document_.model->meshes.size())
            throw InputError(document_.where("nodes[") + std::to_string(visit.node) + "].mesh is " +
                             std::to_string(node.mesh) + ", but there are " +
                             std::to_string(document_.model->meshes.size()) + " meshes.");
        warnOfNoAttributes(document_, visit.node, scene_.warnings);
        MeshUse& use = uses_.emplace_back();
        use.visit = &visit;
        use.morphs = morphing_.contains(visit.node);
        use.weights = morphWeights(document_, node);
        use.primitives =
            &read_.of(node.mesh, {use.morphs, use.morphs ? std::vector<double>() : use.weights});
        if (use.morphs) use.weights.resize(morphTargetCount(document_, node.mesh));
        if (node.skin >= 0) use.skin = skins_.of(node.skin);
        if (use.isRigid()) placesOf_[use.primitives] += instanceCount(document_, visit.node);
    }

    GatheredPieces gathered() {
        for (const MeshUse& use : uses_)
            if (use.isRigid() &&
                sharingPays(choice_, use.triangles(), placesOf_.at(use.primitives)))
                addShared(use);
            else
                addRepeated(use);
        return std::move(gathered_);
    }

  private:
    std::vector<Piece> piecesOf(const MeshUse& use, const glm::dmat4& batchFromMesh) const {
        std::vector<Piece> pieces;
        for (const auto& primitive : *use.primitives)
            if (!primitive->indices.empty())
                pieces.push_back({primitive, materialOf(document_, *primitive, scene_.materials),
                                  batchFromMesh, nullptr, use.visit->node});
        return pieces;
    }

    void addShared(const MeshUse& use) {
        const auto [at, isNew] = sharedOf_.try_emplace(use.primitives, gathered_.shared.size());
        if (isNew) {
            for (const auto& primitive : *use.primitives)
                counter_.countVertices(*primitive, use.visit->node);
            gathered_.shared.push_back({piecesOf(use, glm::dmat4(1.0)), {}, {}});
        }
        counter_.countPlaces(use.triangles(), use.visit->node,
                             instanceCount(document_, use.visit->node));
        const NodePlace& place = use.visit->place;
        for (const glm::dmat4& nodeFromInstance :
             readInstances(document_, use.visit->node, memory_)) {
            const glm::dmat4 animatedFromMesh = place.animatedFromNode * nodeFromInstance;
            if (isWellPlaced(animatedFromMesh)) {
                gathered_.shared[at->second].places.push_back(
                    {place.animatedNode, animatedFromMesh, glm::dmat4(1.0)});
                gathered_.shared[at->second].nodes.push_back(use.visit->node);
                continue;
            }
            for (Piece& piece : piecesOf(use, animatedFromMesh)) {
                counter_.countVertices(*piece.primitive, use.visit->node);
                gathered_.byMover[{false, place.animatedNode}].push_back(std::move(piece));
            }
        }
    }

    void addRepeated(const MeshUse& use) {
        const PlacedNode& visit = *use.visit;
        const auto isSkinned = [&use](const Primitive& primitive) {
            return use.skin && !primitive.influences.empty();
        };
        const std::size_t count = instanceCount(document_, visit.node);
        for (const auto& primitive : *use.primitives)
            counter_.count(*primitive, visit.node, isSkinned(*primitive) ? 1 : count);
        const std::vector<glm::dmat4> instances = readInstances(document_, visit.node, memory_);
        for (Piece& piece : piecesOf(use, visit.place.animatedFromNode)) {
            const Primitive& primitive = *piece.primitive;
            const bool moves = use.morphs && !primitive.targets.empty();
            if (moves) piece.restWeights = use.weights;
            const bool deforms =
                moves || (isSkinned(primitive) && (use.skin->moves || visit.hand.scaledNode >= 0));
            if (deforms) counter_.countSource(primitive, visit.node);
            // Joints place a skin in the world. Of its own node's transforms, only mirroring
            // matters.
            if (isSkinned(primitive)) {
                requireJoints(document_, primitive, use.skin->joints.size());
                piece.skin = use.skin;
                piece.place = visit.place;
                piece.turnedOver = !deforms && visit.hand.atRest;
                Mover mover;
                mover.deforms = deforms;
                if (deforms) {
                    mover.skin = document_.model->nodes[visit.node].skin;
                    mover.scaledNode = visit.hand.scaledNode;
                    mover.mirrored = visit.hand.mirrored;
                }
                gathered_.byMover[mover].push_back(std::move(piece));
                continue;
            }
            const Mover mover = {moves, visit.place.animatedNode, -1, moves ? visit.node : -1};
            for (const glm::dmat4& nodeFromInstance : instances) {
                piece.batchFromMesh = visit.place.animatedFromNode * nodeFromInstance;
                gathered_.byMover[mover].push_back(piece);
            }
        }
    }

    using PrimitivesOfMesh = const std::vector<std::shared_ptr<Primitive>>*;

    const GltfDocument& document_;
    const InstanceChoice choice_;
    Scene& scene_;
    MemoryBudget memory_;
    PieceCounter counter_;
    Skins skins_;
    Primitives read_;
    const std::set<int> morphing_;
    std::vector<MeshUse> uses_;
    std::map<PrimitivesOfMesh, std::size_t> placesOf_; ///< places of rigid meshes
    std::map<PrimitivesOfMesh, std::size_t> sharedOf_; ///< index in GatheredPieces::shared
    GatheredPieces gathered_;
};

} // namespace

GatheredPieces gatherPieces(const GltfDocument& document, const NodeWalk& walk,
                            const std::optional<std::size_t>& variant, InstanceChoice instances,
                            Scene& scene) {
    PieceGatherer gatherer(document, walk, variant, instances, scene);
    for (const PlacedNode& visit : walk.nodes)
        gatherer.read(visit);
    return gatherer.gathered();
}

glm::dmat4 matrixOf(const Piece& piece, std::size_t vertex) {
    return piece.skin ? skinMatrixOf(*piece.primitive, vertex, piece.skin->worldFromMesh)
                      : piece.batchFromMesh;
}

} // namespace edgeshade
