#include "preprocess/reading/pieces.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"
#include "preprocess/reading/animation_reading.hpp"
#include "preprocess/reading/instances.hpp"
#include "preprocess/reading/skin.hpp"
#include "preprocess/reading/variants.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace edgeshade {
namespace {

std::vector<double> morphWeights(const GltfDocument& document, const tinygltf::Node& node) {
    return node.weights.empty() ? document.model->meshes[node.mesh].weights : node.weights;
}

/// A skin that nodes use, read once.
class Skins {
  public:
    Skins(const GltfDocument& document, const NodeWalk& walk, MemoryBudget& memory)
        : document_(document), walk_(walk), memory_(memory) {
        for (const glm::dmat4& worldFromNode : walk.worldFromNode)
            placeOf_.push_back({-1, worldFromNode});
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

/// Counts what pieces become in batches, so that a mesh of many nodes is refused before it is
/// repeated.
class PieceCounter {
  public:
    PieceCounter(const GltfDocument& document, MemoryBudget& memory)
        : document_(document), memory_(memory) {}

    /// `instances`: how often the node has the primitive.
    void count(const Primitive& primitive, int node, std::uint64_t instances) {
        const std::uint64_t most = memory_.limits().triangles;
        triangles_ += instances * (primitive.indices.size() / 3);
        const std::string field = document_.where("nodes[" + std::to_string(node) + "]");
        if (triangles_ > most)
            throw InputError(field + " brings the scene to " + std::to_string(triangles_) +
                             " triangles, but the limit is " + std::to_string(most) + ".");
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

    /// What a piece that deforms keeps of its primitive: vertices, influences and targets.
    void countSource(const Primitive& primitive, int node) {
        const std::string field = document_.where("nodes[" + std::to_string(node) + "]");
        const std::size_t vertices = primitive.positions.size();
        memory_.take(vertices, 2 * sizeof(glm::vec3) + sizeof(glm::vec4), field);
        memory_.take(primitive.influences.all.size(), sizeof(Influence), field);
        memory_.take(primitive.targets.size() * vertices, 3 * sizeof(glm::vec3), field);
    }

  private:
    const GltfDocument& document_;
    MemoryBudget& memory_;
    std::uint64_t triangles_ = 0;
};

/// Reads the primitives of meshes, each once for what its morph targets become.
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

} // namespace

PiecesByMover gatherPieces(const GltfDocument& document, const NodeWalk& walk,
                           const std::optional<std::size_t>& variant, Scene& scene) {
    MemoryBudget memory = document.memory;
    PieceCounter counter(document, memory);
    PiecesByMover pieces;
    Skins skins(document, walk, memory);
    Primitives read(document, variant, scene, memory);
    const std::set<int> morphing = morphingNodes(document);
    for (const PlacedNode& visit : walk.nodes) {
        const tinygltf::Node& node = document.model->nodes[visit.node];
        if (node.mesh < 0 || !visit.visible) continue;
        if (static_cast<std::size_t>(node.mesh) >= document.model->meshes.size())
            throw InputError(document.where("nodes[") + std::to_string(visit.node) + "].mesh is " +
                             std::to_string(node.mesh) + ", but there are " +
                             std::to_string(document.model->meshes.size()) + " meshes.");
        const bool morphs = morphing.contains(visit.node);
        std::vector<double> weights = morphWeights(document, node);
        const auto& primitives =
            read.of(node.mesh, {morphs, morphs ? std::vector<double>() : weights});
        if (morphs) weights.resize(morphTargetCount(document, node.mesh));
        const std::shared_ptr<const Skin> skin = node.skin >= 0 ? skins.of(node.skin) : nullptr;
        const auto isSkinned = [&skin](const Primitive& primitive) {
            return skin && !primitive.influences.empty();
        };
        const std::size_t count = instanceCount(document, visit.node);
        for (const auto& primitive : primitives)
            counter.count(*primitive, visit.node, isSkinned(*primitive) ? 1 : count);
        const std::vector<glm::dmat4> instances = readInstances(document, visit.node, memory);
        for (const auto& primitive : primitives) {
            if (primitive->indices.empty()) continue;
            Piece piece = {primitive, materialOf(document, *primitive, scene.materials),
                           visit.place.animatedFromNode, nullptr, visit.node};
            const bool moves = morphs && !primitive->targets.empty();
            if (moves) piece.restWeights = weights;
            if (moves || (isSkinned(*primitive) && skin->moves))
                counter.countSource(*primitive, visit.node);
            // A skin's joints place it in the world; its own node's transforms do not count.
            if (isSkinned(*primitive)) {
                requireJoints(document, *primitive, skin->joints.size());
                piece.skin = skin;
                Mover mover;
                mover.deforms = skin->moves || moves;
                if (mover.deforms) mover.skin = node.skin;
                pieces[mover].push_back(std::move(piece));
                continue;
            }
            const Mover mover = {moves, visit.place.animatedNode, -1, moves ? visit.node : -1};
            for (const glm::dmat4& nodeFromInstance : instances) {
                piece.batchFromMesh = visit.place.animatedFromNode * nodeFromInstance;
                pieces[mover].push_back(piece);
            }
        }
    }
    return pieces;
}

glm::dmat4 matrixOf(const Piece& piece, std::size_t vertex) {
    return piece.skin ? skinMatrixOf(*piece.primitive, vertex, piece.skin->worldFromMesh)
                      : piece.batchFromMesh;
}

} // namespace edgeshade
