#include "preprocess/reading/flatten.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/longest_axis.hpp"
#include "preprocess/base/vectors.hpp"
#include "preprocess/mesh/weld.hpp"
#include "preprocess/reading/camera_reading.hpp"
#include "preprocess/reading/light_reading.hpp"
#include "preprocess/reading/material_reading.hpp"
#include "preprocess/reading/pieces.hpp"
#include "preprocess/reading/variants.hpp"
#include "preprocess/scene/animation.hpp"
#include "preprocess/scene/posing.hpp"
#include "preprocess/scene/vertex_transform.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace edgeshade {
namespace {

glm::dvec3 transformed(const glm::dmat4& matrix, const glm::vec3& point) {
    return glm::dvec3(matrix * glm::dvec4(point, 1.0));
}

/// The local origin: 0 if the geometry surrounds it anyway, otherwise the middle of its box.
/// Geometry that joints scale to zero at rest counts at the size of its mesh.
glm::dvec3 localOrigin(const std::vector<Piece>& pieces) {
    Box box, ofMeshes;
    for (const Piece& piece : pieces)
        for (std::size_t v = 0; v < piece.primitive->positions.size(); ++v) {
            box.add(transformed(matrixOf(piece, v), piece.primitive->positions[v]));
            ofMeshes.add(glm::dvec3(piece.primitive->positions[v]));
        }
    const double diagonal = box.diagonal() > 0.0 ? box.diagonal() : ofMeshes.diagonal();
    const glm::dvec3 center = box.center();
    const double distance = largestComponent(center);
    return distance > 2.0 * diagonal ? center : glm::dvec3(0.0);
}

/// Appends a piece's vertices and triangles to the batch.
class PieceAppender {
  public:
    PieceAppender(const GltfDocument& document, const glm::dvec3& origin, const Material& material,
                  Geometry& geometry)
        : document_(document), origin_(origin), material_(material), geometry_(geometry) {}

    /// Appends the piece. Where triangles get their own vertices, returns the primitive's vertex
    /// for each new one. Otherwise the vertices are the primitive's, and it returns nothing.
    std::vector<std::uint32_t> append(const Piece& piece) {
        const Primitive& primitive = *piece.primitive;
        const bool mirrored =
            piece.skin ? piece.turnedOver : glm::determinant(glm::dmat3(piece.batchFromMesh)) < 0.0;
        if (geometry_.positions.size() + primitive.indices.size() > 0xFFFFFFF0u)
            throw InputError("'" + document_.path.string() + "' has too many vertices.");
        if (primitive.normals.empty()) return appendFlat(piece, mirrored);
        appendShared(piece, mirrored);
        return {};
    }

  private:
    void appendShared(const Piece& piece, bool mirrored) {
        const auto base = static_cast<std::uint32_t>(geometry_.positions.size());
        for (std::size_t v = 0; v < piece.primitive->positions.size(); ++v) {
            const glm::dmat4 matrix = matrixOf(piece, v);
            appendVertex(
                piece, v, position(piece, v, matrix),
                transformedNormal(glm::dmat3(matrix), glm::dvec3(piece.primitive->normals[v])));
        }
        const auto& indices = piece.primitive->indices;
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            geometry_.indices.push_back(base + indices[i]);
            geometry_.indices.push_back(base + indices[i + (mirrored ? 2 : 1)]);
            geometry_.indices.push_back(base + indices[i + (mirrored ? 1 : 2)]);
        }
    }

