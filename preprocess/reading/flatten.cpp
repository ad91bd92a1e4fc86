#include "preprocess/reading/flatten.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"
#include "preprocess/mesh/weld.hpp"
#include "preprocess/reading/camera_reading.hpp"
#include "preprocess/reading/instances.hpp"
#include "preprocess/reading/light_reading.hpp"
#include "preprocess/reading/material_reading.hpp"
#include "preprocess/reading/node_walk.hpp"
#include "preprocess/reading/primitive.hpp"
#include "preprocess/reading/skin.hpp"
#include "preprocess/reading/variants.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <memory>

namespace edgeshade {
namespace {

/// A primitive at one place in a batch.
struct Piece {
    std::shared_ptr<const Primitive> primitive;
    std::size_t material = 0;
    glm::dmat4 batchFromMesh{1.0};                       ///< not used by a skinned piece
    std::shared_ptr<const std::vector<glm::dmat4>> skin; ///< null: not skinned
    int node = -1;                                       ///< for messages
};

/// The pieces of each batch, by the node that moves it; -1, the static one, comes first.
using PiecesByMover = std::map<int, std::vector<Piece>>;

std::vector<double> morphWeights(const GltfDocument& document, const tinygltf::Node& node) {
    return node.weights.empty() ? document.model->meshes[node.mesh].weights : node.weights;
}

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

  private:
    const GltfDocument& document_;
    MemoryBudget& memory_;
    std::uint64_t triangles_ = 0;
};

PiecesByMover gatherPieces(const GltfDocument& document, const NodeWalk& walk,
                           const std::optional<std::size_t>& variant, Scene& scene) {
    MemoryBudget memory = document.memory;
    PieceCounter counter(document, memory);
    PiecesByMover pieces;
    std::map<int, std::shared_ptr<const std::vector<glm::dmat4>>> skins;
    std::map<std::pair<int, std::vector<double>>, std::vector<std::shared_ptr<Primitive>>> read;
    for (const PlacedNode& visit : walk.nodes) {
        const tinygltf::Node& node = document.model->nodes[visit.node];
        if (node.mesh < 0 || !visit.visible) continue;
        if (static_cast<std::size_t>(node.mesh) >= document.model->meshes.size())
            throw InputError(document.where("nodes[") + std::to_string(visit.node) + "].mesh is " +
                             std::to_string(node.mesh) + ", but there are " +
                             std::to_string(document.model->meshes.size()) + " meshes.");
        const auto weights = morphWeights(document, node);
        auto& primitives = read[{node.mesh, weights}];
        const auto& sources = document.model->meshes[node.mesh].primitives;
        for (std::size_t p = primitives.size(); p < sources.size(); ++p) {
            const int material = materialInVariant(document, static_cast<std::size_t>(node.mesh), p,
                                                   variant, scene.warnings);
            const bool known =
                material >= 0 && static_cast<std::size_t>(material) < scene.materials.size();
            primitives.push_back(std::make_shared<Primitive>(readPrimitive(
                document, static_cast<std::size_t>(node.mesh), p, weights,
                known ? scene.materials[material] : Material(), scene.warnings, memory)));
            primitives.back()->material = material;
        }

        std::shared_ptr<const std::vector<glm::dmat4>> skin;
        if (node.skin >= 0) {
            scene.warnings.add("Skinned meshes are taken at their rest pose.");
            auto& known = skins[node.skin];
            if (!known)
                known = std::make_shared<const std::vector<glm::dmat4>>(
                    skinMatrices(document, node.skin, walk.worldFromNode, memory));
            skin = known;
        }
        const auto isSkinned = [&skin](const Primitive& primitive) {
            return skin && !primitive.joints.empty();
        };
        const std::size_t count = instanceCount(document, visit.node);
        for (const auto& primitive : primitives)
            counter.count(*primitive, visit.node, isSkinned(*primitive) ? 1 : count);
        const std::vector<glm::dmat4> instances = readInstances(document, visit.node, memory);
        for (const auto& primitive : primitives) {
            if (primitive->indices.empty()) continue;
            const bool skinned = isSkinned(*primitive);
            Piece piece = {primitive, materialOf(document, *primitive, scene.materials),
                           visit.place.animatedFromNode, skinned ? skin : nullptr, visit.node};
            // A skin's joints place it in the world; its own node's transforms do not count.
            if (skinned) {
                pieces[-1].push_back(std::move(piece));
                continue;
            }
            for (const glm::dmat4& nodeFromInstance : instances) {
                piece.batchFromMesh = visit.place.animatedFromNode * nodeFromInstance;
                pieces[visit.place.animatedNode].push_back(piece);
            }
        }
    }
    return pieces;
}

glm::dmat4 matrixOf(const GltfDocument& document, const Piece& piece, std::size_t vertex) {
    return piece.skin ? skinMatrixOf(*piece.primitive, vertex, *piece.skin, document)
                      : piece.batchFromMesh;
}

glm::dvec3 transformed(const glm::dmat4& matrix, const glm::vec3& point) {
    return glm::dvec3(matrix * glm::dvec4(point, 1.0));
}

/// The local origin: 0 where the geometry lies around it anyway, else the middle of its box.
glm::dvec3 localOrigin(const GltfDocument& document, const std::vector<Piece>& pieces) {
    Box box;
    for (const Piece& piece : pieces)
        for (std::size_t v = 0; v < piece.primitive->positions.size(); ++v)
            box.add(transformed(matrixOf(document, piece, v), piece.primitive->positions[v]));
    const glm::dvec3 center = box.center();
    const double distance = std::max({std::abs(center.x), std::abs(center.y), std::abs(center.z)});
    return distance > 2.0 * box.diagonal() ? center : glm::dvec3(0.0);
}

/// Transforms normals, also for mirrored and singular matrices: the cofactors are the inverse
/// transpose times the determinant.
glm::vec3 transformedNormal(const glm::dmat3& matrix, const glm::vec3& normal) {
    const glm::dmat3 cofactors(glm::cross(matrix[1], matrix[2]), glm::cross(matrix[2], matrix[0]),
                               glm::cross(matrix[0], matrix[1]));
    const double sign = glm::determinant(matrix) < 0.0 ? -1.0 : 1.0;
    const glm::dvec3 result = sign * (cofactors * glm::dvec3(normal));
    const double length = glm::length(result);
    const bool hasDirection = length > 0.0 && std::isfinite(length);
    return hasDirection ? glm::vec3(result / length) : glm::vec3(0.0f);
}

glm::vec3 faceNormal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    return length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f);
}