    /// Without normals every triangle is flat (glTF 2.0, 3.7.2.1), and needs its own vertices.
    std::vector<std::uint32_t> appendFlat(const Piece& piece, bool mirrored) {
        std::vector<std::uint32_t> sources;
        const auto& indices = piece.primitive->indices;
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            const std::uint32_t corners[3] = {indices[i], indices[i + (mirrored ? 2 : 1)],
                                              indices[i + (mirrored ? 1 : 2)]};
            glm::vec3 points[3];
            for (int c = 0; c < 3; ++c)
                points[c] = position(piece, corners[c], matrixOf(piece, corners[c]));
            const glm::vec3 normal = faceNormal(points[0], points[1], points[2]);
            for (int c = 0; c < 3; ++c) {
                geometry_.indices.push_back(static_cast<std::uint32_t>(geometry_.positions.size()));
                appendVertex(piece, corners[c], points[c], normal);
                sources.push_back(corners[c]);
            }
        }
        return sources;
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
        geometry_.positions.push_back(point);
        geometry_.normals.push_back(normal);
        geometry_.texcoords.push_back(texcoord(primitive, vertex, 0));
        for (int channel = 1; channel < material_.texcoordChannels; ++channel)
            put(geometry_.moreTexcoords[channel - 1], texcoord(primitive, vertex, channel));
        if (!primitive.tangents.empty()) {
            const glm::vec4& tangent = primitive.tangents[vertex];
            put(geometry_.tangents, transformedTangent(glm::dmat3(matrixOf(piece, vertex)),
                                                       glm::dvec3(tangent), tangent.w));
        }
        geometry_.colors.push_back(primitive.colors.empty() ? glm::vec4(1.0f)
                                                            : primitive.colors[vertex]);
    }

    glm::vec2 texcoord(const Primitive& primitive, std::size_t vertex, int channel) const {
        const auto& given = primitive.texcoords[channel];
        const glm::vec2 uv = given.empty() ? glm::vec2(0.0f) : given[vertex];
        return material_.channels[channel].transform * glm::vec3(uv, 1.0f);
    }

    /// Sets the value of the last vertex; earlier vertices without one get a default.
    template <class T>
    void put(std::vector<T>& values, const T& value) {
        values.resize(geometry_.positions.size() - 1);
        values.push_back(value);
    }

    const GltfDocument& document_;
    const glm::dvec3 origin_;
    const Material& material_;
    Geometry& geometry_;
};

/// Collects the data that pose a batch.
class DeformationBuilder {
  public:
    /// `corners`: the result of PieceAppender::append().
    void add(const Piece& piece, std::size_t firstVertex, std::vector<std::uint32_t> corners) {
        const Primitive& primitive = *piece.primitive;
        const auto [known, isNew] = meshOf_.try_emplace(&primitive, made_.meshes.size());
        if (isNew)
            made_.meshes.push_back({primitive.positions, primitive.normals, primitive.tangents,
                                    primitive.targets,
                                    piece.skin ? primitive.influences : Influences()});
        if (piece.skin) {
            made_.joints = piece.skin->joints;
            made_.place = piece.place;
        }
        made_.parts.push_back({known->second, piece.batchFromMesh, piece.node, piece.restWeights,
                               static_cast<std::uint32_t>(firstVertex), std::move(corners)});
    }

    /// `origin`: the batch's.
    std::shared_ptr<const Deformation> built(const glm::dvec3& origin) {
        for (DeformedPart& part : made_.parts)
            part.batchFromMesh = glm::translate(glm::dmat4(1.0), -origin) * part.batchFromMesh;
        return std::make_shared<const Deformation>(std::move(made_));
    }

  private:
    Deformation made_;
    std::map<const Primitive*, std::size_t> meshOf_;
};

void sortByMaterial(std::vector<Piece>& pieces, const std::vector<Material>& materials) {
    std::stable_sort(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
        return std::pair(materials[a.material].alphaMode, a.material) <
               std::pair(materials[b.material].alphaMode, b.material);
    });
}

/// `pieces`: sorted by material. `deformation`: collects every piece if the batch deforms, else
/// null.
Geometry geometryOf(const GltfDocument& document, const std::vector<Piece>& pieces,
                    const glm::dvec3& origin, const std::vector<Material>& materials,
                    DeformationBuilder* deformation) {
    Geometry geometry;
    for (const Piece& piece : pieces) {
        if (geometry.groups.empty() || geometry.groups.back().material != piece.material)
            geometry.groups.push_back(
                {piece.material, static_cast<std::uint32_t>(geometry.indices.size()), 0});
        addSource(geometry, piece.node);
        const std::size_t firstVertex = geometry.positions.size();
        std::vector<std::uint32_t> corners =
            PieceAppender(document, origin, materials[piece.material], geometry).append(piece);
        if (deformation) deformation->add(piece, firstVertex, std::move(corners));
        SurfaceGroup& group = geometry.groups.back();
        group.indexCount = static_cast<std::uint32_t>(geometry.indices.size()) - group.firstIndex;
    }
    for (auto& texcoords : geometry.moreTexcoords)
        if (!texcoords.empty()) texcoords.resize(geometry.positions.size());
    if (!geometry.tangents.empty()) geometry.tangents.resize(geometry.positions.size());
    return geometry;
}

Batch makeBatch(const GltfDocument& document, const Mover& mover,
                const glm::dmat4& worldFromAnimated, std::vector<Piece> pieces,
                double weldTolerance, const std::vector<Material>& materials) {
    sortByMaterial(pieces, materials);
    const glm::dvec3 origin = localOrigin(pieces);
    Batch batch;
    batch.node = mover.animatedNode;
    batch.nodeFromBatch = glm::translate(glm::dmat4(1.0), origin);
    batch.worldFromBatch = worldFromAnimated * batch.nodeFromBatch;
    DeformationBuilder deformation;
    Geometry geometry =
        geometryOf(document, pieces, origin, materials, mover.deforms ? &deformation : nullptr);
    if (weldTolerance > 0.0 && !mover.deforms) snapPositions(geometry.positions, weldTolerance);
    batch.geometry = CopyOnWrite(std::move(geometry));
    if (mover.deforms) batch.deformation = deformation.built(origin);
    return batch;
}

/// Appends one batch for each place.
void appendShared(const GltfDocument& document, const NodeWalk& walk, SharedMesh mesh,
                  double weldTolerance, Scene& scene) {
    sortByMaterial(mesh.pieces, scene.materials);
    const glm::dvec3 origin = localOrigin(mesh.pieces);
    Geometry geometry = geometryOf(document, mesh.pieces, origin, scene.materials, nullptr);
    geometry.sources.clear(); // each place has its own node
    double scale = 0.0;
    for (const NodePlace& place : mesh.places)
        scale = std::max(scale, longestAxis(place.animatedFromNode));
    if (weldTolerance > 0.0 && scale > 0.0)
        snapPositions(geometry.positions, weldTolerance / scale);
    const CopyOnWrite<Geometry> shared(std::move(geometry));
    for (std::size_t i = 0; i < mesh.places.size(); ++i) {
        const NodePlace& place = mesh.places[i];
        Batch& batch = scene.batches.emplace_back();
        batch.placedBy = mesh.nodes[i];
        batch.node = place.animatedNode;
        batch.nodeFromBatch = glm::translate(place.animatedFromNode, origin);
        batch.worldFromBatch = place.animatedNode < 0
                                   ? batch.nodeFromBatch
                                   : walk.worldFromNode[place.animatedNode] * batch.nodeFromBatch;
        batch.geometry = shared;
    }
}

bool isFlat(const glm::dmat4& matrix) {
    return glm::determinant(glm::dmat3(matrix)) == 0.0;
}

/// Hides a batch that a node scales to zero at rest. It stays at the node's position, at its mesh's
/// size, where every query on batches works for it.
void hide(Batch& batch) {
    const glm::dvec3 place(batch.worldFromBatch[3]);
    batch.hidden = true;
    batch.worldFromBatch = glm::translate(glm::dmat4(1.0), place);
}

/// Poses deforming batches at rest like in any other pose, and hides those that vanish in it.
void poseAtRest(const GltfDocument& document, Scene& scene) {
    const Pose rest = poseAt(Animation(), scene, 0.0);
    for (std::size_t b = 0; b < scene.batches.size(); ++b) {
        Batch& batch = scene.batches[b];
        if (!rest.worldFromBatch[b])
            hide(batch);
        else if (batch.node < 0 || isFlat(batch.worldFromBatch))
            batch.worldFromBatch = *rest.worldFromBatch[b];
        // The walk of the nodes has already placed the others.
        if (batch.deforms() && !poseBatch(batch, rest.shapes[b]))
            throw InputError("'" + document.path.string() +
                             "': skins or morph targets move vertices out of the range of floats.");
    }
}

} // namespace

Scene flattenScene(const GltfDocument& document, double weldTolerance, const Looks& looks,
                   InstanceChoice instances) {
    Scene scene;
    scene.warnings = document.warnings;
    scene.materials = readMaterials(document, scene.warnings);
    if (looks.shading == Shading::base)
        std::for_each(scene.materials.begin(), scene.materials.end(), keepBase);
    const NodeWalk walk = walkNodes(document);
    scene.animatedNodes = walk.animatedNodes;
    scene.cameras = readCameras(document, walk, scene.warnings);
    scene.lights = readLights(document, walk, scene.warnings);
    GatheredPieces gathered = gatherPieces(
        document, walk, findVariant(document, looks.variant, scene.warnings), instances, scene);
    for (auto& [mover, pieces] : gathered.byMover) {
        const glm::dmat4 worldFromAnimated =
            mover.animatedNode < 0 ? glm::dmat4(1.0) : walk.worldFromNode[mover.animatedNode];
        scene.batches.push_back(makeBatch(document, mover, worldFromAnimated, std::move(pieces),
                                          weldTolerance, scene.materials));
    }
    for (SharedMesh& mesh : gathered.shared)
        appendShared(document, walk, std::move(mesh), weldTolerance, scene);
    poseAtRest(document, scene);
    return scene;
}

} // namespace edgeshade