/// Appends a piece's vertices and triangles to the batch.
class PieceAppender {
  public:
    PieceAppender(const GltfDocument& document, const glm::dvec3& origin, const Material& material,
                  Batch& batch)
        : document_(document), origin_(origin), material_(material), batch_(batch) {}

    void append(const Piece& piece) {
        const Primitive& primitive = *piece.primitive;
        const bool mirrored = glm::determinant(glm::dmat3(matrixOf(document_, piece, 0))) < 0.0;
        if (batch_.positions.size() + primitive.indices.size() > 0xFFFFFFF0u)
            throw InputError("'" + document_.path.string() + "' has too many vertices.");
        if (primitive.normals.empty())
            appendFlat(piece, mirrored);
        else
            appendShared(piece, mirrored);
    }

  private:
    void appendShared(const Piece& piece, bool mirrored) {
        const auto base = static_cast<std::uint32_t>(batch_.positions.size());
        for (std::size_t v = 0; v < piece.primitive->positions.size(); ++v) {
            const glm::dmat4 matrix = matrixOf(document_, piece, v);
            appendVertex(piece, v, position(piece, v, matrix),
                         transformedNormal(glm::dmat3(matrix), piece.primitive->normals[v]));
        }
        const auto& indices = piece.primitive->indices;
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            batch_.indices.push_back(base + indices[i]);
            batch_.indices.push_back(base + indices[i + (mirrored ? 2 : 1)]);
            batch_.indices.push_back(base + indices[i + (mirrored ? 1 : 2)]);
        }
    }

    /// Without normals every triangle is flat (glTF 2.0, 3.7.2.1), so it needs its own vertices.
    void appendFlat(const Piece& piece, bool mirrored) {
        const auto& indices = piece.primitive->indices;
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            const std::uint32_t corners[3] = {indices[i], indices[i + (mirrored ? 2 : 1)],
                                              indices[i + (mirrored ? 1 : 2)]};
            glm::vec3 points[3];
            for (int c = 0; c < 3; ++c)
                points[c] = position(piece, corners[c], matrixOf(document_, piece, corners[c]));
            const glm::vec3 normal = faceNormal(points[0], points[1], points[2]);
            for (int c = 0; c < 3; ++c) {
                batch_.indices.push_back(static_cast<std::uint32_t>(batch_.positions.size()));
                appendVertex(piece, corners[c], points[c], normal);
            }
        }
    }

    glm::vec3 position(const Piece& piece, std::size_t vertex, const glm::dmat4& matrix) const {
        const glm::dvec3 exact = transformed(matrix, piece.primitive->positions[vertex]) - origin_;
        const glm::vec3 rounded(exact);
        if (!std::isfinite(rounded.x) || !std::isfinite(rounded.y) || !std::isfinite(rounded.z))
            throw InputError(document_.where("nodes[") + std::to_string(piece.node) +
                             "] moves vertices out of the range of floats.");
        return rounded + 0.0f; // -0 becomes +0
    }

    void appendVertex(const Piece& piece, std::size_t vertex, const glm::vec3& point,
                      const glm::vec3& normal) {
        const Primitive& primitive = *piece.primitive;
        batch_.positions.push_back(point);
        batch_.normals.push_back(normal);
        batch_.texcoords.push_back(texcoord(primitive, vertex, 0));
        for (int channel = 1; channel < material_.texcoordChannels; ++channel)
            put(batch_.moreTexcoords[channel - 1], texcoord(primitive, vertex, channel));
        if (!primitive.tangents.empty()) put(batch_.tangents, tangent(piece, vertex));
        batch_.colors.push_back(primitive.colors.empty() ? glm::vec4(1.0f)
                                                         : primitive.colors[vertex]);
    }

    glm::vec2 texcoord(const Primitive& primitive, std::size_t vertex, int channel) const {
        const auto& given = primitive.texcoords[channel];
        const glm::vec2 uv = given.empty() ? glm::vec2(0.0f) : given[vertex];
        return material_.channels[channel].transform * glm::vec3(uv, 1.0f);
    }

    /// Where a mirror turns triangles over, bitangents turn with them.
    glm::vec4 tangent(const Piece& piece, std::size_t vertex) const {
        const glm::vec4& given = piece.primitive->tangents[vertex];
        const glm::dmat3 matrix(matrixOf(document_, piece, vertex));
        const glm::dvec3 along = matrix * glm::dvec3(given);
        const double length = glm::length(along);
        if (!(length > 0.0) || !std::isfinite(length)) return glm::vec4(0.0f);
        const float sign = glm::determinant(matrix) < 0.0 ? -given.w : given.w;
        return {glm::vec3(along / length), sign < 0.0f ? -1.0f : 1.0f};
    }

    /// As that of the vertex last added; what came before it has none.
    template <class T>
    void put(std::vector<T>& values, const T& value) {
        values.resize(batch_.positions.size() - 1);
        values.push_back(value);
    }

    const GltfDocument& document_;
    const glm::dvec3 origin_;
    const Material& material_;
    Batch& batch_;
};

Batch makeBatch(const GltfDocument& document, int animatedNode, const glm::dmat4& worldFromAnimated,
                std::vector<Piece> pieces, const std::vector<Material>& materials) {
    std::stable_sort(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
        return std::pair(materials[a.material].alphaMode, a.material) <
               std::pair(materials[b.material].alphaMode, b.material);
    });
    const glm::dvec3 origin = localOrigin(document, pieces);
    Batch batch;
    batch.node = animatedNode;
    batch.worldFromBatch = glm::translate(worldFromAnimated, origin);
    batch.origin = origin;
    for (const Piece& piece : pieces) {
        if (batch.groups.empty() || batch.groups.back().material != piece.material)
            batch.groups.push_back(
                {piece.material, static_cast<std::uint32_t>(batch.indices.size()), 0});
        PieceAppender(document, origin, materials[piece.material], batch).append(piece);
        SurfaceGroup& group = batch.groups.back();
        group.indexCount = static_cast<std::uint32_t>(batch.indices.size()) - group.firstIndex;
    }
    for (auto& texcoords : batch.moreTexcoords)
        if (!texcoords.empty()) texcoords.resize(batch.positions.size());
    if (!batch.tangents.empty()) batch.tangents.resize(batch.positions.size());
    return batch;
}

} // namespace

Scene flattenScene(const GltfDocument& document, double weldTolerance, const Looks& looks) {
    Scene scene;
    scene.warnings = document.warnings;
    scene.materials = readMaterials(document, scene.warnings);
    if (looks.shading == Shading::base)
        std::for_each(scene.materials.begin(), scene.materials.end(), keepBase);
    const NodeWalk walk = walkNodes(document, scene.warnings);
    scene.animatedNodes = walk.animatedNodes;
    scene.cameras = readCameras(document, walk, scene.warnings);
    scene.lights = readLights(document, walk, scene.warnings);
    PiecesByMover piecesByAnimatedNode =
        gatherPieces(document, walk, findVariant(document, looks.variant, scene.warnings), scene);
    for (auto& [animatedNode, pieces] : piecesByAnimatedNode) {
        const glm::dmat4 worldFromAnimated =
            animatedNode < 0 ? glm::dmat4(1.0) : walk.worldFromNode[animatedNode];
        scene.batches.push_back(makeBatch(document, animatedNode, worldFromAnimated,
                                          std::move(pieces), scene.materials));
        if (weldTolerance > 0.0) snapPositions(scene.batches.back().positions, weldTolerance);
    }
    return scene;
}

} // namespace edgeshade
